#include "UnsureForces.h"

#include <algorithm>
#include <atomic>

#include "Chunks.h"
#include "Room.h"

namespace restenosis {
namespace {

// Of a distance: farther apart no rounding can make a pair act.
constexpr double beyondRounding = 1 + 1e-6;

}  // namespace

void UnsureForces::start(std::size_t agents) {
  marked_.assign(agents, 1);
  isMoving_.assign(agents, 0);
  moving_.clear();
}

void UnsureForces::append(std::size_t agents) {
  makeRoom(marked_, agents);
  marked_.resize(agents, 1);
  makeRoom(isMoving_, agents);
  isMoving_.resize(agents, 0);
}

void UnsureForces::mark() { std::ranges::fill(marked_, 1); }

void UnsureForces::mark(std::span<const Index> agents) {
  for (const Index i : agents) marked_[i] = 1;
}

void UnsureForces::know() { std::ranges::fill(marked_, 0); }

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
  forEachInChunks(agents.size(), [&](std::size_t k) {
    const Index i = agents[k];
    const auto markOne = [this](Index j) { std::atomic_ref(marked_[j]).store(1, std::memory_order_relaxed); };
    markOne(i);
    for (const Index j : neighbours_.of(i)) {
      if (mayHaveActed(i, j)) markOne(j);
    }
    for (const Bond& bond : bonds_.of(i)) markOne(bond.partner);
  });
}

}  // namespace restenosis
