/// Reloads: what a person set survives every new library, and a bad one changes nothing.
#include "reload/reload_scene.h"

#include <fstream>

namespace lumenshop::tests {
namespace {

class Reload : public ReloadScene {
 protected:
  Reloader reloader{registry, session, frame, {folder / "shaders", {}, false}};

  std::string reload(const std::string& variant) {
    put(variant);
    std::string reason = reloader.reload(library);
    session.update();
    return reason;
  }
  void expect_untouched() const {
    EXPECT_EQ(strength("changed"), 0.25f);
    EXPECT_EQ(strength("untouched"), 0.5f);
    EXPECT_EQ(strength("linked"), 0.25f);
    EXPECT_EQ(std::get<int>(value("changed", "steps")), 5);
    EXPECT_EQ(registry.generation("ambient.subject"), 1);
    EXPECT_EQ(session.find("changed")->generation(), 1);
  }
};

TEST_F(Reload, KeepsValuesAndLinksAndFollowsNewDefaults) {
  EXPECT_EQ(reload("second"), "");
  EXPECT_EQ(strength("changed"), 0.25f);
  EXPECT_EQ(strength("untouched"), 0.75f) << "nobody set it: the new default holds";
  EXPECT_EQ(strength("linked"), 0.25f);
  session.set("changed.strength", Json(0.125));
  session.update();
  EXPECT_EQ(strength("linked"), 0.125f) << "the link still lives";
  EXPECT_EQ(std::get<float>(value("untouched", "extra")), 2.0f);
  EXPECT_EQ(session.find("changed")->generation(), 2);
  EXPECT_EQ(registry.generation("ambient.subject"), 2);
  EXPECT_EQ(reloader.state("ambient.subject"), BuildState::loaded);
}

TEST_F(Reload, KeepsWhatIsNoLongerDeclaredUntilItReturns) {
  ASSERT_EQ(reload("second"), "");
  EXPECT_EQ(session.find("changed")->slot_of("steps"), -1);
  EXPECT_EQ(session.find("changed")->orphans().at("steps"), 5);
  EXPECT_EQ(session.to_json().at("plugins").at("changed").at("steps"), 5);
  ASSERT_EQ(reload("first"), "");
  EXPECT_EQ(std::get<int>(value("changed", "steps")), 5);
  EXPECT_FALSE(session.find("changed")->orphans().contains("steps"));
}

TEST_F(Reload, ConvertsAValueWhoseTypeChangedAndClampsToTheNewRange) {
  ASSERT_EQ(reload("retyped"), "");
  EXPECT_EQ(std::get<float>(value("changed", "steps")), 5.0f);
  EXPECT_EQ(strength("changed"), 0.2f);
}

TEST_F(Reload, GoesOnWithTheOldOneWhenTheNewOneFails) {
  for (const auto& [variant, reason] : std::map<std::string, std::string>{{"throws", "it does not want to"},
                                                                          {"crashes", "crashed (signal 11, SIGSEGV) while creating ambient.subject"},
                                                                          {"other_abi", "built for another SDK"},
                                                                          {"moody", "not for this one"},
                                                                          {"unclean", "a picture with NaN"}}) {
    const std::string message = reload(variant);
    EXPECT_NE(message.find(reason), std::string::npos) << variant << ": " << message;
    expect_untouched();
    EXPECT_EQ(reloader.state("ambient.subject"), BuildState::kept);
    ASSERT_EQ(reloader.problems().size(), 1u) << variant;
    EXPECT_EQ(reloader.problems()[0].file, library.string());
    EXPECT_NE(reloader.problems()[0].message.find("generation 1 kept: "), std::string::npos);
  }
  EXPECT_EQ(reload("second"), "");
  EXPECT_TRUE(reloader.problems().empty()) << "mended";
  EXPECT_EQ(registry.generation("ambient.subject"), 2);
}

TEST_F(Reload, DoesNotBlameALibraryForAFrameThatWasUncleanBefore) {
  frame.always = "another plugin's picture has NaN";
  EXPECT_EQ(reload("second"), "");
  EXPECT_EQ(strength("untouched"), 0.75f);
}

TEST_F(Reload, KeepsTheGenerationThatHasATypeWhichWent) {
  ASSERT_EQ(reload("pair"), "");
  EXPECT_TRUE(registry.has("ambient.second"));
  ASSERT_EQ(reload("without"), "");
  EXPECT_EQ(registry.generation("ambient.subject"), 2);
  EXPECT_EQ(registry.generation("ambient.second"), 3);
  EXPECT_EQ(strength("changed"), 0.25f);
  ASSERT_EQ(registry.problems().size(), 1u);
  EXPECT_NE(registry.problems()[0].message.find("the type ambient.subject is gone; generation 2"), std::string::npos) << registry.problems()[0].message;
  ASSERT_EQ(reload("pair"), "");
  EXPECT_TRUE(registry.problems().empty());
}

TEST_F(Reload, BringsAnInstanceToLifeThatWaitedForItsType) {
  session.load(Json::parse(R"({"lumenshop": 1, "plugins": {"waiting": {"type": "ambient.second", "enabled": false}}, "views": {}})"), folder);
  EXPECT_EQ(session.find("waiting")->plugin(), nullptr);
  ASSERT_EQ(reload("pair"), "");
  ASSERT_NE(session.find("waiting")->plugin(), nullptr);
  EXPECT_FALSE(session.find("waiting")->enabled());
}

TEST_F(Reload, IsTheSameAfterAHundred) {
  const Json before = session.to_json();
  for (int round = 0; round < 50; ++round) {
    ASSERT_EQ(reload("second"), "");
    ASSERT_EQ(reload("first"), "");
  }
  EXPECT_EQ(session.to_json(), before);
  EXPECT_EQ(registry.generation("ambient.subject"), 101);
  EXPECT_EQ(strength("changed"), 0.25f);
  EXPECT_EQ(strength("untouched"), 0.5f);
  std::size_t copies = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(registry.load_candidate(library)->loaded.parent_path())) copies += entry.is_regular_file();
  EXPECT_LE(copies, 2u) << "old generations leave no files";
}

TEST_F(Reload, ComesByItselfWhenTheFileIsReplaced) {
  put("second");
  const std::vector<ReloadEvent> seen = events(reloader);
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_EQ(seen[0].library, "ambient.subject");
  EXPECT_EQ(seen[0].state, BuildState::loaded);
  EXPECT_EQ(seen[0].generation, 2);
}

TEST_F(Reload, NeverTakesAFileThatIsStillBeingWritten) {
  std::ifstream source(installation.root / "tests/reload/second.so", std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(source)), {});
  for (const int percent : {0, 10, 50, 99}) {
    std::ofstream(library, std::ios::binary | std::ios::trunc) << bytes.substr(0, bytes.size() * static_cast<std::size_t>(percent) / 100);
    const std::vector<ReloadEvent> seen = events(reloader);
    ASSERT_EQ(seen.size(), 1u);
    EXPECT_EQ(seen[0].state, BuildState::kept);
    EXPECT_NE(seen[0].message.find("incomplete"), std::string::npos) << seen[0].message;
    expect_untouched();
  }
  std::ofstream(library, std::ios::binary | std::ios::trunc) << bytes;
  ASSERT_EQ(events(reloader).size(), 1u);
  EXPECT_EQ(strength("untouched"), 0.75f);
}

TEST_F(Reload, LoadsALibraryThatIsNew) {
  fs::copy_file(installation.root / "tests/reload/without.so", folder / "plugins/ambient.second.so");
  ASSERT_EQ(events(reloader).size(), 1u);
  EXPECT_TRUE(registry.has("ambient.second"));
}

TEST_F(Reload, TellsOfShadersHoweverTheyAreSaved) {
  const fs::path shader = folder / "shaders/ambient/subject.glsl";
  const auto wait = [&](std::size_t count) { return poll_until(reloader, [&] { return frame.shaders.size() >= count; }); };
  std::ofstream(shader) << "in place";
  ASSERT_TRUE(wait(1));
  EXPECT_EQ(frame.shaders, (std::vector<fs::path>{shader}));

  std::ofstream(folder / "shaders/ambient/4913~") << "an editor's own";
  std::ofstream(folder / "shaders/ambient/subject.glsl.new") << "by rename";
  fs::rename(folder / "shaders/ambient/subject.glsl.new", shader);
  ASSERT_TRUE(wait(2));
  EXPECT_EQ(frame.shaders, (std::vector<fs::path>{shader, shader}));

  fs::create_directories(folder / "shaders/diffuse/deep");
  std::ofstream(folder / "shaders/diffuse/deep/new.glsl") << "in a new folder";
  ASSERT_TRUE(wait(3));
  EXPECT_EQ(frame.shaders.back(), folder / "shaders/diffuse/deep/new.glsl");
}

TEST_F(Reload, SeesShadersAgainWhenTheirFolderWasReplaced) {
  fs::remove_all(folder / "shaders");
  reloader.poll();
  fs::create_directories(folder / "shaders/ambient");
  reloader.poll();
  std::ofstream(folder / "shaders/ambient/subject.glsl") << "back";
  EXPECT_TRUE(poll_until(reloader, [&] { return !frame.shaders.empty(); }));
}

TEST_F(Reload, IsSilentWhileNothingChanges) {
  EXPECT_TRUE(reloader.poll().empty());
  pollfd waited{reloader.descriptor(), POLLIN, 0};
  EXPECT_EQ(::poll(&waited, 1, 100), 0);
}

}  // namespace
}  // namespace lumenshop::tests
