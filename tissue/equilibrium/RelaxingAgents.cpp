#include "tissue/equilibrium/RelaxingAgents.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "tissue/agents/Chunks.h"

namespace restenosis {
namespace {

// A disturbance of more agents than this share is no local one: it reaches everybody, and sleepers would only
// hold the others back, being woken layer by layer.
constexpr double fewShare = 0.5;
// A disturbance of fewer is local however small the tissue.
constexpr std::size_t fewAgents = 500;

// Sleepers beside moving agents wake above this many times the tolerance, the others when all are checked in
// double precision. It is above what mixed precision errs by, so that an agent whose force is unchanged never
// wakes.
constexpr double wakingShare = 1.1;

// Fewer agents than one of this many are sorted; for more, the marks of all are looked through. Speed only,
// not measured.
constexpr std::size_t marksOverSorting = 256;

// Sleepers beside an awake agent are looked at again once it has come so many tolerances, of its radius; all
// that may have been disturbed are before the relaxation ends.
constexpr double wayUntilLook = 1;

}  // namespace

template <class Wanted>
void RelaxingAgents::take(Index i, const Wanted& wanted, std::vector<Index>& found) {
  std::atomic_ref<std::uint8_t> mark(marked_[i]);
  if (mark.load(std::memory_order_relaxed) || !wanted(i)) return;
  if (!mark.exchange(1, std::memory_order_relaxed)) found.push_back(i);
}

RelaxingAgents::RelaxingAgents(AgentForces& forces, double tolerance, bool sleeping)
    : forces_(forces), tolerance_(tolerance), sleeping_(sleeping) {}

void RelaxingAgents::begin(std::unique_ptr<Minimiser> minimiser) {
  minimiser_ = std::move(minimiser);
  keepAwake_ = false;
  for (const Index i : awake_.agents) isAwake_[i] = 0;
  // Gives memory back after all were awake
  if (awake_.size() < awake_.capacity() / 4 && !areFew(awake_.capacity())) awake_ = {};
  awake_.resize(0);
  awake_.areRowsOf = false;
  isAwake_.resize(forces_.size(), 0);
  marked_.resize(forces_.size(), 0);
  wakeAnyone();
}

void RelaxingAgents::advance() {
  minimiser_->begin(sight().totals);
  const std::vector<Index> cramped =
      gatherPieces(awake_.size(), [&](std::size_t begin, std::size_t end, std::vector<Index>& found) {
        Moves moves;
        MotionPiece& piece = awake_.pieceOf(begin);
        minimiser_->step(piece, end - begin, moves);
        forces_.move(awake_.agentsFrom(begin), piece, moves, found);
        for (Index& k : found) k += static_cast<Index>(begin);
      });
  forces_.updateLists(awake_, cramped);
  std::vector<Sight> parts((awake_.size() + chunkSize - 1) / chunkSize);
  forces_.evaluate(awake_, [&](std::size_t begin, std::size_t end) {
    Sight part;
    look(begin, end, part);
    parts[begin / chunkSize] = part;
  });
  sight_.emplace(Sight());
  for (const Sight& part : parts) sight_->join(part);
}

void RelaxingAgents::Sight::join(const Sight& other) {
  totals.join(other.totals);
  residual = std::max(residual, other.residual);
}

void RelaxingAgents::look(std::size_t begin, std::size_t end, Sight& part) {
  const MotionPiece& piece = awake_.pieceOf(begin);
  minimiser_->total(piece, end - begin, part.totals);
  using Values = MotionPiece::Values;
  Values residual = 0;
  for (std::size_t k = 0; k < end - begin; k += MotionPiece::lanes)
    residual = residual.max(Values::from(&piece.residual[k]));
  part.residual = residual.largest();
}

const RelaxingAgents::Sight& RelaxingAgents::sight() {
  if (!sight_) {
    sight_ = reducePieces<Sight>(
        awake_.size(), [this](std::size_t begin, std::size_t end, Sight& part) { look(begin, end, part); });
  }
  return *sight_;
}

bool RelaxingAgents::wakeDisturbed() {
  if (awake_.size() == forces_.free().size()) return false;
  const std::vector<Index> beside = sleepersBesideMovers();
  DisturbedPieces disturbed = piecesOf(beside.size());
  forces_.evaluate(beside, [&](std::size_t k, Index j, const AgentForce& now) {
    if (now.residual > wakingShare * tolerance_) disturbed[k / chunkSize].push_back({j, now});
  });
  forces_.doubt(beside);
  return wakeDisturbed(std::move(disturbed));
}

bool RelaxingAgents::wakeAnyone() {
  // Whose force is as it was when this was last asked has been woken then, if it was to be
  const std::vector<Index> unsure = forces_.unsure(awake_);
  DisturbedPieces disturbed = piecesOf(unsure.size());
  forces_.evaluateExactly(unsure, awake_.agents, [&](std::size_t k, Index i, const AgentForce& now) {
    if (isAwake_[i]) {
      awake_.setNow(placeOf(i), now);
    } else if (now.residual > tolerance_) {
      disturbed[k / chunkSize].push_back({i, now});
    }
  });
  sight_.reset();
  wakeDisturbed(std::move(disturbed));
  return sight().residual > tolerance_;
}

std::vector<Index> RelaxingAgents::sleepersBesideMovers() {
  const auto asleep = [this](Index j) { return !isAwake_[j] && forces_.isFree(j); };
  const auto lookAround = [&](std::size_t begin, std::size_t end, std::vector<Index>& found) {
    MotionPiece& piece = awake_.pieceOf(begin);
    for (std::size_t k = begin; k < end; ++k) {
      const Index i = awake_.agents[k];
      const std::size_t m = awake_.inPiece(k);
      if (piece.way[m] < wayUntilLook * tolerance_ * piece.radius[m]) continue;
      piece.way[m] = 0;
      // Listed ones out of range are left out, so that who is looked at does not depend on the list.
      const auto inRange = [&](Index j) { return asleep(j) && forces_.inRange(piece, m, j); };
      for (const Index j : forces_.neighbours().of(i)) take(j, inRange, found);
      for (const Bond& bond : forces_.bonds().of(i)) take(bond.partner, asleep, found);
    }
  };
  return unmarkAll(gatherPieces(awake_.size(), lookAround));
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

bool RelaxingAgents::wakeDisturbed(DisturbedPieces disturbed) {
  std::vector<Index> sleepers;
  for (const auto& piece : disturbed)
    for (const Disturbed& agent : piece) sleepers.push_back(agent.agent);
  if (sleepers.empty()) return false;
  if (!mayAnyoneSleep() || !areFew(awake_.size() + sleepers.size())) {
    disturbed = {};  // its memory may be much, and that of all who move comes on top
    wakeAllAsleep();
    return true;
  }
  wake(sleepers);
  for (const auto& piece : disturbed)
    for (const Disturbed& agent : piece) awake_.setNow(placeOf(agent.agent), agent.now);
  return true;
}

void RelaxingAgents::wakeAll() {
  keepAwake_ = true;
  wakeAllAsleep();
}

void RelaxingAgents::wakeAllAsleep() {
  wakeWithForces(agentsOf(forces_.free(), [this](Index i) { return !isAwake_[i]; }));
}

void RelaxingAgents::wakeWithForces(std::span<const Index> sleepers) {
  wake(sleepers);
  forces_.evaluate(sleepers,
                   [this](std::size_t, Index i, const AgentForce& now) { awake_.setNow(placeOf(i), now); });
}

bool RelaxingAgents::allSettled(double share) { return settled(sight().residual, share); }

void RelaxingAgents::retireSettled(double share) {
  if (!mayAnyoneSleep()) return;
  std::vector<std::uint8_t> stays(awake_.size());
  forEachInChunks(awake_.size(), [&](std::size_t k) { stays[k] = !settled(awake_.now(k).residual, share); });
  const auto staying = static_cast<std::size_t>(std::ranges::count(stays, 1));
  if (staying == awake_.size() || !areFew(staying)) return;
  forEachInChunks(awake_.size(), [&](std::size_t k) {
    if (stays[k]) return;
    isAwake_[awake_.agents[k]] = 0;
    forces_.place(awake_.agents[k], awake_.position(k));
  });
  std::size_t left = 0;
  for (std::size_t k = 0; k < awake_.size(); ++k) {
    if (!stays[k]) continue;
    if (left != k) awake_.copy(left, k);
    ++left;
  }
  awake_.resize(left);
  awake_.fillLanes();
  awake_.areRowsOf = false;
  sight_.reset();
}

void RelaxingAgents::wake(std::span<const Index> sleepers) {
  for (const Index i : sleepers) isAwake_[i] = 1;
  forces_.startMoving(sleepers);
  if (sleepers.empty()) return;
  awake_.areRowsOf = false;
  sight_.reset();
  // Both are sorted: from the back on, nobody is overwritten who is yet to be moved
  std::size_t former = awake_.size(), next = sleepers.size(), place = former + next;
  awake_.resize(place);
  while (next > 0) {
    --place;
    if (former > 0 && awake_.agents[former - 1] > sleepers[next - 1]) {
      --former;
      awake_.copy(place, former);
    } else {
      awake_.agents[place] = sleepers[--next];
    }
  }
  forEachInChunks(sleepers.size(),
                  [&](std::size_t k) { awake_.set(placeOf(sleepers[k]), forces_.motionOf(sleepers[k])); });
  awake_.fillLanes();
}

std::size_t RelaxingAgents::placeOf(Index awake) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(awake_.agents, awake) - awake_.agents.begin());
}

double RelaxingAgents::residual() const {
  double largest = 0;
  for (const Index i : forces_.free()) largest = std::max(largest, forces_.residual(i));
  return largest;
}

Index RelaxingAgents::farthestFromRest() const {
  std::size_t worst = 0;
  for (std::size_t k = 1; k < awake_.size(); ++k)
    if (awake_.now(k).residual > awake_.now(worst).residual) worst = k;
  return awake_.agents[worst];
}

}  // namespace restenosis
