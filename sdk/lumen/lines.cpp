/// Polylines: checks and bounds.
#include <lumen/lines.h>

#include <checks/data_check.h>
#include <lumen/error.h>

namespace lumen {

std::size_t Lines::bytes() const {
  return positions.view().size_bytes() + offsets.view().size_bytes() + detail::bytes_of(attributes);
}

Bounds Lines::bounds() const { return bounds_; }

std::string Lines::summary() const { return grouped(count()) + " lines, " + grouped(positions.size()) + " points"; }

std::span<const glm::vec3> Lines::line(std::size_t index) const {
  return positions.view().subspan(offsets[index], offsets[index + 1] - offsets[index]);
}

void Lines::finish() {
  const auto fail = [&](const std::string& what) { throw Error(detail::name_of_origin(*this), what); };
  const Bounds bounds = detail::checked_bounds(*this, positions);
  if (offsets.empty() && !positions.empty()) fail("points without offsets of lines");
  if (!offsets.empty()) {
    if (offsets[0] != 0) fail("the first line does not begin at point 0");
    for (std::size_t line = 0; line + 1 < offsets.size(); ++line)
      if (offsets[line] > offsets[line + 1]) fail("line " + grouped(line) + " ends before it begins");
    if (offsets[offsets.size() - 1] != positions.size())
      fail("the lines end at point " + grouped(offsets[offsets.size() - 1]) + " of " + grouped(positions.size()));
  }
  detail::check_attributes(*this, attributes, positions.size(), count(), true);
  bounds_ = bounds;
}

}  // namespace lumen
