/// Chooses a file to open or to save, inside the window.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace lumenshop {

class FileBrowser {
 public:
  using Answer = std::function<void(const std::filesystem::path&)>;
  /// Opens at a file or folder (the working directory if it is neither). `extensions`: with their dots; empty = all files.
  void open(std::string title, const std::filesystem::path& from, std::vector<std::string> extensions, Answer answer);
  /// Asks for a name to save under; the extension is added if it lacks one.
  void save(std::string title, const std::filesystem::path& from, const std::string& name, const std::string& extension, Answer answer);
  /// Draws the dialog if it is open.
  void draw();
  bool is_open() const { return open_; }

 private:
  struct Entry {
    std::string name;
    bool folder = false;
    std::uintmax_t bytes = 0;
  };
  void go(const std::filesystem::path& folder);
  void draw_list();
  void finish(const std::filesystem::path& file);
  bool fits(const std::filesystem::path& file) const;

  bool open_ = false, appears_ = false, saving_ = false;
  std::string title_, filter_, name_, failure_;
  std::filesystem::path folder_;
  std::vector<std::string> extensions_;
  std::vector<Entry> entries_;
  Answer answer_;
};

}  // namespace lumenshop
