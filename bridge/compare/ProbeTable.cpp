#include "bridge/compare/ProbeTable.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include "tissue/parameters/LengthUnits.h"
#include "tissue/parameters/Shown.h"
#include "tissue/parameters/Trimmed.h"

namespace restenosis {
namespace {

constexpr std::string_view columns = "x_mm,y_mm,z_mm", blanks = " \t\r\"";

/// Three finite numbers between commas.
std::optional<Vec3> pointOf(std::string_view line) {
  Vec3 point;
  for (int axis = 0; axis < 3; ++axis) {
    const auto comma = line.find(',');
    if ((comma == std::string_view::npos) != (axis == 2)) return {};
    const std::string_view cell = trimmed(line.substr(0, comma), blanks);
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), point[axis]);
    if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(point[axis])) return {};
    line.remove_prefix(axis == 2 ? line.size() : comma + 1);
  }
  return point;
}

}  // namespace

std::vector<Vec3> readProbes(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw ProbeTableError(fmt::format("{}: cannot be opened", file.string()));
  std::vector<Vec3> points;
  bool header = true;
  std::size_t number = 0;
  for (std::string text; std::getline(stream, text);) {
    ++number;
    const std::string_view line = trimmed(std::string_view(text).substr(0, text.find('#')), blanks);
    if (line.empty()) continue;
    if (header) {
      if (line != columns)
        throw ProbeTableError(fmt::format("{}:{}: the first line is {}; it must be {}", file.string(), number,
                                          shown(line), columns));
      header = false;
      continue;
    }
    const auto point = pointOf(line);
    if (!point)
      throw ProbeTableError(
          fmt::format("{}:{}: {} is not three numbers between commas", file.string(), number, shown(line)));
    points.push_back(mm * *point);
  }
  if (points.empty()) throw ProbeTableError(fmt::format("{}: holds no points", file.string()));
  return points;
}

}  // namespace restenosis
