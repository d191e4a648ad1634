/// The real window under Xvfb, played by a script of steps: what the tests of panels and of the view share.
#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace lumenshop::testing {

/// A folder of its own with a session in it. Skips where there is no Xvfb. LUMEN_KEEP_SHOTS names a folder that gets a copy of each.
class WindowTestCase : public ::testing::Test {
 protected:
  explicit WindowTestCase(std::string session) : session_(std::move(session)) {}
  void SetUp() override;
  void TearDown() override;

  /// Plays the steps (a JSON array) over a session of the folder; what the script finds wrong is a failure. `environment`: "NAME=value ...".
  void play(const std::string& steps, const std::string& session = "session.json", const std::string& environment = {}) const;
  /// The same with a panel open; `steps` without brackets.
  void play_in_panel(const std::string& panel, const std::string& steps) const;

  const std::filesystem::path folder = std::filesystem::temp_directory_path() / ("lumenshop-window-" + std::to_string(process()));

 private:
  static int process();
  std::string session_;
};

}  // namespace lumenshop::testing
