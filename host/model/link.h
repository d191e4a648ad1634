/// A link: the source that drives a property, as it is or through an expression per component.
#pragma once

#include <memory>
#include <string>

#include <lumen/value.h>

namespace lumenshop {

/// A muParser formula of x (the source's component), i (its index) and the usual functions; at most 1024 characters.
class Expression {
 public:
  /// Throws lumen::Error with the place in the text.
  explicit Expression(std::string text);
  ~Expression();
  double operator()(double x, int component) const;  ///< throws lumen::Error if the result is not finite
  const std::string& text() const { return text_; }

 private:
  struct Parser;
  std::string text_;
  std::unique_ptr<Parser> parser_;
};

struct Link {
  std::string instance, property;          ///< the source; it may not be there (yet)
  std::unique_ptr<Expression> expression;  ///< null = identity: writes go to the source
  std::string path() const { return instance + "." + property; }
};

}  // namespace lumenshop
