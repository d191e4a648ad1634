/// The command line becomes plain options, or a usage error that names what is wrong.
#include <gtest/gtest.h>

#include "command/command_line.h"

namespace lumenshop {
namespace {

std::variant<CommandLine, std::string> parse(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "lumenshop");
  return parse_command_line(int(arguments.size()), arguments.data());
}

template <class Options>
Options options_of(std::vector<const char*> arguments) {
  return std::get<Options>(std::get<CommandLine>(parse(std::move(arguments))).command);
}

std::string usage_error_of(std::vector<const char*> arguments) {
  try {
    parse(std::move(arguments));
  } catch (const UsageError& error) {
    return error.what();
  }
  return {};
}

TEST(CommandLine, WithoutCommandIsTheWindow) {
  EXPECT_TRUE(options_of<WindowOptions>({}).files.empty());
  const auto options = options_of<WindowOptions>({"a.vtp", "b.vtp"});
  ASSERT_EQ(options.files.size(), 2u);
  EXPECT_EQ(options.files[1], "b.vtp");
}

TEST(CommandLine, RenderTakesAllItsOptions) {
  const auto options = options_of<RenderOptions>({"render", "a.json", "-o", "a.png", "--size", "640x480", "--view", "side", "--layer", "normal", "--set",
                                                  "wall.diffuse_color=[1,0,0]", "--set", "note.text=a=b", "--frames", "3:7"});
  EXPECT_EQ(options.files.front(), "a.json");
  EXPECT_EQ(options.output, "a.png");
  EXPECT_EQ(options.size, glm::ivec2(640, 480));
  EXPECT_EQ(options.view, "side");
  EXPECT_EQ(options.layer, "normal");
  ASSERT_EQ(options.overrides.size(), 2u);
  EXPECT_EQ(options.overrides[0].path, "wall.diffuse_color");
  EXPECT_EQ(options.overrides[0].value, "[1,0,0]");
  EXPECT_EQ(options.overrides[1].value, "a=b");
  ASSERT_TRUE(options.frames);
  EXPECT_EQ(options.frames->first, 3);
  EXPECT_EQ(options.frames->last, 7);
}

TEST(CommandLine, RenderHasDefaults) {
  const auto options = options_of<RenderOptions>({"render", "a.vtp", "-o", "a.png"});
  EXPECT_EQ(options.size, glm::ivec2(1280, 1024));
  EXPECT_EQ(options.layer, "color");
  EXPECT_FALSE(options.frames);
}

TEST(CommandLine, PluginFoldersComeBeforeAndAfterTheCommand) {
  const auto line = std::get<CommandLine>(parse({"--plugins", "one", "describe", "--plugins", "two", "--json"}));
  ASSERT_EQ(line.plugin_folders.size(), 2u);
  EXPECT_EQ(line.plugin_folders[0], "one");
  EXPECT_EQ(line.plugin_folders[1], "two");
  EXPECT_TRUE(std::get<DescribeOptions>(line.command).json);
}

TEST(CommandLine, OtherCommandsTakeTheirOptions) {
  const auto exported = options_of<ExportOptions>({"export", "a.json", "scan.mesh", "-o", "a.vtp"});
  EXPECT_EQ(exported.property, "scan.mesh");
  EXPECT_EQ(exported.output, "a.vtp");
  const auto bench = options_of<BenchOptions>({"bench", "a.json", "--size", "64x32", "--frames", "9", "--set-each", "vignette.radius=1,2", "--json"});
  EXPECT_EQ(bench.size, glm::ivec2(64, 32));
  EXPECT_EQ(bench.frames, 9);
  ASSERT_TRUE(bench.alternate);
  EXPECT_EQ(bench.alternate->value, "1,2");
  EXPECT_TRUE(bench.json);
  EXPECT_EQ(options_of<CheckOptions>({"check", "a.so", "--level", "2"}).level, 2);
  EXPECT_EQ(options_of<NewOptions>({"new", "diffuse", "mine", "--dir", "there"}).folder, "there");
}

TEST(CommandLine, HelpAndVersionAreTexts) {
  EXPECT_NE(std::get<std::string>(parse({"--help"})).find("render"), std::string::npos);
  EXPECT_NE(std::get<std::string>(parse({"render", "--help"})).find("--layer"), std::string::npos);
  EXPECT_TRUE(std::get<std::string>(parse({"--version"})).starts_with("lumenshop "));
}

TEST(CommandLine, WrongUsageIsNamed) {
  EXPECT_NE(usage_error_of({"render", "a.json"}).find("--output"), std::string::npos);
  EXPECT_NE(usage_error_of({"render", "a.json", "-o", "a.png", "--sise", "1x1"}).find("--sise"), std::string::npos);
  for (const char* size : {"640", "0x10", "10x0", "-4x4", "4x4x4", "16385x1", "ax4", "4x", " 4x4"})
    EXPECT_NE(usage_error_of({"render", "a.json", "-o", "a.png", "--size", size}).find("--size"), std::string::npos) << size;
  for (const char* value : {"wall", "wall.color", "wall=1", ".color=1", "wall.=1", "1wall.color=1", "wall.a.b=1"})
    EXPECT_NE(usage_error_of({"render", "a.json", "-o", "a.png", "--set", value}).find("--set"), std::string::npos) << value;
  for (const char* frames : {"3", "5:2", "a:b", "-1:2", "1:"})
    EXPECT_NE(usage_error_of({"render", "a.json", "-o", "a.png", "--frames", frames}).find("--frames"), std::string::npos) << frames;
  EXPECT_FALSE(usage_error_of({"export", "a.json", "scan", "-o", "a.vtp"}).empty());
  EXPECT_FALSE(usage_error_of({"bench", "a.json", "--frames", "0"}).empty());
  EXPECT_FALSE(usage_error_of({"check", "a.so", "--level", "11"}).empty());
  EXPECT_FALSE(usage_error_of({"check"}).empty());
}

}  // namespace
}  // namespace lumenshop
