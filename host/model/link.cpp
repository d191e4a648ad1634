#include "model/link.h"

#include <cmath>

#include <muParser.h>

#include <lumen/error.h>

namespace lumenshop {

struct Expression::Parser {
  double x = 1, i = 0;
  mu::Parser formula;
};

namespace {

constexpr std::size_t longest = 1024;

lumen::Error explained(const std::string& text, const mu::ParserError& error) {
  // muParser counts from 0 and says -1 (as a huge number) when it knows no place.
  const auto position = static_cast<std::size_t>(error.GetPos());
  const std::string where = position <= text.size() ? "expression '" + text + "', column " + std::to_string(position + 1) : "expression '" + text + "'";
  return lumen::Error(where, error.GetMsg(), "use x (the source's component), i (its index), numbers and functions such as sin, min, sqrt");
}

}  // namespace

Expression::Expression(std::string text) : text_(std::move(text)) {
  if (text_.size() > longest)
    throw lumen::Error("expression '" + text_.substr(0, 32) + "...'", "longer than " + std::to_string(longest) + " characters");
  parser_ = std::make_unique<Parser>();
  try {
    parser_->formula.DefineVar("x", &parser_->x);
    parser_->formula.DefineVar("i", &parser_->i);
    parser_->formula.SetExpr(text_);
    parser_->formula.Eval();  // compiles it: mistakes show now
    if (parser_->formula.GetNumResults() != 1) throw lumen::Error("expression '" + text_ + "'", "gives several results; one is wanted");
  } catch (const mu::ParserError& error) {
    throw explained(text_, error);
  }
}

Expression::~Expression() = default;

double Expression::operator()(double x, int component) const {
  parser_->x = x;
  parser_->i = component;
  double result = 0;
  try {
    result = parser_->formula.Eval();
  } catch (const mu::ParserError& error) {
    throw explained(text_, error);
  }
  if (!std::isfinite(result))
    throw lumen::Error("expression '" + text_ + "'", "gives no finite number for x = " + std::to_string(x));
  return result;
}

}  // namespace lumenshop
