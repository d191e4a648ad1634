// Numbers in fields: dragging, typing, writing.
#include <gtest/gtest.h>

#include <lumen/ui/number.h>

namespace {

using namespace lumen::ui;

TEST(DraggingANumber, CoversItsRangeIn300Pixels) {
  const NumberRange range{.min = 10, .max = 40};
  EXPECT_DOUBLE_EQ(dragged(range, 10, 300, false), 40);
  EXPECT_DOUBLE_EQ(dragged(range, 20, 30, false), 23);
  EXPECT_DOUBLE_EQ(dragged(range, 20, -300, false), 10) << "clamped at its end";
}

TEST(DraggingANumber, MovesInLogarithmicSpaceWhereDeclared) {
  const NumberRange range{.min = 0.001, .max = 1, .logarithmic = true};
  EXPECT_NEAR(dragged(range, 0.001, 100, false), 0.01, 1e-9);
  EXPECT_NEAR(dragged(range, 0.1, 100, false), 1, 1e-9);
}

TEST(DraggingANumber, SnapsToItsStep) {
  const NumberRange range{.min = 0, .max = 1, .step = 0.25};
  EXPECT_DOUBLE_EQ(dragged(range, 0, 0.55 * 300, true), 0.5);
}

TEST(DraggingANumber, KeepsIntegersWhole) {
  EXPECT_DOUBLE_EQ(dragged({.min = 1, .max = 256, .integer = true}, 32, 1, false), 33);
}

TEST(DraggingANumber, WithoutARangeMovesByItsSize) {
  EXPECT_DOUBLE_EQ(dragged({}, 200, 50, false), 300);
  EXPECT_DOUBLE_EQ(dragged({}, 0, 50, false), 0.5) << "zero must not be a trap";
}

TEST(SteppingANumber, TakesARoundHundredthOfTheRange) {
  EXPECT_NEAR(stepped({.min = 0, .max = 2}, 1, 3), 1.03, 1e-12);
  EXPECT_DOUBLE_EQ(stepped({.min = 0, .max = 10, .integer = true}, 9, 5), 10);
}

TEST(WritingANumber, ShowsFourSignificantDigits) {
  EXPECT_EQ(written(0.35, false), "0.3500");
  EXPECT_EQ(written(40, false), "40.00");
  EXPECT_EQ(written(0.0512345, false), "0.05123");
  EXPECT_EQ(written(123456, false), "123456");
  EXPECT_EQ(written(0, false), "0.000");
  EXPECT_EQ(written(-1.5, false), "-1.500");
  EXPECT_EQ(written(32, true), "32");
  EXPECT_EQ(written(1.0e-7, false), "1.000e-07");
}

TEST(WritingANumber, ShowsAllDigitsWhileItIsTyped) {
  EXPECT_EQ(written_fully(0.1f, false), "0.1");
  EXPECT_EQ(written_fully(1.0f / 3, false), "0.33333334");
}

TEST(TypingANumber, TakesArithmetic) {
  EXPECT_DOUBLE_EQ(calculated("2*(1+0.5)").value(), 3);
  EXPECT_DOUBLE_EQ(calculated("-2^2").value(), -4);
  EXPECT_DOUBLE_EQ(calculated(" 1 - 2 - 3 ").value(), -4);
  EXPECT_DOUBLE_EQ(calculated("8/2/2").value(), 2);
  EXPECT_NEAR(calculated("2*pi").value(), 6.283185307, 1e-9);
  EXPECT_DOUBLE_EQ(calculated("1e-3").value(), 0.001);
}

TEST(TypingANumber, RefusesWhatIsNone) {
  for (const char* text : {"", "abc", "1+", "(1", "1)", "1/0", "0/0", "1 2", "nan", "--"}) EXPECT_FALSE(calculated(text)) << text;
  EXPECT_FALSE(calculated(std::string(100, '(') + "1" + std::string(100, ')'))) << "depth is bounded";
}

TEST(ANumbersBar, ShowsItsPlaceInTheRange) {
  EXPECT_DOUBLE_EQ(place_of({.min = 0, .max = 4}, 1).value(), 0.25);
  EXPECT_NEAR(place_of({.min = 0.01, .max = 1, .logarithmic = true}, 0.1).value(), 0.5, 1e-9);
  EXPECT_FALSE(place_of({}, 1)) << "an open range has no place";
}

}  // namespace
