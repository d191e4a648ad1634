#include "window/fonts.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <string>

#include <imgui.h>
#include <imgui_freetype.h>

namespace lumenshop {
namespace {

constexpr float text_size = 16, mono_size = 17;  // equal x-heights

/// The first of the files that lies in one of the folders where systems keep fonts; empty if none does.
std::filesystem::path find_font(std::initializer_list<const char*> files) {
  constexpr std::array folders = {"/usr/share/fonts/opentype/inter", "/usr/share/fonts/truetype/inter", "/usr/share/fonts/truetype/jetbrains-mono",
                                  "/usr/share/fonts/inter", "/usr/share/fonts/jetbrains-mono", "/usr/local/share/fonts",
                                  "/usr/share/fonts/truetype/dejavu", "/usr/share/fonts/truetype/liberation"};
  std::error_code error;
  for (const char* file : files)
    for (const char* folder : folders)
      if (const auto path = std::filesystem::path(folder) / file; std::filesystem::is_regular_file(path, error)) return path;
  return {};
}

ImFont* add(const std::filesystem::path& file, float pixels) {
  // Latin, the Greek of units, and the few signs that the window writes. Kept by the atlas until it is built.
  static constexpr ImWchar ranges[] = {0x20, 0x17F, 0x391, 0x3C9, 0x2010, 0x2026, 0x2190, 0x2193, 0x2264, 0x2265, 0};
  ImFontConfig config;
  config.GlyphRanges = ranges;
  config.SizePixels = std::round(pixels);
  config.OversampleH = 1;
  ImFontAtlas* atlas = ImGui::GetIO().Fonts;
  return file.empty() ? atlas->AddFontDefault(&config) : atlas->AddFontFromFileTTF(file.c_str(), config.SizePixels, &config);
}

}  // namespace

void load_fonts(lumen::ui::Look& look) {
  ImFontAtlas* atlas = ImGui::GetIO().Fonts;
  atlas->Clear();
  atlas->FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  atlas->FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  atlas->Flags |= ImFontAtlasFlags_NoMouseCursors;
  look.text = add(find_font({"Inter-Regular.otf", "Inter-Regular.ttf", "DejaVuSans.ttf", "LiberationSans-Regular.ttf"}), look(text_size));
  look.heading = add(find_font({"Inter-SemiBold.otf", "Inter-SemiBold.ttf", "DejaVuSans-Bold.ttf", "LiberationSans-Bold.ttf"}), look(text_size));
  look.mono = add(find_font({"JetBrainsMono-Regular.ttf", "DejaVuSansMono.ttf", "LiberationMono-Regular.ttf"}), look(mono_size));
  atlas->Build();
}

}  // namespace lumenshop
