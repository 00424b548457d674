#include "tissue/equilibrium/UnsureForces.h"

#include <algorithm>
#include <atomic>

#include "tissue/agents/Chunks.h"

namespace restenosis {
namespace {

// Of a distance: farther apart no rounding can make a pair act.
constexpr double beyondRounding = 1 + 1e-6;

}  // namespace

void UnsureForces::start(std::size_t agents) {
  marked_ = {};
  marked_.resize(agents);
  isMoving_.assign(agents, 0);
  moving_.clear();
}

void UnsureForces::append(std::size_t agents) {
  marked_.resize(agents);
  makeRoom(isMoving_, agents);
  isMoving_.resize(agents, 0);
}

void UnsureForces::mark() { marked_.setAll(); }

void UnsureForces::mark(std::span<const Index> agents) {
  for (const Index i : agents) marked_.set(i);
}

void UnsureForces::know() { marked_.clear(); }

void UnsureForces::startMoving(std::span<const Index> agents) {
  for (const Index i : agents) {
    if (!isMoving_[i]) moving_.push_back(i);
    isMoving_[i] = 1;
  }
}

void UnsureForces::stopMoving() {
  for (const Index i : moving_) isMoving_[i] = 0;
  moving_.clear();
}

bool UnsureForces::mayAct(Index i, const Vec3& position, double radius, Index j) const {
  const Sphere& other = spheres_.remembered(j);
  const bool daughter = ((agents_.flags[i] | agents_.flags[j]) & AgentFlag::daughter) != 0;
  const double reach =
      beyondRounding * (daughter ? range_.daughterFactor : range_.factor) * (radius + other.r);
  return (position - Vec3(other.x, other.y, other.z)).squaredNorm() < reach * reach;
}

bool UnsureForces::mayHaveActed(Index i, Index j) const {
  // Without mixed precision it is not known where the agent was.
  const Sphere& before = spheres_.remembered(i);
  return !spheres_.mixed() || mayAct(i, Vec3(before.x, before.y, before.z), before.r, j) ||
         mayAct(i, agents_.position(i), agents_.radius[i], j);
}

void UnsureForces::markAround(std::span<const Index> agents) {
  forEachPiece(agents.size(), [&](std::size_t begin, std::size_t end) {
    const auto piece = agents.subspan(begin, end - begin);
    neighbours_.readAhead(piece);
    bonds_.readAhead(piece);
    for (const Index i : piece) {
      marked_.set(i);
      for (const Index j : neighbours_.of(i)) {
        if (mayHaveActed(i, j)) marked_.set(j);
      }
      for (const Bond& bond : bonds_.of(i)) marked_.set(bond.partner);
    }
  });
}

}  // namespace restenosis
