/// The helper process: what a worker gives back, and every way in which it can fail.
#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>
#include <utility>

#include <gtest/gtest.h>

#include <lumen/job.h>
#include <lumen/mesh.h>

#include "installation.h"
#include "process/helper.h"

namespace {

using lumenshop::Helper;
using lumenshop::Installation;
namespace fs = std::filesystem;

class HelperTest : public testing::Test {
 protected:
  lumen::WorkerReply run(const std::string& verb, std::map<std::string, std::string> arguments = {}, const std::string& untrusted_file = {}) {
    lumen::WorkerRequest request;
    request.module = "trial";
    request.verb = verb;
    request.arguments = std::move(arguments);
    request.untrusted_file = untrusted_file;
    return helper.run(request, {});
  }

  std::string failure(const std::string& verb, std::map<std::string, std::string> arguments = {}, const std::string& untrusted_file = {}) {
    try {
      run(verb, std::move(arguments), untrusted_file);
    } catch (const lumen::Error& error) {
      return error.what();
    }
    return "no failure";
  }

  /// All processes whose parent is `parent`, with their state letter.
  static std::map<int, char> children_of(int parent) {
    std::map<int, char> children;
    for (const fs::directory_entry& entry : fs::directory_iterator("/proc")) {
      std::ifstream file(entry.path() / "stat");
      std::string line;
      if (!std::getline(file, line)) continue;
      const std::size_t end = line.rfind(')');
      char state = 0;
      int its_parent = 0;
      if (end != std::string::npos && std::sscanf(line.c_str() + end + 1, " %c %d", &state, &its_parent) == 2 && its_parent == parent)
        children[std::atoi(line.c_str())] = state;
    }
    return children;
  }

  static int helper_process() {
    const std::map<int, char> children = children_of(::getpid());
    return children.empty() ? 0 : children.begin()->first;
  }

  template <class Condition> static bool comes_true(const Condition& condition) {
    for (int patience = 0; patience < 6000; ++patience) {
      if (condition()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

  static constexpr const char* endless = "1000000";  ///< steps of 10 ms: whatever waits for their end fails by its time limit
  const Installation installation = Installation::find();
  Helper helper{installation.helper(), installation.root / "tests/broken/workers"};
};

TEST_F(HelperTest, HandsTextsNotesAndDataBothWays) {
  auto mesh = std::make_shared<lumen::Mesh>();
  mesh->positions = std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 5}};
  mesh->triangles = std::vector<glm::uvec3>{{0, 1, 2}};
  mesh->finish();
  lumen::WorkerRequest request{"trial", "echo", {{"file", "a\xff b\n.vtp"}, {"long", std::string(300000, 'x')}}, {mesh, nullptr}};
  const lumen::WorkerReply reply = helper.run(request, {});
  EXPECT_EQ(reply.values, request.arguments);
  ASSERT_EQ(reply.notes.size(), 1u);
  EXPECT_EQ(reply.notes[0].text, "two cells skipped");
  EXPECT_EQ(reply.notes[0].severity, lumen::Severity::warning);
  ASSERT_EQ(reply.data.size(), 2u);
  const auto copy = std::dynamic_pointer_cast<const lumen::Mesh>(reply.data[0]);
  ASSERT_TRUE(copy);
  EXPECT_EQ(copy->positions[2], glm::vec3(0, 1, 5));
  EXPECT_EQ(reply.data[1], nullptr);
}

TEST_F(HelperTest, PassesOnTheWorkersOwnMessage) {
  EXPECT_EQ(failure("throw"), "line 3: not a mesh");
  EXPECT_NE(failure("throw number").find("no std::exception"), std::string::npos);
}

TEST_F(HelperTest, NamesTheSignalOfACrash) {
  EXPECT_EQ(failure("crash"), "trial: crashed (signal 11, SIGSEGV)");
  EXPECT_EQ(failure("crash", {}, "/tmp/aorta.vtp"), "aorta.vtp: its reader crashed (signal 11, SIGSEGV)");
}

TEST_F(HelperTest, AddsTheLastWordsOfWhoAborts) { EXPECT_EQ(failure("abort"), "trial: crashed (signal 6, SIGABRT): assertion 'cells > 0' failed"); }

TEST_F(HelperTest, NamesTheExitCodeOfWhoLeaves) { EXPECT_EQ(failure("exit"), "trial: ended by itself (exit code 7)"); }

TEST_F(HelperTest, BoundsTheMemoryOfAnUntrustedFile) {
  const std::string file = fs::path(testing::TempDir()) / "small.vtp";
  std::ofstream(file) << "small";
  EXPECT_EQ(failure("memory", {{"MiB", "200"}}, file), "no failure");
  EXPECT_EQ(failure("memory", {{"MiB", "300"}}, file), "small.vtp: its reader ran out of memory (limit 256 MiB)");
  EXPECT_EQ(failure("malloc", {{"MiB", "300"}}, file), "no memory");
  EXPECT_EQ(failure("memory", {{"MiB", "300"}}), "no failure");
}

TEST_F(HelperTest, LetsALargeFileHaveMore) {
  const std::string file = fs::path(testing::TempDir()) / "large.vtp";
  std::ofstream(file) << std::string(2 << 20, 'x');
  EXPECT_EQ(failure("memory", {{"MiB", "350"}}, file), "no failure");
  EXPECT_EQ(failure("memory", {{"MiB", "420"}}, file), "large.vtp: its reader ran out of memory (limit 400 MiB)");
}

TEST_F(HelperTest, CountsWhatIsHandedOver) {
  const std::string file = fs::path(testing::TempDir()) / "small.vtp";
  std::ofstream(file) << "small";
  EXPECT_EQ(failure("large data", {{"MiB", "100"}}, file), "no failure");
  EXPECT_EQ(failure("large data", {{"MiB", "200"}}, file), "small.vtp: its reader ran out of memory (limit 256 MiB)");
}

TEST_F(HelperTest, ChecksTheDataOfItsWorkers) { EXPECT_NE(failure("bad mesh").find("bad.ply: "), std::string::npos) << failure("bad mesh"); }

TEST_F(HelperTest, RefusesModulesThatAreNotThereOrTooOld) {
  lumen::WorkerRequest request;
  const auto reason = [&](const std::string& module) -> std::string {
    request.module = module;
    try {
      helper.run(request, {});
    } catch (const lumen::Error& error) {
      return error.what();
    }
    return "no failure";
  };
  EXPECT_NE(reason("absent").find("worker module absent"), std::string::npos);
  EXPECT_EQ(reason("old"), "worker module old: built for another SDK; rebuild it");
  EXPECT_EQ(reason("../trial"), "worker module: '../trial' is no module's name");
}

TEST_F(HelperTest, DrainsWhatAWorkerPrints) { EXPECT_EQ(failure("print"), "no failure"); }

TEST_F(HelperTest, GivesAChildNothingButItsOwnFiles) {
  // stdin, stdout, stderr, its channel
  EXPECT_EQ(run("descriptors").values.at("open"), "4");
}

TEST_F(HelperTest, ReportsProgressAndStopsWhenToldTo) {
  lumen::WorkerRequest request;
  request.module = "trial";
  request.verb = "work";
  request.arguments["steps"] = endless;
  std::vector<float> seen;
  EXPECT_THROW(helper.run(request, [&](float fraction) {
    seen.push_back(fraction);
    return fraction == 0;
  }), lumen::Cancelled);
  EXPECT_EQ(seen.front(), 0);
  EXPECT_LT(seen.back(), 0.5f);
  EXPECT_TRUE(comes_true([] { return children_of(helper_process()).empty(); })) << "the cancelled child is still there";
}

TEST_F(HelperTest, UsesTheChildThatWasWarmedUp) {
  helper.warm_up("trial");
  helper.warm_up("trial");
  ASSERT_TRUE(comes_true([] { return children_of(helper_process()).size() == 1; }));
  const std::string waiting = std::to_string(children_of(helper_process()).begin()->first);
  EXPECT_EQ(run("process").values.at("process"), waiting);
  EXPECT_NE(run("process").values.at("process"), waiting);
}

TEST_F(HelperTest, ReplacesAWarmChildThatDied) {
  helper.warm_up("trial");
  ASSERT_TRUE(comes_true([] { return children_of(helper_process()).size() == 1; }));
  ::kill(children_of(helper_process()).begin()->first, SIGKILL);
  ASSERT_TRUE(comes_true([] { return children_of(helper_process()).empty(); }));
  EXPECT_EQ(failure("echo"), "no failure");
}

TEST_F(HelperTest, LeavesNoZombies) {
  for (int run = 0; run < 5; ++run) failure(run % 2 == 0 ? "crash" : "echo");
  EXPECT_TRUE(comes_true([] { return children_of(helper_process()).empty(); }));
  EXPECT_EQ(children_of(::getpid()).size(), 1u);
}

TEST_F(HelperTest, RunsSeveralAtOnce) {
  constexpr int count = 4;
  std::atomic<int> working = 0, cancelled = 0;
  std::vector<std::thread> threads;
  for (int index = 0; index < count; ++index)
    threads.emplace_back([&] {
      lumen::WorkerRequest request{"trial", "work", {{"steps", endless}}};
      bool counted = false;
      try {
        helper.run(request, [&](float fraction) {
          if (fraction > 0 && !std::exchange(counted, true)) ++working;
          return working < count;  // each goes on until all of them are at work
        });
      } catch (const lumen::Cancelled&) {
        ++cancelled;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(cancelled, count);
}

TEST_F(HelperTest, StartsTheHelperProcessAgainWhenItDied) {
  const int before = helper_process();
  ASSERT_GT(before, 0);
  lumen::WorkerRequest request{"trial", "work", {{"steps", endless}}};
  std::string reason = "no failure";
  try {
    helper.run(request, [&](float fraction) {
      if (fraction > 0) ::kill(before, SIGKILL);
      return true;
    });
  } catch (const lumen::Error& error) {
    reason = error.what();
  }
  EXPECT_NE(reason.find("the helper process ended"), std::string::npos) << reason;
  EXPECT_EQ(failure("echo"), "no failure");
  EXPECT_NE(helper_process(), before);
  EXPECT_EQ(children_of(::getpid()).size(), 1u);
}

TEST(HelperLife, EndsWithItsOwner) {
  const Installation installation = Installation::find();
  int process = 0;
  {
    Helper helper(installation.helper(), installation.root / "tests/broken/workers");
    helper.warm_up("trial");
    std::ifstream("/proc/thread-self/children") >> process;
    ASSERT_GT(process, 0);
  }
  EXPECT_NE(::kill(process, 0), 0);
}

TEST(HelperLife, NamesAnExecutableThatIsNotThere) {
  EXPECT_THROW(Helper("/nowhere/lumenshop-helper", "/nowhere"), lumen::Error);
}

}  // namespace
