#include "command/command_line.h"

#include <charconv>

#include <CLI/CLI.hpp>

namespace lumenshop {
namespace {

template <class Number>
bool parse_number(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

glm::ivec2 parse_size(const std::string& text) {
  const std::size_t cross = text.find('x');
  glm::ivec2 size{0};
  const bool well = cross != std::string::npos && parse_number(std::string_view(text).substr(0, cross), size.x) &&
                    parse_number(std::string_view(text).substr(cross + 1), size.y);
  if (!well || size.x < 1 || size.y < 1 || size.x > 16384 || size.y > 16384)
    throw UsageError("--size " + text + ": expected WIDTHxHEIGHT in pixels, 1 to 16384 each, as in 1280x1024");
  return size;
}

bool is_property_path(std::string_view path) {
  const std::size_t dot = path.find('.');
  const auto well_formed = [](std::string_view name) {
    return !name.empty() && std::isalpha(static_cast<unsigned char>(name.front())) &&
           std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  };
  return dot != std::string_view::npos && well_formed(path.substr(0, dot)) && well_formed(path.substr(dot + 1));
}

Override parse_override(const std::string& option, const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || !is_property_path(std::string_view(text).substr(0, equals)))
    throw UsageError(option + " " + text + ": expected ID.PROPERTY=VALUE, as in wall.diffuse_color=[1,0,0]");
  return {text.substr(0, equals), text.substr(equals + 1)};
}

FrameRange parse_frames(const std::string& text) {
  const std::size_t colon = text.find(':');
  FrameRange range;
  const bool well = colon != std::string::npos && parse_number(std::string_view(text).substr(0, colon), range.first) &&
                    parse_number(std::string_view(text).substr(colon + 1), range.last);
  if (!well || range.first < 0 || range.last < range.first)
    throw UsageError("--frames " + text + ": expected FIRST:LAST, as in 0:99");
  return range;
}

/// The texts that need a second look after CLI11 has sorted them.
struct RawOptions {
  std::string size, frames, alternate;
  std::vector<std::string> overrides;

  void add_size(CLI::App& command) { command.add_option("--size", size, "picture size in pixels (default: 1280x1024)")->type_name("WxH"); }
  void add_overrides(CLI::App& command) {
    command.add_option("--set", overrides, "give a property a value: JSON, else a string; repeatable")
        ->type_name("ID.PROPERTY=JSON")->allow_extra_args(false);
  }
  std::vector<Override> parsed_overrides() const {
    std::vector<Override> result;
    for (const std::string& text : overrides) result.push_back(parse_override("--set", text));
    return result;
  }
};

}  // namespace

std::variant<CommandLine, std::string> parse_command_line(int argument_count, const char* const* arguments) {
  CLI::App program("Lumenshop: a workbench for visualization research.\n"
                   "Without a command it opens a window on a session or on data files.", "lumenshop");
  program.set_version_flag("--version", "lumenshop " LUMENSHOP_VERSION);
  program.set_help_flag("-h,--help", "print this help");
  program.require_subcommand(0, 1);

  std::vector<std::string> plugin_folders, command_plugin_folders;  // before and after the command
  const auto add_plugin_folders = [](CLI::App& command, std::vector<std::string>& folders) {
    command.add_option("--plugins", folders, "another folder of plugins; repeatable")->type_name("DIR")->allow_extra_args(false);
  };
  add_plugin_folders(program, plugin_folders);

  WindowOptions window;
  std::vector<std::string> files;
  program.add_option("files", files, "a session (.json) or data files")->type_name("SESSION|DATA");
  std::string window_size, script;
  program.add_option("--size", window_size, "window size in pixels (default: 1440x900)")->type_name("WxH");
  program.add_option("--script", script, "plays a person's steps from a JSON file, then leaves")->type_name("FILE");

  RawOptions raw;
  std::string output;

  RenderOptions render;
  CLI::App& render_command = *program.add_subcommand("render", "draw a session or data into a picture file");
  render_command.add_option("files", files, "a session (.json) or data files")->type_name("SESSION|DATA")->required();
  render_command.add_option("-o,--output", output, "the picture: png, exr, pfm, ppm ...")->type_name("OUT")->required();
  raw.add_size(render_command);
  render_command.add_option("--view", render.view, "the view to draw (default: the first)")->type_name("V");
  render_command.add_option("--layer", render.layer, "a layer instead of the picture, or all in one EXR")->type_name("L");
  raw.add_overrides(render_command);
  render_command.add_option("--frames", raw.frames, "a picture per frame, 25 a second of the view's time")->type_name("A:B");

  ExportOptions exported;
  std::string session;
  CLI::App& export_command = *program.add_subcommand("export", "write an instance's data to a file");
  export_command.add_option("session", session, "the session")->type_name("SESSION")->required();
  export_command.add_option("property", exported.property, "which output")->type_name("ID.PROPERTY")->required();
  export_command.add_option("-o,--output", output, "the file")->type_name("FILE")->required();
  raw.add_overrides(export_command);

  BenchOptions bench;
  CLI::App& bench_command = *program.add_subcommand("bench", "measure frames and their passes");
  bench_command.add_option("files", files, "a session (.json) or data files")->type_name("SESSION|DATA")->required();
  raw.add_size(bench_command);
  bench_command.add_option("--frames", bench.frames, "frames to measure (default: 30)")->type_name("N");
  bench_command.add_option("--view", bench.view, "the view to draw (default: the first)")->type_name("V");
  raw.add_overrides(bench_command);
  bench_command.add_flag("--still", bench.still, "leave the camera where it is (default: it turns a little each frame)");
  bench_command.add_flag("--final", bench.final, "measure finished pictures, with all their refinements");
  bench_command.add_option("--set-each", raw.alternate, "give a property these values in turn, one per frame; the camera stays")
      ->type_name("ID.PROPERTY=A,B");
  bench_command.add_flag("--json", bench.json, "print JSON");
  bench_command.add_flag("--host-cpu", bench.host_cpu)->group("");  // bench asks this of a child of its own

  DescribeOptions describe;
  CLI::App& describe_command = *program.add_subcommand("describe", "list plugins and their properties");
  describe_command.add_option("type", describe.type, "one type, as in occlusion.ssao (default: all)")->type_name("TYPE");
  describe_command.add_flag("--json", describe.json, "print JSON");

  CheckOptions check;
  std::string library;
  CLI::App& check_command = *program.add_subcommand("check", "validate a plugin's library");
  check_command.add_option("library", library, "the library")->type_name("PLUGIN.so")->required();
  check_command.add_option("--level", check.level, "how far to go (default: 3)")->type_name("1..10")->check(CLI::Range(1, 10));

  NewOptions fresh;
  std::string folder;
  CLI::App& new_command = *program.add_subcommand("new", "write a plugin that builds, draws and passes its test");
  new_command.add_option("kind", fresh.kind, "the contract that it fulfils, as in diffuse")->type_name("KIND")->required();
  new_command.add_option("name", fresh.name, "lower case, as in my_toon")->type_name("NAME")->required();
  new_command.add_option("--dir", folder, "the source tree to write into (default: the one this program was built from)")->type_name("DIR");

  for (CLI::App* command : program.get_subcommands({})) add_plugin_folders(*command, command_plugin_folders);

  try {
    program.parse(argument_count, arguments);
  } catch (const CLI::CallForHelp&) {
    const auto chosen = program.get_subcommands();
    return (chosen.empty() ? program : *chosen.front()).help();
  } catch (const CLI::CallForVersion& version) {
    return std::string(version.what()) + "\n";
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }

  CommandLine line;
  line.plugin_folders.assign(plugin_folders.begin(), plugin_folders.end());
  line.plugin_folders.insert(line.plugin_folders.end(), command_plugin_folders.begin(), command_plugin_folders.end());
  const std::vector<std::filesystem::path> paths(files.begin(), files.end());
  if (render_command.parsed()) {
    render.files = paths;
    render.output = output;
    if (!raw.size.empty()) render.size = parse_size(raw.size);
    if (!raw.frames.empty()) render.frames = parse_frames(raw.frames);
    render.overrides = raw.parsed_overrides();
    line.command = std::move(render);
  } else if (export_command.parsed()) {
    if (!is_property_path(exported.property))
      throw UsageError(exported.property + ": expected ID.PROPERTY, as in scan.mesh");
    exported.session = session;
    exported.output = output;
    exported.overrides = raw.parsed_overrides();
    line.command = std::move(exported);
  } else if (bench_command.parsed()) {
    bench.files = paths;
    if (!raw.size.empty()) bench.size = parse_size(raw.size);
    if (bench.frames < 1 || bench.frames > 100000) throw UsageError("--frames: expected 1 to 100000");
    if (!raw.alternate.empty()) bench.alternate = parse_override("--set-each", raw.alternate);
    bench.overrides = raw.parsed_overrides();
    line.command = std::move(bench);
  } else if (describe_command.parsed()) {
    line.command = std::move(describe);
  } else if (check_command.parsed()) {
    check.library = library;
    line.command = std::move(check);
  } else if (new_command.parsed()) {
    fresh.folder = folder;
    line.command = std::move(fresh);
  } else {
    window.files = paths;
    window.script = script;
    if (!window_size.empty()) window.size = parse_size(window_size);
    line.command = std::move(window);
  }
  return line;
}

}  // namespace lumenshop
