#include "NeighbourList.h"

#include <algorithm>

#include "CellGrid.h"
#include "NeighbourQuery.h"

namespace restenosis {
namespace {

/// What the search reads of an agent, kept in the order of the grid's cells.
struct Candidate {
  double x, y, z, radius;
  Index agent;
  bool daughter;
};

std::vector<Candidate> candidatesInOrder(const AgentStore& agents, std::span<const Index> order) {
  std::vector<Candidate> candidates;
  candidates.reserve(order.size());
  for (const Index j : order) {
    candidates.push_back(
        {agents.x[j], agents.y[j], agents.z[j], agents.radius[j], j, agents.has(j, AgentFlag::daughter)});
  }
  return candidates;
}

}  // namespace

void NeighbourList::build(const AgentStore& agents, const NeighbourRange& range) {
  const Index count = agents.size();
  const double widestFactor = std::max(range.factor, range.daughterFactor);
  const double largestRadius = NeighbourQuery::largestRadius(agents);
  const double widest = 2 * widestFactor * largestRadius + range.skin;
  const CellGrid grid(agents, widest > 0 ? widest : 1.0);
  const auto candidates = candidatesInOrder(agents, grid.order());

  constexpr Index chunk = 512;
  const auto chunks = static_cast<std::ptrdiff_t>((count + chunk - 1) / chunk);
  std::vector<std::vector<Index>> parts(chunks);
  positions_.resize(count);
  start_.assign(count + std::size_t{1}, 0);

#pragma omp parallel for schedule(dynamic) if (chunks > 1)
  for (std::ptrdiff_t c = 0; c < chunks; ++c) {
    auto& part = parts[c];
    const auto begin = static_cast<Index>(c) * chunk;
    for (Index i = begin; i < std::min(count, begin + chunk); ++i) {
      positions_[i] = agents.position(i);
      const auto first = static_cast<std::ptrdiff_t>(part.size());
      const double radius = agents.radius[i];
      const bool daughter = agents.has(i, AgentFlag::daughter);
      const Vec3& centre = positions_[i];
      const double widestReach = widestFactor * (radius + largestRadius) + range.skin;
      grid.forEachCandidateRange(centre, widestReach, [&](std::uint32_t from, std::uint32_t to) {
        for (std::uint32_t n = from; n < to; ++n) {
          const Candidate& other = candidates[n];
          const double dx = other.x - centre.x(), dy = other.y - centre.y(), dz = other.z - centre.z();
          const double factor = daughter || other.daughter ? range.daughterFactor : range.factor;
          const double reach = factor * (radius + other.radius) + range.skin;
          if (dx * dx + dy * dy + dz * dz <= reach * reach && other.agent != i) part.push_back(other.agent);
        }
      });
      std::sort(part.begin() + first, part.end());
      start_[i + 1] = part.size() - static_cast<std::size_t>(first);
    }
  }

  for (Index i = 0; i < count; ++i) start_[i + 1] += start_[i];
  neighbours_.resize(start_[count]);
#pragma omp parallel for schedule(static) if (chunks > 1)
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
