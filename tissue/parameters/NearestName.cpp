#include "tissue/parameters/NearestName.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "tissue/parameters/NameList.h"

namespace restenosis {
namespace {

bool sameLetter(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

/// Optimal string alignment distance.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replace = sameLetter(a[i - 1], b[j - 1]) ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + replace});
      if (i > 1 && j > 1 && sameLetter(a[i - 1], b[j - 2]) && sameLetter(a[i - 2], b[j - 1])) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

std::string nearestName(std::string_view name, const std::vector<std::string_view>& allowed) {
  constexpr std::size_t longestCompared = 200;  // a longer name is no typing error
  if (name.size() > longestCompared) return {};
  std::string_view best;
  std::size_t fewest = std::string_view::npos;
  for (const auto candidate : allowed) {
    const std::size_t count = edits(name, candidate);
    if (count < fewest) best = candidate, fewest = count;
  }
  const bool near = fewest <= std::max<std::size_t>(2, best.size() / 3) && fewest < best.size();
  return near ? std::string(best) : std::string();
}

std::string suggestion(std::string_view name, const std::vector<std::string_view>& allowed) {
  const std::string nearest = nearestName(name, allowed);
  return fmt::format("{} Allowed: {}", nearest.empty() ? "." : fmt::format("; did you mean '{}'?", nearest),
                     commaSeparated(allowed));
}

}  // namespace restenosis
