// Layout, input queue, commands and resolution: the window's parts that need no window.
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include <gtest/gtest.h>

#include <lumen/ui/space_fields.h>
#include <lumen/ui/text_field.h>

#include "window/command_table.h"
#include "window/input_queue.h"
#include "window/layout.h"
#include "window/resolution.h"
#include "window/settings.h"

namespace {

using namespace lumenshop;

TEST(Layout, TilesTheWindowWithoutOverlap) {
  const Layout layout = arranged({1440, 900}, 1, {}, false);
  EXPECT_EQ(layout.outline.size().x, 280);
  EXPECT_EQ(layout.properties.size().x, 360);
  EXPECT_EQ(layout.status.size().y, 26);
  EXPECT_EQ(layout.view.min, glm::vec2(280, Layout::menu_height));
  EXPECT_EQ(layout.view.max.x, 1440 - 360);
  EXPECT_EQ(layout.view.max.y, layout.bottom.min.y);
  EXPECT_EQ(layout.bottom.max.y, layout.status.min.y);
}

TEST(Layout, KeepsRoomForTheViewInSmallWindows) {
  for (const float width : {300.0f, 500.0f, 800.0f}) {
    const Layout layout = arranged({width, 300}, 1, {}, false);
    EXPECT_GE(layout.view.size().x, std::min(width, Layout::smallest_view) - 1) << width;
    EXPECT_GT(layout.view.size().y, 0);
  }
}

TEST(Layout, ScalesWithTheMonitor) {
  const Layout layout = arranged({2880, 1800}, 2, {}, false);
  EXPECT_EQ(layout.outline.size().x, 560);
}

TEST(Layout, ShowsThePictureAloneInFigureMode) {
  const Layout layout = arranged({1440, 900}, 1, {}, true);
  EXPECT_EQ(layout.view.size(), glm::vec2(1440, 900));
  EXPECT_TRUE(layout.menu.empty() && layout.outline.empty() && layout.properties.empty() && layout.bottom.empty() && layout.status.empty());
}

WindowEvent button(bool down) {
  WindowEvent event;
  event.type = WindowEvent::Type::button;
  event.down = down;
  return event;
}
WindowEvent pointer(float x) {
  WindowEvent event;
  event.position = {x, 0};
  return event;
}

TEST(InputQueue, NeverHidesAClickInOneFrame) {
  InputQueue queue;
  queue.push(pointer(1));
  queue.push(pointer(2));
  queue.push(button(true));
  queue.push(button(false));
  queue.push(pointer(9));
  const auto first = queue.take_frame();
  ASSERT_EQ(first.size(), 2u) << "moves join, the press follows them";
  EXPECT_EQ(first[0].position.x, 2);
  EXPECT_TRUE(first[1].down);
  const auto second = queue.take_frame();
  ASSERT_EQ(second.size(), 1u);
  EXPECT_FALSE(second[0].down);
  EXPECT_EQ(queue.take_frame().at(0).position.x, 9) << "a move after a button waits for the next frame";
  EXPECT_TRUE(queue.empty());
}

TEST(InputQueue, NamesEveryKeyOfTheTableBothWays) {
  for (const char* name : {"A", "7", "F12", "Esc", "Del", "Home", "BracketLeft", "Plus", "Period", "Ctrl", "Shift"}) EXPECT_EQ(name_of_key(key_of_name(name)), name);
  EXPECT_EQ(key_of_name("NoSuchKey"), 0);
}

TEST(CommandTable, RunsWhatAChordMeans) {
  CommandTable table;
  int saved = 0, toggled = 0, written = 0;
  table.add({.id = "save", .menu = "File", .title = "Save", .keys = "Ctrl+S", .run = [&] { ++saved; }});
  table.add({.id = "toggle", .menu = "Window", .title = "Outline", .keys = "T", .run = [&] { ++toggled; }});
  table.add({.id = "write", .menu = "File", .title = "Write", .keys = "F12", .run = [&] { ++written; }});
  EXPECT_TRUE(table.press("S", true, false, false));
  EXPECT_FALSE(table.press("S", false, false, false));
  EXPECT_TRUE(table.press("T", false, false, false));
  EXPECT_FALSE(table.press("T", false, false, true)) << "letters are text while a field is active";
  EXPECT_TRUE(table.press("F12", false, false, true)) << "function keys are not";
  EXPECT_EQ(saved, 1);
  EXPECT_EQ(toggled, 1);
  EXPECT_EQ(written, 1);
}

TEST(CommandTable, RefusesTwoCommandsOnOneChord) {
  CommandTable table;
  table.add({.id = "one", .menu = "", .title = "", .keys = "Ctrl+Shift+Z", .run = [] {}});
  EXPECT_THROW(table.add({.id = "two", .menu = "", .title = "", .keys = "Ctrl+Shift+Z", .run = [] {}}), std::logic_error);
}

TEST(CommandTable, DoesNotRunWhatIsNotEnabled) {
  CommandTable table;
  bool ran = false;
  table.add({.id = "undo", .menu = "Edit", .title = "Undo", .keys = "Ctrl+Z", .run = [&] { ran = true; }, .enabled = [] { return false; }});
  EXPECT_FALSE(table.press("Z", true, false, false));
  EXPECT_FALSE(ran);
}

TEST(Resolution, IsWholeAtRestAndCoarseWhileASlowSceneMoves) {
  Resolution resolution;
  EXPECT_EQ(resolution.divider(0), 1);
  resolution.changed(1);
  EXPECT_EQ(resolution.divider(1), 1) << "the first picture is tried whole";
  resolution.took(0.1, 1);
  EXPECT_EQ(resolution.divider(1.05), 2);
  resolution.took(0.05, 2);
  EXPECT_EQ(resolution.divider(1.1), 4);
  EXPECT_EQ(resolution.divider(1.2), 1) << "150 ms after the last change it is refined";
  EXPECT_NEAR(resolution.rests_at(), 1.15, 1e-9);
}

TEST(Resolution, ReturnsToWholePicturesWhenThereIsTime) {
  Resolution resolution;
  resolution.changed(1);
  resolution.took(0.1, 1);
  resolution.took(0.004, 2);
  EXPECT_EQ(resolution.divider(1.01), 1);
  resolution.took(0.02, 1);
  EXPECT_EQ(resolution.divider(1.02), 1);
}

TEST(Settings, KeepWhatWasChosenAndSurviveNonsense) {
  const auto file = std::filesystem::temp_directory_path() / ("lumenshop-settings-" + std::to_string(getpid())) / "ui.json";
  Settings settings;
  settings.panels.outline = 333;
  settings.panels.bottom_open = false;
  settings.theme = lumen::ui::Theme::light;
  settings.remember("/a/b.json");
  settings.save(file);
  const Settings back = Settings::load(file);
  EXPECT_EQ(back.panels.outline, 333);
  EXPECT_FALSE(back.panels.bottom_open);
  EXPECT_EQ(back.theme, lumen::ui::Theme::light);
  EXPECT_EQ(back.recent, std::vector<std::string>{"/a/b.json"});
  std::ofstream(file) << R"({"outline": -5, "scale": "big", "theme": 7})";
  const Settings odd = Settings::load(file);
  EXPECT_EQ(odd.panels.outline, Layout::smallest);
  EXPECT_EQ(odd.user_scale, 1);
  std::filesystem::remove_all(file.parent_path());
}

TEST(RotationField, ShowsAnglesThatGiveTheRotationBack) {
  for (const glm::vec3 angles : {glm::vec3(10, 20, 30), glm::vec3(-170, 45, 90), glm::vec3(0, 90, 0), glm::vec3(35, -90, 0)}) {
    const glm::quat rotation = lumen::ui::rotation_of(angles);
    const glm::quat again = lumen::ui::rotation_of(lumen::ui::euler_of(rotation));
    EXPECT_NEAR(std::abs(glm::dot(rotation, again)), 1, 1e-4f);
  }
}

TEST(Filters, FindAllTheirWordsInAnyOrder) {
  EXPECT_TRUE(lumen::ui::matches("Occlusion radius", "rad occ"));
  EXPECT_FALSE(lumen::ui::matches("Occlusion radius", "radius bias"));
  EXPECT_TRUE(lumen::ui::matches("anything", ""));
}

}  // namespace
