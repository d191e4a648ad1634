/// Two views of one splitter: what one value must serve both for is found in the one that leads, and both come to rest.

#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "frame/headless.h"
#include "workshop.h"

namespace {

using namespace lumenshop;

/// A ball within a shell, seen along z and along x; the volume opens the shell before the ball.
constexpr const char* session_text = R"({ "lumenshop": 1,
  "plugins": {
    "ball": {"type": "importer.shape", "detail": 24}, "shell": {"type": "importer.shape", "detail": 24},
    "inner": {"type": "renderer.surface", "mesh": {"link": "ball.mesh"}, "transform": [0.3, 0, 0, 0, 0, 0.3, 0, 0, 0, 0, 0.3, 0, 0, 0, 0, 1]},
    "outer": {"type": "renderer.surface", "mesh": {"link": "shell.mesh"}, "splitter": ["hole"]},
    "hole": {"type": "splitter.volume", "place": "by_interest", "interest": ["inner"]},
    "ahead": {"type": "interactor.orbit", "rotation": [0, 0, 0, 1]}, "aside": {"type": "interactor.orbit", "rotation": [0, 0.7071068, 0, 0.7071068]},
    "front": {"type": "interactor.light"} },
  "views": {
    "a": {"camera": "ahead", "lights": ["front"], "renderers": ["outer", "inner"], "antialiasing": 1},
    "b": {"camera": "aside", "lights": ["front"], "renderers": ["outer", "inner"], "antialiasing": 1}} }
)";

struct Views {
  Workshop workshop;
  HeadlessContext context;
  explicit Views(const char* text) {
    workshop.session().load(Json::parse(text), std::filesystem::temp_directory_path());
    workshop.scheduler().wait();
  }
  ~Views() { workshop.close_views(); }

  /// Rounds of both until neither has anything to draw; `most` if they never come to rest.
  int rounds(int most) {
    for (int round = 0; round < most; ++round) {
      bool drawn = false;
      for (const char* id : {"a", "b"}) {
        workshop.view(id).resize({64, 64});
        drawn = workshop.view(id).draw() || drawn;
      }
      if (!drawn) return round;
    }
    return most;
  }
  glm::vec3 center() { return std::get<glm::vec3>(workshop.session().find("hole")->read(workshop.session().find("hole")->slot_of("center"))); }
};

TEST(TwoViews, OfAVolumePlacedByInterestComeToRestAndTheFirstLeads) {
  Views views(session_text);
  EXPECT_LT(views.rounds(40), 40);
  const glm::vec3 led = views.center();
  EXPECT_GT(led.z, 0.2f) << "before the ball, as the first view sees it";
  EXPECT_NEAR(led.x, 0, 0.2f);
  // The second view turns: nothing moves. The first one turns: the volume follows.
  views.workshop.session().set("aside.rotation", Json{1, 0, 0, 0});
  EXPECT_LT(views.rounds(40), 40);
  EXPECT_EQ(views.center(), led);
  views.workshop.session().set("ahead.rotation", Json{0, 1, 0, 0});
  EXPECT_LT(views.rounds(40), 40);
  EXPECT_LT(views.center().z, -0.2f);
}

TEST(TwoViews, WhatWasSetByHandIsPlacedAgainOnceItIsNot) {
  Views views(session_text);
  views.rounds(40);
  const glm::vec3 placed = views.center();
  views.workshop.session().set("hole.center", Json{0.1, 0.2, 1.0});
  views.rounds(40);
  EXPECT_EQ(views.center(), glm::vec3(0.1f, 0.2f, 1.0f));
  views.workshop.session().reset("hole.center");
  EXPECT_LT(views.rounds(40), 40);
  EXPECT_EQ(views.center(), placed);
}

TEST(TwoViews, TheSecondLeadsOnceTheFirstIsGone) {
  Views views(session_text);
  views.rounds(40);
  views.workshop.session().set("a.renderers", Json::array({"inner"}));
  views.rounds(40);
  views.workshop.session().set("aside.rotation", Json{0, 0.7071068, 0, -0.7071068});
  EXPECT_LT(views.rounds(40), 40);
  EXPECT_GT(std::abs(views.center().x), 0.2f);
  EXPECT_NEAR(views.center().z, 0, 0.2f);
}

}  // namespace
