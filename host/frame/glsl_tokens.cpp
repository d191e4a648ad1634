#include "frame/glsl_tokens.h"

#include <algorithm>
#include <cctype>

namespace lumenshop {
namespace {

bool starts_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool continues_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

}  // namespace

std::vector<GlslToken> tokenize_glsl(std::string_view source) {
  using Type = GlslToken::Type;
  std::vector<GlslToken> tokens;
  std::size_t at = 0;
  int line = 1;
  bool line_start = true;
  const auto starts = [&](std::string_view text) { return source.substr(at).starts_with(text); };
  const auto take = [&](Type type, std::size_t end) {
    const std::string_view text = source.substr(at, end - at);
    tokens.push_back({type, text, line});
    line += int(std::count(text.begin(), text.end(), '\n'));
    at = end;
  };
  while (at < source.size()) {
    const char c = source[at];
    if (starts("//")) {
      take(Type::space, std::min(source.find('\n', at), source.size()));
    } else if (starts("/*")) {
      const std::size_t end = source.find("*/", at + 2);
      take(Type::space, end == source.npos ? source.size() : end + 2);
    } else if (std::isspace(static_cast<unsigned char>(c))) {
      line_start = line_start || c == '\n';
      take(Type::space, at + 1);
    } else if (c == '#' && line_start) {
      std::size_t end = at;
      do {
        end = std::min(source.find('\n', end + 1), source.size());
      } while (end < source.size() && source[end - 1] == '\\');
      take(Type::directive, end);
    } else if (starts_name(c)) {
      std::size_t end = at + 1;
      while (end < source.size() && continues_name(source[end])) ++end;
      take(Type::identifier, end);
      line_start = false;
    } else if (std::isdigit(static_cast<unsigned char>(c)) ||
               (c == '.' && at + 1 < source.size() && std::isdigit(static_cast<unsigned char>(source[at + 1])))) {
      std::size_t end = at + 1;
      while (end < source.size() && (continues_name(source[end]) || source[end] == '.' ||
                                     ((source[end] == '+' || source[end] == '-') && (source[end - 1] == 'e' || source[end - 1] == 'E'))))
        ++end;
      take(Type::number, end);
      line_start = false;
    } else {
      take(Type::symbol, at + 1);
      line_start = false;
    }
  }
  return tokens;
}

}  // namespace lumenshop
