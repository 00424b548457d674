#include "bridge/compare/ProbeTable.h"

#include <fmt/format.h>

#include <string_view>

#include "tissue/parameters/LengthUnits.h"
#include "tissue/parameters/Shown.h"

namespace restenosis {
namespace {

constexpr std::string_view columns = "x_mm,y_mm,z_mm";

Vec3 pointOf(const CsvLines& lines) {
  const auto cells = lines.cells();
  Vec3 point;
  bool isPoint = cells.size() == 3;
  for (int axis = 0; axis < 3 && isPoint; ++axis) {
    const auto number = finiteNumber(cells[static_cast<std::size_t>(axis)]);
    isPoint = number.has_value();
    point[axis] = number.value_or(0);
  }
  if (!isPoint) lines.fail(fmt::format("{} is not three numbers between commas", shown(lines.text())));
  return mm * point;
}

}  // namespace

std::vector<Vec3> readProbes(const std::filesystem::path& file) {
  CsvLines lines(file);
  std::vector<Vec3> points;
  if (lines.next() && lines.text() != columns)
    lines.fail(fmt::format("the first line is {}; it must be {}", shown(lines.text()), columns));
  while (lines.next()) points.push_back(pointOf(lines));
  if (points.empty()) lines.failWhole("holds no points");
  return points;
}

}  // namespace restenosis
