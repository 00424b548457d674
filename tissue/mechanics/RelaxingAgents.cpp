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
}

MinimiserView RelaxingAgents::view() { return {awake_, forces_.motion(), forces_.agents().radius}; }

void RelaxingAgents::look(std::size_t begin, std::size_t end, Sight& part) {
  minimiser_->total(view(), begin, end, part.totals);
  for (std::size_t k = begin; k < end; ++k)
    part.residual = std::max(part.residual, forces_.residual(awake_[k]));
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
      agentsOf(beside, [this](Index j) { return forces_.residual(j) > wakingShare * tolerance_; });
  wakeAround(restless);
  return !restless.empty();
}

bool RelaxingAgents::wakeAnyone() {
  // Whose force is as it was when this was last asked has been woken then, if it was to be
  const std::vector<Index> computed = forces_.evaluateExactly(awake_);
  sight_.reset();
  relisted_.clear();
  wakeAround(
      agentsOf(computed, [this](Index i) { return !isAwake_[i] && forces_.residual(i) > tolerance_; }));
  return awakeResidual() > tolerance_;
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
      unmarkAll(markPartners(restless, [this](Index j) { return !isAwake_[j] && forces_.isFree(j); }));
  wake(sleepers);
  const auto share = static_cast<std::size_t>(localShare * static_cast<double>(forces_.free().size()));
  const bool local = awake_.size() <= std::max(localCount, share) && (sleeping_ || awake_.empty());
  if (!local) {
    const std::vector<Index> rest = agentsOf(forces_.free(), [this](Index i) { return !isAwake_[i]; });
    wake(rest);
    std::ranges::copy(rest, std::back_inserter(sleepers));
    std::ranges::sort(sleepers);
  }
  forces_.evaluate(sleepers);  // they set out with the forces of now, not of when they were last looked at
}

void RelaxingAgents::retireQuiet(double settled) {
  if (!sleeping_) return;
  std::vector<Index> kept = agentsOf(awake_, [&](Index i) { return forces_.residual(i) > settled; });
  if (static_cast<double>(kept.size()) > fewRestless * static_cast<double>(awake_.size())) return;
  for (const Index i : kept) marked_[i] = 1;
  std::vector<Index> shell = kept;
  for (int n = 0; n < shellsKept; ++n) {
    shell = markPartners(shell, [this](Index j) { return isAwake_[j] != 0; });
    kept.insert(kept.end(), shell.begin(), shell.end());
  }
  awake_ = agentsOf(awake_, [&](Index i) {
    isAwake_[i] = marked_[i] || forces_.residual(i) > restingShare * settled;
    if (!isAwake_[i]) forces_.motion()[i].velocity.setZero();
    return isAwake_[i] != 0;
  });
  for (const Index i : kept) marked_[i] = 0;
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

double RelaxingAgents::residual() const { return forces_.size() == 0 ? 0 : forces_.residual(worstAgent()); }

Index RelaxingAgents::worstAgent() const {
  return static_cast<Index>(std::ranges::max_element(forces_.motion(), {}, &AgentMotion::residual) -
                            forces_.motion().begin());
}

}  // namespace restenosis
