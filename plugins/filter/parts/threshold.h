/// What divides thick from thin.
#pragma once

#include <optional>
#include <span>

/// The thickness that parts the histogram of logarithms best in two classes, each value counted by its weight; nothing if the means of the two
/// differ by less than a factor of `least`. Values that are not above 0 do not count.
/// Otsu, A Threshold Selection Method from Gray-Level Histograms, IEEE Trans. Systems, Man and Cybernetics 9(1), 1979.
std::optional<float> dividing_thickness(std::span<const float> values, std::span<const float> weights, float least);
