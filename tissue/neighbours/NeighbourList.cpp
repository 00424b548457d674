#include "NeighbourList.h"

#include <algorithm>

#include "CellGrid.h"
#include "NeighbourQuery.h"

namespace restenosis {

void NeighbourList::build(const AgentStore& agents, const NeighbourRange& range) {
  const Index count = agents.size();
  const double widestFactor = std::max(range.factor, range.daughterFactor);
  const double largestRadius = NeighbourQuery::largestRadius(agents);
  const double widest = 2 * widestFactor * largestRadius + range.skin;
  const CellGrid grid(agents, widest > 0 ? widest : 1.0);

  constexpr Index chunk = 512;
  const auto chunks = static_cast<std::ptrdiff_t>((count + chunk - 1) / chunk);
  std::vector<std::vector<Index>> parts(chunks);
  positions_.resize(count);
  start_.assign(count + std::size_t{1}, 0);

#pragma omp parallel for schedule(dynamic)
  for (std::ptrdiff_t c = 0; c < chunks; ++c) {
    auto& part = parts[c];
    const auto begin = static_cast<Index>(c) * chunk;
    for (Index i = begin; i < std::min(count, begin + chunk); ++i) {
      positions_[i] = agents.position(i);
      const auto first = static_cast<std::ptrdiff_t>(part.size());
      const double radius = agents.radius[i];
      const bool daughter = agents.has(i, AgentFlag::daughter);
      grid.forEachCandidate(
          positions_[i], widestFactor * (radius + largestRadius) + range.skin, [&](Index j) {
            const double dx = agents.x[j] - positions_[i].x();
            const double dy = agents.y[j] - positions_[i].y();
            const double dz = agents.z[j] - positions_[i].z();
            const double factor =
                daughter || agents.has(j, AgentFlag::daughter) ? range.daughterFactor : range.factor;
            const double reach = factor * (radius + agents.radius[j]) + range.skin;
            if (dx * dx + dy * dy + dz * dz <= reach * reach && j != i) part.push_back(j);
          });
      std::sort(part.begin() + first, part.end());
      start_[i + 1] = part.size() - static_cast<std::size_t>(first);
    }
  }

  for (Index i = 0; i < count; ++i) start_[i + 1] += start_[i];
  neighbours_.resize(start_[count]);
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t c = 0; c < chunks; ++c) {
    std::copy(parts[c].begin(), parts[c].end(),
              neighbours_.begin() + static_cast<std::ptrdiff_t>(start_[static_cast<Index>(c) * chunk]));
  }
  largestMove_ = range.skin / 2;
}

bool NeighbourList::needsRebuild(const AgentStore& agents) const {
  if (agents.size() != size()) return true;
  for (Index i = 0; i < agents.size(); ++i) {
    if (movedTooFar(i, agents.position(i))) return true;
  }
  return false;
}

}  // namespace restenosis
