#include "RelaxingAgents.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <utility>

#include "Chunks.h"

namespace restenosis {
namespace {

// A disturbance of more agents than this share is no local one: it reaches everybody, and sleepers would only
// hold the others back, being woken layer by layer.
constexpr double fewShare = 0.5;
// A disturbance of fewer is local however small the tissue.
constexpr std::size_t fewAgents = 500;

// Sleepers beside moving agents wake above this many times the tolerance, the others when all are checked in
// double precision. It is above what mixed precision errs by, so that an agent that is merely listed, its
// force unchanged, never wakes: who wakes must not depend on the list.
constexpr double wakingShare = 1.1;

// Fewer agents than one of this many are sorted; for more, the marks of all are looked through. Speed only,
// not measured.
constexpr std::size_t marksOverSorting = 256;

struct Any {
  bool found = false;
  void join(const Any& other) { found |= other.found; }
};

}  // namespace

RelaxingAgents::RelaxingAgents(AgentForces& forces, double tolerance, bool sleeping)
    : forces_(forces), tolerance_(tolerance), sleeping_(sleeping) {}

void RelaxingAgents::begin(std::unique_ptr<Minimiser> minimiser) {
  minimiser_ = std::move(minimiser);
  keepAwake_ = false;
  for (const Index i : awake_) {
    forces_.motion()[i].velocity.setZero();
    isAwake_[i] = 0;
  }
  awake_.clear();
  isAwake_.resize(forces_.size(), 0);
  marked_.resize(forces_.size(), 0);
  wakeAnyone();
}

void RelaxingAgents::advance() {
  minimiser_->begin(sight().totals);
  const AgentStore& agents = forces_.agents();
  const auto far = reducePieces<Any>(awake_.size(), [&](std::size_t begin, std::size_t end, Any& part) {
    std::array<Vec3, chunkSize> moves;
    minimiser_->step(view(), begin, end, moves);
    for (std::size_t k = begin; k < end; ++k) {
      const Index i = awake_[k];
      part.found |= forces_.moveTo(i, agents.position(i) + moves[k - begin]);
    }
  });
  if (far.found) forces_.updateLists(awake_, relisted_);
  std::vector<Sight> parts((awake_.size() + chunkSize - 1) / chunkSize);
  forces_.evaluate(awake_,
                   [&](std::size_t begin, std::size_t end) { look(begin, end, parts[begin / chunkSize]); });
  sight_.emplace();
  for (const Sight& part : parts) sight_->join(part);
}

void RelaxingAgents::Sight::join(const Sight& other) {
  totals.join(other.totals);
  residual = std::max(residual, other.residual);
  restlessness = std::max(restlessness, other.restlessness);
}

MinimiserView RelaxingAgents::view() { return {awake_, forces_.motion(), forces_.agents().radius}; }

void RelaxingAgents::look(std::size_t begin, std::size_t end, Sight& part) {
  minimiser_->total(view(), begin, end, part.totals);
  for (std::size_t k = begin; k < end; ++k) {
    part.residual = std::max(part.residual, forces_.residual(awake_[k]));
    part.restlessness = std::max(part.restlessness, forces_.restlessness(awake_[k]));
  }
}

const RelaxingAgents::Sight& RelaxingAgents::sight() {
  if (!sight_) {
    sight_ = reducePieces<Sight>(
        awake_.size(), [this](std::size_t begin, std::size_t end, Sight& part) { look(begin, end, part); });
  }
  return *sight_;
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
  beside = unmarkAll(std::move(beside));
  forces_.evaluate(beside);
  forces_.doubt(beside);
  const std::vector<Index> restless =
      agentsOf(beside, [this](Index j) { return forces_.restlessness(j) > wakingShare * tolerance_; });
  wakeRestless(restless);
  return !restless.empty();
}

bool RelaxingAgents::wakeAnyone() {
  // Whose force is as it was when this was last asked has been woken then, if it was to be
  const std::vector<Index> computed = forces_.evaluateExactly(awake_);
  sight_.reset();
  relisted_.clear();
  wakeRestless(
      agentsOf(computed, [this](Index i) { return !isAwake_[i] && forces_.restlessness(i) > tolerance_; }));
  return sight().restlessness > tolerance_;
}

template <class Look>
std::vector<Index> RelaxingAgents::collect(const std::vector<Index>& agents, Look&& look) {
  return gatherPieces(agents.size(), [&](std::size_t begin, std::size_t end, std::vector<Index>& found) {
    const auto take = [&](Index j, const auto& wanted) {
      std::atomic_ref<std::uint8_t> mark(marked_[j]);
      if (mark.load(std::memory_order_relaxed) || !wanted(j)) return;
      if (!mark.exchange(1, std::memory_order_relaxed)) found.push_back(j);
    };
    for (std::size_t k = begin; k < end; ++k) look(agents[k], take);
  });
}

std::vector<Index> RelaxingAgents::unmarkAll(std::vector<Index> marked) {
  if (marked.size() < marked_.size() / marksOverSorting) {
    std::ranges::sort(marked);
  } else {
    marked = agentsThat(marked_.size(), [this](Index i) { return marked_[i] != 0; });
  }
  for (const Index i : marked) marked_[i] = 0;
  return marked;
}

bool RelaxingAgents::areFew(std::size_t agents) const {
  return agents <=
         std::max(fewAgents, static_cast<std::size_t>(fewShare * static_cast<double>(forces_.free().size())));
}

void RelaxingAgents::wakeRestless(const std::vector<Index>& restless) {
  if (restless.empty()) return;
  if (mayAnyoneSleep() && areFew(awake_.size() + restless.size())) {
    wake(restless);
  } else {
    wakeAllAsleep();
  }
}

void RelaxingAgents::wakeAll() {
  keepAwake_ = true;
  wakeAllAsleep();
}

void RelaxingAgents::wakeAllAsleep() {
  const std::vector<Index> sleepers = agentsOf(forces_.free(), [this](Index i) { return !isAwake_[i]; });
  wake(sleepers);
  forces_.evaluate(sleepers);  // they set out with the forces of now, not of when they were last looked at
}

bool RelaxingAgents::settled(double residual, double restlessness, double share) const {
  return residual <= share * tolerance_ && restlessness <= std::max(share, calmShare) * tolerance_;
}

bool RelaxingAgents::allSettled(double share) {
  return settled(sight().residual, sight().restlessness, share);
}

void RelaxingAgents::retireSettled(double share) {
  if (!mayAnyoneSleep()) return;
  const auto atRest = [&](Index i) { return settled(forces_.residual(i), forces_.restlessness(i), share); };
  std::vector<Index> restless = agentsOf(awake_, [&](Index i) { return !atRest(i); });
  if (!areFew(restless.size())) return;
  for (const Index i : agentsOf(awake_, atRest)) {
    isAwake_[i] = 0;
    forces_.motion()[i].velocity.setZero();
  }
  awake_ = std::move(restless);
  sight_.reset();
}

void RelaxingAgents::wake(const std::vector<Index>& sleepers) {
  for (const Index i : sleepers) isAwake_[i] = 1;
  forces_.startMoving(sleepers);
  const auto middle = static_cast<std::ptrdiff_t>(awake_.size());
  if (!sleepers.empty()) sight_.reset();
  awake_.insert(awake_.end(), sleepers.begin(), sleepers.end());
  std::inplace_merge(awake_.begin(), awake_.begin() + middle, awake_.end());
}

double RelaxingAgents::residual() const {
  double largest = 0;
  for (const Index i : forces_.free()) largest = std::max(largest, forces_.residual(i));
  return largest;
}

Index RelaxingAgents::mostRestless() const {
  return static_cast<Index>(std::ranges::max_element(forces_.motion(), {}, &AgentMotion::restlessness) -
                            forces_.motion().begin());
}

}  // namespace restenosis
