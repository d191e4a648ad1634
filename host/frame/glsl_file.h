/// One shader file: its file-scope items, and how they are put into a program that holds other files, too.
///
/// Every name that the file declares at file scope gets a prefix of its own, so that two plugins may both call a helper
/// `rotate`. Only what an entry function reaches is emitted, so one file can hold the functions of several passes.
#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "frame/glsl_tokens.h"

namespace lumenshop {

/// #line directives carry the file in the line: file number * this + line. Drivers drop the directive's own file number
/// in some messages (Mesa, for expressions). No file has as many lines.
constexpr int lines_per_file = 1 << 20;

class GlslFile {
 public:
  enum class Stage { any, vertex, fragment };

  /// `name` as in messages ("diffuse/lambert.glsl"). Throws lumen::Error (name:line: what) if braces do not match.
  GlslFile(std::string name, std::string source);
  GlslFile(const GlslFile&) = delete;

  const std::string& name() const { return name_; }
  /// Files of shaders/lib that it asks for by #include "lib/...".
  const std::vector<std::string>& includes() const { return includes_; }
  bool declares(std::string_view function) const;
  bool mentions(std::string_view identifier) const { return mentioned_.contains(identifier); }

  /// The items of `stage` (and of any) that `entries` reach, renamed with `prefix`; `Properties` becomes
  /// prefix + "Properties". `number` is the file's in #line directives, from 1. Empty entries: everything, not renamed (lib files).
  std::string emit(Stage stage, std::span<const std::string_view> entries, std::string_view prefix, int number) const;

 private:
  struct Item {
    std::size_t begin, end;                 ///< tokens
    Stage stage;
    std::vector<std::string_view> names;    ///< what it declares; empty: always emitted
    std::set<std::string_view> uses;
    int line;
  };
  void parse();
  void read_directive(const GlslToken& token, std::size_t index, Stage& stage);
  Item read_item(std::size_t begin, std::size_t end, Stage stage) const;
  std::string text_of(const Item& item, const std::set<std::string_view>& renamed, std::string_view prefix) const;

  std::string name_, source_;
  std::vector<GlslToken> tokens_;
  std::vector<Item> items_;
  std::vector<std::string> includes_;
  std::set<std::string_view, std::less<>> mentioned_;
};

}  // namespace lumenshop
