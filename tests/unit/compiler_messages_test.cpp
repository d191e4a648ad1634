/// What compilers, linkers and CMake print becomes problems with a place.
#include <gtest/gtest.h>

#include "modules/compiler_messages.h"

namespace {

using lumen::Problem;
using lumen::Severity;

std::vector<Problem> parse(std::string_view text) { return lumenshop::parse_compiler_messages(text, "/build"); }

TEST(CompilerMessages, HaveFileLineAndColumn) {
  const std::vector<Problem> problems = parse(
      "[1/2] Building CXX object plugins/x.o\n"
      "FAILED: plugins/x.o\n"
      "In file included from /src/a.h:3,\n"
      "                 from /src/x.cpp:1:\n"
      "/src/x.cpp: In function 'int f()':\n"
      "/src/x.cpp:12:7: error: 'strenght' was not declared; did you mean 'strength'?\n"
      "   12 |   strenght = 1;\n"
      "/src/a.h:3:10: fatal error: lumen/nothing.h: No such file or directory\n"
      "/src/x.cpp:14:1: warning: no return statement [-Wreturn-type]\n"
      "/src/x.cpp:15:2: note: declared here\n"
      "ninja: build stopped: subcommand failed.\n");
  ASSERT_EQ(problems.size(), 3u);
  EXPECT_EQ(problems[0], (Problem{Severity::error, "", "/src/x.cpp", 12, 7, "'strenght' was not declared; did you mean 'strength'?"}));
  EXPECT_EQ(problems[1], (Problem{Severity::error, "", "/src/a.h", 3, 10, "lumen/nothing.h: No such file or directory"}));
  EXPECT_EQ(problems[2].severity, Severity::warning);
}

TEST(CompilerMessages, MayLackAColumnOrAFile) {
  const std::vector<Problem> problems = parse("../plugins/x.cpp:9: error: unterminated #if\nmold: error: undefined symbol: f()\n");
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_EQ(problems[0], (Problem{Severity::error, "", "/plugins/x.cpp", 9, 0, "unterminated #if"}));
  EXPECT_EQ(problems[1], (Problem{Severity::error, "", "", 0, 0, "mold: undefined symbol: f()"}));
}

TEST(CompilerMessages, AreReadWithoutTheirColors) {
  const std::vector<Problem> problems = parse("\x1b[01m\x1b[K/src/x.cpp:1:2:\x1b[m\x1b[K \x1b[01;31m\x1b[Kerror: \x1b[m\x1b[Ktoo red\n");
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].message, "too red");
  EXPECT_EQ(problems[0].column, 2);
}

TEST(CompilerMessages, OfCMakeHaveTheirTextBelow) {
  const std::vector<Problem> problems = parse("CMake Error at plugins/CMakeLists.txt:7 (add_library):\n\n  Cannot find source file:\n\n    x.cpp\n");
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0], (Problem{Severity::error, "", "/build/plugins/CMakeLists.txt", 7, 0, "Cannot find source file:"}));
}

TEST(CompilerMessages, AreShownOnce) { EXPECT_EQ(parse("/x.cpp:1:1: error: twice\n/x.cpp:1:1: error: twice").size(), 1u); }

TEST(CompilerMessages, MayBeAnything) {
  EXPECT_TRUE(parse("").empty());
  EXPECT_TRUE(parse("::: error \x1b").empty());
  EXPECT_EQ(parse(": error: nobody").size(), 1u);
  EXPECT_TRUE(parse(std::string(100000, ':')).empty());
}

}  // namespace
