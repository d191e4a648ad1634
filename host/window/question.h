/// A modal question with a few answers.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace lumenshop {

class Question {
 public:
  struct Answer {
    std::string label;
    std::function<void()> action = {};  ///< empty: nothing happens
  };
  /// The first answer is taken by Enter, the last by Esc.
  void ask(std::string title, std::string text, std::vector<Answer> answers);
  bool is_open() const { return !answers_.empty(); }
  void draw();

 private:
  std::string title_, text_;
  std::vector<Answer> answers_;
  bool appears_ = false;
};

}  // namespace lumenshop
