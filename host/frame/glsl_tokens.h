/// GLSL text as tokens: enough to see names, nesting and lines; never more than the compiler needs to be told.
#pragma once

#include <string_view>
#include <vector>

namespace lumenshop {

struct GlslToken {
  enum class Type { identifier, number, symbol, directive, space };
  Type type;
  std::string_view text;  ///< into the source; a directive is the whole logical line; comments are space
  int line;               ///< from 1

  bool is(std::string_view other) const { return text == other; }
};

/// All of the source: joined together, the texts are the source again.
std::vector<GlslToken> tokenize_glsl(std::string_view source);

}  // namespace lumenshop
