/// Builds in the background: a source that changed is built and loaded; what does not compile is shown with its place.
#include "reload/reload_scene.h"

#include <csignal>
#include <fstream>

namespace lumenshop::tests {
namespace {

/// The "compiler" copies the library that the source names, fails with the message that it holds, or never ends.
class Build : public ReloadScene {
 protected:
  Build() {
    fs::create_directories(folder / "sources/plugins/ambient/subject");
    fs::create_directories(folder / "sources/plugins/ambient/other");
    std::ofstream(folder / "compile.sh") << "source=" << source.string() << "\n"
                                         << "case \"$(cat $source)\" in\n"
                                         << "  slow) echo $$ > " << (folder / "pid.new").string() << "; mv " << (folder / "pid.new").string() << " " << (folder / "pid").string() << "; exec sleep 100000 ;;\n"
                                         << "  *.so) cp " << (installation.root / "tests/reload").string() << "/$(cat $source) " << folder.string() << "/plugins/.new\n"
                                         << "    mv " << folder.string() << "/plugins/.new " << library.string() << " ;;\n"
                                         << "  *) cat $source >&2; exit 1 ;;\n"
                                         << "esac\n";
    const Json description{{"sources", (folder / "sources").string()}, {"build", folder.string()}, {"command", {"sh", (folder / "compile.sh").string()}}};
    std::ofstream(folder / "build.json") << description.dump();
  }

  /// The process of the compiler that never ends, once it runs.
  int sleeping_compiler() {
    int process = 0;
    poll_until(reloader(), [&] { return static_cast<bool>(std::ifstream(folder / "pid") >> process); });
    return process;
  }
  static bool is_alive(int process) { return ::kill(process, 0) == 0; }

  void write(const std::string& text) const { std::ofstream(source) << text; }

  const fs::path source = folder / "sources/plugins/ambient/subject/subject.cpp";
  Reloader& reloader() {
    if (!reloader_) reloader_ = std::make_unique<Reloader>(registry, session, frame, Reloader::Options{folder / "shaders", folder / "build.json", true});
    return *reloader_;
  }
  std::unique_ptr<Reloader> reloader_;
};

TEST_F(Build, OfAChangedSourceIsLoaded) {
  reloader();
  write("second.so");
  const std::vector<ReloadEvent> seen = events(reloader(), 2);
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_EQ(seen[0].library, "ambient.subject");
  EXPECT_EQ(seen[0].state, BuildState::building);
  EXPECT_EQ(seen[1].state, BuildState::loaded);
  EXPECT_EQ(seen[1].generation, 2);
  session.update();
  EXPECT_EQ(strength("untouched"), 0.75f);
  EXPECT_EQ(strength("changed"), 0.25f);
}

TEST_F(Build, ThatFailsShowsTheCompilersMessages) {
  reloader();
  write("/src/plugins/ambient/subject/subject.cpp:12:7: error: 'strenght' was not declared in this scope\n");
  const std::vector<ReloadEvent> seen = events(reloader(), 2);
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_EQ(seen[1].state, BuildState::kept);
  EXPECT_EQ(seen[1].message, "it does not compile");
  ASSERT_EQ(reloader().problems().size(), 1u);
  const lumen::Problem problem = reloader().problems()[0];
  EXPECT_EQ(problem.file, "/src/plugins/ambient/subject/subject.cpp");
  EXPECT_EQ(problem.line, 12);
  EXPECT_EQ(problem.column, 7);
  EXPECT_EQ(problem.message, "'strenght' was not declared in this scope");
  EXPECT_EQ(registry.generation("ambient.subject"), 1);

  write("second.so");
  events(reloader(), 2);
  EXPECT_TRUE(reloader().problems().empty());
}

TEST_F(Build, ThatFailsWithoutAPlaceShowsItsLastLine) {
  reloader();
  write("first line\nninja: fatal: no space left\n\n");
  events(reloader(), 2);
  ASSERT_EQ(reloader().problems().size(), 1u);
  EXPECT_EQ(reloader().problems()[0].message, "the build failed: ninja: fatal: no space left");
}

TEST_F(Build, IsEndedByANewerChange) {
  reloader();
  write("slow");
  ASSERT_EQ(events(reloader()).size(), 1u);
  ASSERT_TRUE(reloader().building());
  const int first = sleeping_compiler();
  ASSERT_GT(first, 0);
  write("second.so");
  const std::vector<ReloadEvent> seen = events(reloader(), 2);
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_EQ(seen.back().state, BuildState::loaded);
  EXPECT_FALSE(is_alive(first));
}

TEST_F(Build, ThatChangesNothingLeavesTheBadgeIdle) {
  std::ofstream(folder / "compile.sh") << "exit 0\n";
  reloader();
  write("anything");
  const std::vector<ReloadEvent> seen = events(reloader(), 2);
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_EQ(seen[1].state, BuildState::idle);
}

TEST_F(Build, IsStartedByHand) {
  write("second.so");
  reloader().build_now();
  EXPECT_TRUE(reloader().building());
  const std::vector<ReloadEvent> seen = events(reloader());
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_EQ(seen[0].state, BuildState::loaded);
}

TEST_F(Build, ThatCannotStartIsAProblem) {
  std::ofstream(folder / "build.json") << R"({"sources": "/nowhere", "build": "/", "command": ["/nowhere/ninja"]})";
  reloader().build_now();
  ASSERT_EQ(reloader().problems().size(), 1u);
  EXPECT_NE(reloader().problems()[0].message.find("/nowhere/ninja: it does not start"), std::string::npos) << reloader().problems()[0].message;
}

TEST_F(Build, EndsWithTheReloader) {
  reloader();
  write("slow");
  ASSERT_EQ(events(reloader()).size(), 1u);
  const int compiler = sleeping_compiler();
  ASSERT_GT(compiler, 0);
  reloader_.reset();
  EXPECT_FALSE(is_alive(compiler));
}

}  // namespace
}  // namespace lumenshop::tests
