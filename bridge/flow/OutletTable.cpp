#include "bridge/flow/OutletTable.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include "tissue/parameters/Trimmed.h"

namespace restenosis {
namespace {

constexpr std::string_view around = " \t\r\"";
/// How far shares may be from 1 together (assumed: what rounding leaves).
constexpr double roundedShares = 1e-3;

std::optional<double> positive(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool read = error == std::errc() && end == text.data() + text.size();
  return read && std::isfinite(value) && value > 0 ? std::optional(value) : std::nullopt;
}

/// What beds of these resistances take, if the vessel itself had none.
void shareByResistance(std::vector<Outlet>& outlets) {
  for (Outlet& outlet : outlets) outlet.share = 1 / outlet.resistance;
}

}  // namespace

std::vector<Outlet> readOutlets(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw OutletTableError(fmt::format("{}: cannot be opened", file.string()));
  std::size_t line = 0;
  const auto fail = [&](const std::string& message) {
    throw OutletTableError(fmt::format("{}:{}: {}", file.string(), line, message));
  };
  std::vector<Outlet> outlets;
  std::string_view column;
  for (std::string text; std::getline(stream, text);) {
    ++line;
    const std::string_view content = trimmed(std::string_view(text).substr(0, text.find('#')), around);
    if (content.empty()) continue;
    const auto comma = content.rfind(',');
    const std::string_view name = trimmed(content.substr(0, comma), around);
    const std::string_view last =
        comma == std::string_view::npos ? std::string_view() : trimmed(content.substr(comma + 1), around);
    if (column.empty()) {
      column = last == "share" ? "share" : "resistance";
      if (name != "solid" || last != column)
        fail(
            fmt::format("'{}' is no header of a table of outlets; it must be 'solid,share' or "
                        "'solid,resistance'",
                        content));
      continue;
    }
    const auto value = positive(last);
    if (name.empty() || !value)
      fail(fmt::format("'{}' is not the name of a solid and a positive {}, with a comma between", content,
                       column));
    if (std::ranges::any_of(outlets, [&](const Outlet& other) { return other.name == name; }))
      fail(fmt::format("the solid '{}' is there twice", name));
    if (outlets.size() == mostOutlets) fail(fmt::format("more than {} outlets", mostOutlets));
    Outlet& outlet = outlets.emplace_back(Outlet{.name = std::string(name)});
    (column == "share" ? outlet.share : outlet.resistance) = *value;
  }
  if (outlets.size() < 2)
    throw OutletTableError(
        fmt::format("{}: holds {} outlets; a lumen with one needs no table", file.string(), outlets.size()));
  if (column == "resistance") shareByResistance(outlets);
  double sum = 0;
  for (const Outlet& outlet : outlets) sum += outlet.share;
  if (column == "share" && std::abs(sum - 1) > roundedShares)
    throw OutletTableError(
        fmt::format("{}: the shares are {:.6g} together; they must be 1", file.string(), sum));
  for (Outlet& outlet : outlets) outlet.share /= sum;
  std::ranges::sort(outlets, {}, &Outlet::name);
  return outlets;
}

}  // namespace restenosis
