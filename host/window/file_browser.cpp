#include "window/file_browser.h"

#include <algorithm>
#include <cfloat>

#include <imgui.h>
#include <imgui_stdlib.h>

#include <lumen/ui/icons.h>
#include <lumen/ui/look.h>
#include <lumen/ui/text_field.h>

namespace lumenshop {
namespace {

constexpr std::size_t most_entries = 20'000;

std::string size_text(std::uintmax_t bytes) {
  const char* units[] = {"B", "KiB", "MiB", "GiB"};
  double size = static_cast<double>(bytes);
  int unit = 0;
  while (size >= 1024 && unit < 3) size /= 1024, ++unit;
  char text[32];
  std::snprintf(text, sizeof text, unit == 0 ? "%.0f %s" : "%.1f %s", size, units[unit]);
  return text;
}

}  // namespace

void FileBrowser::open(std::string title, const std::filesystem::path& from, std::vector<std::string> extensions, Answer answer) {
  title_ = std::move(title);
  extensions_ = std::move(extensions);
  answer_ = std::move(answer);
  saving_ = false;
  open_ = appears_ = true;
  std::error_code error;
  if (std::filesystem::is_directory(from, error)) go(from);
  else if (from.has_parent_path() && std::filesystem::is_directory(from.parent_path(), error)) go(from.parent_path());
  else go(std::filesystem::current_path(error));
}

void FileBrowser::save(std::string title, const std::filesystem::path& from, const std::string& name, const std::string& extension, Answer answer) {
  open(std::move(title), from, {extension}, std::move(answer));
  saving_ = true;
  name_ = name;
}

bool FileBrowser::fits(const std::filesystem::path& file) const {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extensions_.empty() || std::find(extensions_.begin(), extensions_.end(), extension) != extensions_.end();
}

void FileBrowser::go(const std::filesystem::path& folder) {
  std::error_code error;
  const auto absolute = std::filesystem::weakly_canonical(folder, error);
  std::vector<Entry> entries;
  auto iterator = std::filesystem::directory_iterator(absolute, std::filesystem::directory_options::skip_permission_denied, error);
  if (error) {
    failure_ = absolute.string() + ": " + error.message();
    return;
  }
  for (const auto end = std::filesystem::directory_iterator(); iterator != end && entries.size() < most_entries; iterator.increment(error)) {
    if (error) break;
    const auto& path = iterator->path();
    const std::string name = path.filename().string();
    const bool is_folder = iterator->is_directory(error);
    if (name.starts_with('.') || (!is_folder && (!iterator->is_regular_file(error) || !fits(path)))) continue;
    entries.push_back({name, is_folder, is_folder ? 0 : iterator->file_size(error)});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.folder != b.folder ? a.folder : a.name < b.name; });
  folder_ = absolute;
  entries_ = std::move(entries);
  failure_.clear();
  filter_.clear();
}

void FileBrowser::finish(const std::filesystem::path& file) {
  open_ = false;
  ImGui::CloseCurrentPopup();
  const Answer answer = std::move(answer_);
  answer_ = nullptr;
  if (answer) answer(file);
}

void FileBrowser::draw_list() {
  const lumen::ui::Look& look = lumen::ui::look();
  std::filesystem::path chosen_folder;
  std::string chosen_file;
  ImGui::BeginChild("entries", {0, -ImGui::GetFrameHeightWithSpacing() * (saving_ ? 2.3f : 1.3f)});
  for (const Entry& entry : entries_) {
    if (!lumen::ui::matches(entry.name, filter_)) continue;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetTextLineHeight();
    if (ImGui::Selectable(("##" + entry.name).c_str(), saving_ && entry.name == name_)) {
      if (entry.folder) chosen_folder = folder_ / entry.name;
      else if (saving_) name_ = entry.name;
      else chosen_file = entry.name;
    }
    lumen::ui::record(entry.name);
    ImDrawList* list = ImGui::GetWindowDrawList();
    lumen::ui::draw_icon(list, entry.folder ? lumen::ui::Icon::folder : lumen::ui::Icon::file, {corner.x, corner.y + look(1)}, look(13), look.colors.label);
    const float width = ImGui::GetContentRegionAvail().x;
    lumen::ui::text_elided(list, {corner.x + look(20), corner.y}, width - look(120), entry.name, look.colors.text);
    if (!entry.folder) {
      const std::string size = size_text(entry.bytes);
      list->AddText({corner.x + width - ImGui::CalcTextSize(size.c_str()).x, corner.y + (height - ImGui::GetFontSize()) / 2}, look.colors.dim, size.c_str());
    }
  }
  if (entries_.empty()) lumen::ui::text("nothing here that fits", look.colors.dim);
  ImGui::EndChild();
  if (!chosen_folder.empty()) go(chosen_folder);
  else if (!chosen_file.empty()) finish(folder_ / chosen_file);
}

void FileBrowser::draw() {
  if (!open_) return;
  const lumen::ui::Look& look = lumen::ui::look();
  const std::string name = title_ + "###file browser";
  if (appears_) ImGui::OpenPopup(name.c_str());
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(look(720), window.x - look(20)), std::min(look(520), window.y - look(20))});
  bool stays = true;
  if (!ImGui::BeginPopupModal(name.c_str(), &stays, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings)) {
    open_ = false;
    return;
  }
  lumen::ui::look().panel = "files";
  if (lumen::ui::icon_button("up", lumen::ui::Icon::up, ImGui::GetFrameHeight(), look.colors.label, "the folder above")) go(folder_.parent_path());
  ImGui::SameLine();
  std::string typed = folder_.string();
  if (lumen::ui::text_field("##folder", typed, ImGui::GetContentRegionAvail().x - look(180), "", true)) {
    std::error_code error;
    if (!saving_ && std::filesystem::is_regular_file(typed, error)) finish(typed);
    else go(typed);
  }
  lumen::ui::record("folder");
  ImGui::SameLine();
  if (appears_ && !saving_) ImGui::SetKeyboardFocusHere();
  lumen::ui::search_field("filter", filter_, -FLT_MIN, "Filter");
  if (!failure_.empty()) lumen::ui::text(failure_, look.colors.error);
  if (open_) draw_list();
  if (open_ && saving_) {
    if (appears_) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-FLT_MIN);
    const bool entered = ImGui::InputTextWithHint("##save as", "name", &name_, ImGuiInputTextFlags_EnterReturnsTrue);
    lumen::ui::record("name");
    const bool clicked = ImGui::Button("Save") || entered;
    lumen::ui::record("save");
    if (clicked && !name_.empty()) {
      std::filesystem::path file = folder_ / name_;
      if (!file.has_extension() && !extensions_.empty()) file += extensions_.front();
      finish(file);
    }
    ImGui::SameLine();
  }
  if (open_ && (ImGui::Button("Cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false) || !stays)) {
    open_ = false;
    ImGui::CloseCurrentPopup();
  }
  appears_ = false;
  ImGui::EndPopup();
}

}  // namespace lumenshop
