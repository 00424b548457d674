#include "tissue/vessel/TablePlaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace restenosis {
namespace {

/// Distance of two agents over the sum of their radii: assumed.
constexpr double samePlace = 1e-6;

}  // namespace

void requireDistinctPlaces(const AgentTable& table) {
  const AgentStore& agents = table.agents;
  // Along a direction in which no regular arrangement has layers, so that few agents are near each other.
  const Vec3 along = Vec3(0.5126, 0.6137, 0.6005).normalized();
  std::vector<double> place(agents.size());
  for (Index i = 0; i < agents.size(); ++i) place[i] = along.dot(agents.position(i));
  std::vector<Index> order(agents.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::sort(order, {}, [&place](Index i) { return std::pair(place[i], i); });
  const double reachAhead = 2 * samePlace * std::ranges::max(agents.radius);
  std::optional<std::pair<Index, Index>> found;  // later and earlier of the first pair
  for (std::size_t n = 0; n < order.size(); ++n) {
    for (std::size_t m = n + 1; m < order.size() && place[order[m]] - place[order[n]] <= reachAhead; ++m) {
      const auto [earlier, later] = std::minmax(order[n], order[m]);
      const double apart = (agents.position(earlier) - agents.position(later)).norm();
      if (apart > samePlace * (agents.radius[earlier] + agents.radius[later])) continue;
      if (!found || std::pair(later, earlier) < *found) found = {later, earlier};
    }
  }
  if (!found) return;
  table.fail(found->first, fmt::format("the agent is at the place of the one in line {}; no two may be "
                                       "nearer than a millionth of their radii",
                                       table.lines[found->second]));
}

}  // namespace restenosis
