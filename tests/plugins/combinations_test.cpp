/// Terms, occlusions and transparencies in any combination: no GL message, no problem, no value that is not finite.
/// Pairwise in the quick tests; Complete, all combinations of five kinds, is a test of its own label.
#include <array>
#include <cmath>
#include <set>

#include <epoxy/gl.h>
#include <lumen/testing.h>

#include "plugins/installed_types.h"

namespace {

using lumen::Kind;
using lumen::testing::Pixels;
using lumen::testing::Scene;

constexpr std::array kinds = {Kind::diffuse, Kind::specular, Kind::ambient, Kind::occlusion, Kind::transparency, Kind::opacity};
using Choice = std::array<int, kinds.size()>;  ///< which type of each kind

/// A transparent ball in front of an opaque one and a floor, with an instance of every type of these kinds.
class Combinations : public testing::Test {
 protected:
  Combinations() {
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
      types_[kind] = lumenshop::installed_types(kinds[kind]);
      for (std::size_t i = 0; i < types_[kind].size(); ++i) scene_.add(types_[kind][i], id(kind, int(i)));
    }
    const auto ball = lumen::testing::sphere(32, 0.5f);
    scene_.surface("floor", lumen::testing::moved(*lumen::testing::rectangle(), {0, 0, -0.6f}), R"({"specular_color": [0.4, 0.4, 0.4]})");
    scene_.surface("solid", lumen::testing::moved(*ball, {-0.4f, 0, 0}), R"({"specular_color": [0.4, 0.4, 0.4]})");
    scene_.give("shape", lumen::testing::moved(*ball, {0.3f, 0.1f, 0.4f}));
    scene_.add("filter.curvature", "bent", R"({"mesh": {"link": "shape.mesh"}})");
    scene_.add("renderer.surface", "clear", R"({"mesh": {"link": "bent.result"}, "specular_color": [0.4, 0.4, 0.4]})");
    // The fewest samples that still run every pass of a technique.
    for (std::size_t i = 0; i < types_[3].size(); ++i)
      for (const char* property : {"refinements", "samples", "slices", "rays", "depths"}) lower(id(3, int(i)) + "." + property);
    scene_.picture();  // the GL is current from now on
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(take_message, this);
  }
  ~Combinations() override { glDebugMessageCallback(nullptr, nullptr); }

  std::size_t count(std::size_t kind) const { return types_[kind].size(); }

  void expect_sound(const Choice& choice) {
    std::string names;
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
      const auto chosen = id(kind, choice[kind]);
      names += " " + types_[kind][std::size_t(choice[kind])];
      const std::string property(lumen::name_of(kinds[kind]));
      if (kinds[kind] == Kind::occlusion || kinds[kind] == Kind::transparency) scene_.set("main." + property, chosen);
      else
        for (const char* surface : {"floor", "solid", "clear"})
          if (kinds[kind] != Kind::opacity || std::string_view(surface) == "clear") scene_.set(surface + ("." + property), chosen);
    }
    const Pixels color = scene_.layer("color");
    for (const float value : color.image().pixels)
      if (!std::isfinite(value)) {
        ADD_FAILURE() << "a pixel is not finite:" << names;
        break;
      }
    EXPECT_EQ(color.rgba(16, 16).a, 1) << "the floor is not there:" << names;
    for (const lumen::Problem& problem : scene_.problems()) ADD_FAILURE() << problem.message << ":" << names;
    EXPECT_EQ(messages_, "") << names;
    messages_.clear();
  }

 private:
  std::string id(std::size_t kind, int index) const { return std::string(lumen::name_of(kinds[kind])) + std::to_string(index); }
  void lower(const std::string& property) {
    try {
      scene_.set(property, "2");
    } catch (const lumen::Error&) {
      // This technique has no such property.
    }
  }
  static void take_message(GLenum, GLenum type, GLuint, GLenum, GLsizei length, const GLchar* text, const void* self) {
    if (type != GL_DEBUG_TYPE_ERROR && type != GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR && type != GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR) return;
    static_cast<Combinations*>(const_cast<void*>(self))->messages_ += std::string(text, std::size_t(length)) + "\n";
  }

  Scene scene_{{32, 32}};
  std::array<std::vector<std::string>, kinds.size()> types_;
  std::string messages_;
};

TEST_F(Combinations, Pairwise) {
  using Pair = std::array<int, 4>;  // kind, type, kind, type
  std::set<Pair> open;
  for (int a = 0; a < int(kinds.size()); ++a)
    for (int b = a + 1; b < int(kinds.size()); ++b)
      for (int i = 0; i < int(count(std::size_t(a))); ++i)
        for (int j = 0; j < int(count(std::size_t(b))); ++j) open.insert({a, i, b, j});
  while (!open.empty()) {
    // The first open pair, then of each other kind the type that closes the most pairs with what is chosen.
    Choice choice;
    choice.fill(-1);
    const Pair first = *open.begin();
    choice[std::size_t(first[0])] = first[1];
    choice[std::size_t(first[2])] = first[3];
    const auto gain = [&](int kind, int type) {
      int pairs = 0;
      for (int other = 0; other < int(kinds.size()); ++other) {
        const int chosen = choice[std::size_t(other)];
        if (other == kind || chosen < 0) continue;
        pairs += int(open.count(other < kind ? Pair{other, chosen, kind, type} : Pair{kind, type, other, chosen}));
      }
      return pairs;
    };
    for (int kind = 0; kind < int(kinds.size()); ++kind) {
      if (choice[std::size_t(kind)] >= 0) continue;
      int best = 0;
      for (int type = 1; type < int(count(std::size_t(kind))); ++type)
        if (gain(kind, type) > gain(kind, best)) best = type;
      choice[std::size_t(kind)] = best;
    }
    expect_sound(choice);
    std::erase_if(open, [&](const Pair& pair) { return choice[std::size_t(pair[0])] == pair[1] && choice[std::size_t(pair[2])] == pair[3]; });
  }
}

class Complete : public Combinations {};

TEST_F(Complete, AllDiffuseSpecularAmbientOcclusionTransparency) {
  Choice choice{};
  for (;;) {
    choice.back() = (choice[0] + choice[1] + choice[2] + choice[3] + choice[4]) % int(count(5));  // the opacities take turns
    expect_sound(choice);
    std::size_t kind = 0;
    while (kind < 5 && ++choice[kind] == int(count(kind))) choice[kind++] = 0;
    if (kind == 5) break;
  }
}

}  // namespace
