#include "window_test_case.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include <sys/wait.h>
#include <unistd.h>

#include "installation.h"

namespace lumenshop::testing {
namespace {

std::filesystem::path program() { return Installation::find().root / "bin/lumenshop"; }

}  // namespace

int WindowTestCase::process() { return int(getpid()); }

void WindowTestCase::SetUp() {
  if (std::system("command -v xvfb-run >/dev/null 2>&1") != 0) GTEST_SKIP() << "xvfb-run is not installed";
  if (!std::filesystem::exists(program())) GTEST_SKIP() << program() << " is not built";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "session.json") << session_;
}

void WindowTestCase::TearDown() {
  if (const char* kept = std::getenv("LUMEN_KEEP_SHOTS"))
    std::filesystem::copy(folder, kept, std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing);
  std::filesystem::remove_all(folder);
}

void WindowTestCase::play(const std::string& steps, const std::string& session, const std::string& environment) const {
  std::ofstream(folder / "script.json") << steps;
  const std::string place = "'" + folder.string() + "'";
  const std::string command = "cd " + place + " && XDG_DATA_HOME=" + place + " XDG_CONFIG_HOME=" + place + " MESA_SHADER_CACHE_DIR=" + place + " " + environment +
                              " timeout 240 xvfb-run -a -s '-screen 0 1280x800x24' '" + program().string() + "' --size 1200x760 --script script.json " + session + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  ASSERT_NE(pipe, nullptr);
  std::string output;
  std::array<char, 4096> buffer;
  while (const auto count = std::fread(buffer.data(), 1, buffer.size(), pipe)) output.append(buffer.data(), count);
  const int status = pclose(pipe);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << output;
}

void WindowTestCase::play_in_panel(const std::string& panel, const std::string& steps) const {
  play(R"json([{"settle": true}, {"command": "panel.)json" + panel + R"json("}, {"idle": 0.5}, )json" + steps + "]");
}

}  // namespace lumenshop::testing
