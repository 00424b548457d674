#include "RelaxingAgents.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "Chunks.h"

namespace restenosis {
namespace {

// A disturbance of more agents than this share is no local one: it reaches everybody, and sleepers would only
// hold the others back, being woken layer by layer.
constexpr double localShare = 0.5;
// A disturbance of fewer is local however small the tissue.
constexpr std::size_t localCount = 500;

// Sleepers beside moving agents wake above this many times the tolerance, the others when all are checked in
// double precision. It is above what mixed precision errs by, so that an agent that is merely listed, its
// force unchanged, never wakes: who wakes must not depend on the list.
constexpr double wakingShare = 1.1;

// Where no more than this share of the awake agents is restless, the others may sleep ...
constexpr double fewRestless = 0.3;
// ... if they have come to rest to this share of what counts as settled ...
constexpr double restingShare = 0.5;
// ... and are farther than this many contacts from the restless, who need surroundings that give way.
constexpr int shellsKept = 4;

struct Any {
  bool found = false;
  void join(const Any& other) { found |= other.found; }
};

struct Largest {
  double value = 0;
  void join(const Largest& other) { value = std::max(value, other.value); }
};

}  // namespace

RelaxingAgents::RelaxingAgents(AgentForces& forces, double tolerance, bool sleeping)
    : forces_(forces), tolerance_(tolerance), sleeping_(sleeping) {}

void RelaxingAgents::begin() {
  for (const Index i : awake_) {
    velocity_[i].setZero();
    isAwake_[i] = 0;
  }
  awake_.clear();
  velocity_.resize(forces_.size(), Vec3::Zero());
  isAwake_.resize(forces_.size(), 0);
  marked_.resize(forces_.size(), 0);
  wakeAnyone();
}

void RelaxingAgents::advance(Minimiser& minimiser) {
  step_.resize(awake_.size());
  const AgentStore& agents = forces_.agents();
  minimiser.step({awake_, forces_.force(), forces_.stiffness(), agents.radius, velocity_, step_});
  const auto far = reduceInChunks<Any>(awake_.size(), [&](std::size_t k, Any& part) {
    const Index i = awake_[k];
    part.found |= forces_.moveTo(i, agents.position(i) + step_[k]);
  });
  if (far.found) forces_.updateLists(awake_, relisted_);
  forces_.evaluate(awake_);
}

bool RelaxingAgents::wakeDisturbed() {
  if (awake_.size() == forces_.free().size()) {
    relisted_.clear();
    return false;
  }
  const auto asleep = [this](Index j) { return !isAwake_[j] && forces_.isFree(j); };
  std::vector<Index> beside = collect(awake_, [&](Index i, const auto& take) {
    for (const Index j : forces_.neighbours().of(i)) take(j, asleep);
    for (const Bond& bond : forces_.bonds().of(i)) take(bond.partner, asleep);
  });
  // Those whom an awake agent has left since they were looked at, too.
  const std::vector<Index> left = collect(relisted_, [&](Index i, const auto& take) { take(i, asleep); });
  beside.insert(beside.end(), left.begin(), left.end());
  relisted_.clear();
  for (const Index j : beside) marked_[j] = 0;
  std::ranges::sort(beside);
  forces_.evaluate(beside);
  forces_.doubt(beside);
  std::erase_if(beside, [&](Index j) { return forces_.residual()[j] <= wakingShare * tolerance_; });
  wakeAround(beside);
  return !beside.empty();
}

bool RelaxingAgents::wakeAnyone() {
  forces_.evaluateExactly(awake_);
  relisted_.clear();
  std::vector<Index> restless;
  std::ranges::copy_if(forces_.free(), std::back_inserter(restless),
                       [&](Index i) { return !isAwake_[i] && forces_.residual()[i] > tolerance_; });
  wakeAround(restless);
  return awakeResidual() > tolerance_;
}

template <class Look>
std::vector<Index> RelaxingAgents::collect(const std::vector<Index>& agents, Look&& look) {
  std::vector<std::vector<Index>> parts((agents.size() + chunkSize - 1) / chunkSize);
  forEachPiece(agents.size(), [&](std::size_t begin, std::size_t end) {
    std::vector<Index>& part = parts[begin / chunkSize];
    const auto take = [&](Index j, const auto& wanted) {
      std::atomic_ref<std::uint8_t> mark(marked_[j]);
      if (mark.load(std::memory_order_relaxed) || !wanted(j)) return;
      if (!mark.exchange(1, std::memory_order_relaxed)) part.push_back(j);
    };
    for (std::size_t k = begin; k < end; ++k) look(agents[k], take);
  });
  std::vector<Index> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

template <class Wanted>
std::vector<Index> RelaxingAgents::markPartners(const std::vector<Index>& agents, const Wanted& wanted) {
  const AgentStore& store = forces_.agents();
  return collect(agents, [&](Index i, const auto& take) {
    const Vec3 here = store.position(i);
    // Those that touch, not all listed: who wakes must not depend on the list.
    const auto wantedAndTouching = [&](Index j) {
      const double radii = store.radius[i] + store.radius[j];
      return wanted(j) && (here - store.position(j)).squaredNorm() < radii * radii;
    };
    for (const Index j : forces_.neighbours().of(i)) take(j, wantedAndTouching);
    for (const Bond& bond : forces_.bonds().of(i)) take(bond.partner, wanted);
  });
}

void RelaxingAgents::wakeAround(const std::vector<Index>& restless) {
  wake(restless);
  std::vector<Index> sleepers =
      markPartners(restless, [this](Index j) { return !isAwake_[j] && forces_.isFree(j); });
  for (const Index j : sleepers) marked_[j] = 0;
  std::ranges::sort(sleepers);
  wake(sleepers);
  const auto share = static_cast<std::size_t>(localShare * static_cast<double>(forces_.free().size()));
  const bool local = awake_.size() <= std::max(localCount, share) && (sleeping_ || awake_.empty());
  if (!local) {
    std::vector<Index> rest;
    std::ranges::copy_if(forces_.free(), std::back_inserter(rest), [&](Index i) { return !isAwake_[i]; });
    wake(rest);
    std::ranges::copy(rest, std::back_inserter(sleepers));
    std::ranges::sort(sleepers);
  }
  forces_.evaluate(sleepers);  // they set out with the forces of now, not of when they were last looked at
}

void RelaxingAgents::retireQuiet(double settled) {
  if (!sleeping_) return;
  std::vector<Index> kept;
  std::ranges::copy_if(awake_, std::back_inserter(kept),
                       [&](Index i) { return forces_.residual()[i] > settled; });
  if (static_cast<double>(kept.size()) > fewRestless * static_cast<double>(awake_.size())) return;
  for (const Index i : kept) marked_[i] = 1;
  std::vector<Index> shell = kept;
  for (int n = 0; n < shellsKept; ++n) {
    shell = markPartners(shell, [this](Index j) { return isAwake_[j] != 0; });
    kept.insert(kept.end(), shell.begin(), shell.end());
  }
  for (const Index i : awake_) {
    isAwake_[i] = marked_[i] || forces_.residual()[i] > restingShare * settled;
    if (!isAwake_[i]) velocity_[i].setZero();
  }
  for (const Index i : kept) marked_[i] = 0;
  std::erase_if(awake_, [&](Index i) { return !isAwake_[i]; });
}

void RelaxingAgents::wake(const std::vector<Index>& sleepers) {
  for (const Index i : sleepers) isAwake_[i] = 1;
  forces_.startMoving(sleepers);
  const auto middle = static_cast<std::ptrdiff_t>(awake_.size());
  awake_.insert(awake_.end(), sleepers.begin(), sleepers.end());
  std::inplace_merge(awake_.begin(), awake_.begin() + middle, awake_.end());
}

double RelaxingAgents::awakeResidual() const {
  return reduceInChunks<Largest>(awake_.size(),
                                 [&](std::size_t k, Largest& part) {
                                   part.value = std::max(part.value, forces_.residual()[awake_[k]]);
                                 })
      .value;
}

double RelaxingAgents::residual() const {
  return forces_.residual().empty() ? 0 : forces_.residual()[worstAgent()];
}

Index RelaxingAgents::worstAgent() const {
  return static_cast<Index>(std::ranges::max_element(forces_.residual()) - forces_.residual().begin());
}

}  // namespace restenosis
