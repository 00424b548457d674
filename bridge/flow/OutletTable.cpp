#include "bridge/flow/OutletTable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "tissue/parameters/Shown.h"

namespace restenosis {
namespace {

/// How far shares may be from 1 together (assumed: what rounding leaves).
constexpr double roundedShares = 1e-3;

/// What beds of these resistances take, if the vessel itself had none.
void shareByResistance(std::vector<Outlet>& outlets) {
  for (Outlet& outlet : outlets) outlet.share = 1 / outlet.resistance;
}

}  // namespace

std::vector<Outlet> readOutlets(const std::filesystem::path& file) {
  CsvLines lines(file);
  // A name may hold commas
  const auto name = [&] { return cellOf(lines.text().substr(0, lines.text().rfind(','))); };
  std::string_view column;
  if (lines.next()) {
    column = lines.cells().back() == "share" ? "share" : "resistance";
    if (name() != "solid" || lines.cells().back() != column)
      lines.fail(
          fmt::format("{} is no header of a table of outlets; it must be 'solid,share' or "
                      "'solid,resistance'",
                      shown(lines.text())));
  }
  std::vector<Outlet> outlets;
  while (lines.next()) {
    const auto value = finiteNumber(lines.cells().back());
    if (lines.cells().size() < 2 || name().empty() || !value || !(*value > 0))
      lines.fail(fmt::format("{} is not the name of a solid and a positive {}, with a comma between",
                             shown(lines.text()), column));
    if (std::ranges::any_of(outlets, [&](const Outlet& other) { return other.name == name(); }))
      lines.fail(fmt::format("the solid '{}' is there twice", name()));
    if (outlets.size() == mostOutlets) lines.fail(fmt::format("more than {} outlets", mostOutlets));
    Outlet& outlet = outlets.emplace_back(Outlet{.name = std::string(name())});
    (column == "share" ? outlet.share : outlet.resistance) = *value;
  }
  if (outlets.size() < 2)
    lines.failWhole(fmt::format("holds {} outlets; a lumen with one needs no table", outlets.size()));
  if (column == "resistance") shareByResistance(outlets);
  double sum = 0;
  for (const Outlet& outlet : outlets) sum += outlet.share;
  if (column == "share" && std::abs(sum - 1) > roundedShares)
    lines.failWhole(fmt::format("the shares are {:.6g} together; they must be 1", sum));
  for (Outlet& outlet : outlets) outlet.share /= sum;
  std::ranges::sort(outlets, {}, &Outlet::name);
  return outlets;
}

}  // namespace restenosis
