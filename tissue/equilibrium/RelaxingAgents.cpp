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

// Sleepers beside an awake agent are looked at again once it has come so far that all its pair forces
// together may have changed by this many tolerances, of which one pair has a small share. Looking at them
// however little it moved takes a fifth more time of growth and leads to the same thickness; a way that is
// the same for all misses the stiff agents of the wall (docs/developer/tried.md).
constexpr double changeUntilLook = 3;

// Daughters so many contacts from a disturbance yield to it. With one or two, two or one fifths of what is
// gained by all daughters are missed; with three nothing, for two thirds of them (docs/developer/tried.md).
constexpr int contactsAround = 3;

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

bool RelaxingAgents::wakeDaughtersAround(std::unique_ptr<Minimiser> minimiser) {
  const AgentStore& agents = forces_.agents();
  std::vector<Index> around, front = awake_.agents;
  for (int contacts = 0; contacts < contactsAround; ++contacts) {
    front = gatherPieces(front.size(), [&](std::size_t begin, std::size_t end, std::vector<Index>& next) {
      for (std::size_t k = begin; k < end; ++k) {
        // Listed ones out of range are left out, so that who wakes does not depend on the list.
        const auto wanted = [&, i = front[k]](Index j) {
          return agents.has(j, AgentFlag::daughter) && !isAwake_[j] && forces_.isFree(j) &&
                 forces_.daughterInRange(i, j);
        };
        for (const Index j : forces_.neighbours().of(front[k])) take(j, wanted, next);
      }
    });
    around.insert(around.end(), front.begin(), front.end());
  }
  if (around.empty()) return false;
  minimiser_ = std::move(minimiser);
  wakeWithForces(unmarkAll(std::move(around)));
  return true;
}

void RelaxingAgents::placeAwake() {
  forEachInChunks(awake_.size(), [&](std::size_t k) { forces_.place(awake_.agents[k], awake_.position(k)); });
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
  restlessness = std::max(restlessness, other.restlessness);
}

void RelaxingAgents::look(std::size_t begin, std::size_t end, Sight& part) {
  const MotionPiece& piece = awake_.pieceOf(begin);
  minimiser_->total(piece, end - begin, part.totals);
  using Values = MotionPiece::Values;
  Values squared = 0, restlessness = 0;
  for (std::size_t k = 0; k < end - begin; k += MotionPiece::lanes) {
    const Values x = Values::from(&piece.fx[k]), y = Values::from(&piece.fy[k]),
                 z = Values::from(&piece.fz[k]);
    squared = squared.max(x * x + y * y + z * z);
    restlessness = restlessness.max(Values::from(&piece.restlessness[k]));
  }
  part.residual = std::sqrt(squared.largest());
  part.restlessness = restlessness.largest();
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
  RestlessPieces restless = piecesOf(beside.size());
  forces_.evaluate(beside, [&](std::size_t k, Index j, const AgentForce& now) {
    if (now.restlessness > wakingShare * tolerance_) restless[k / chunkSize].push_back({j, now});
  });
  forces_.doubt(beside);
  return wakeRestless(std::move(restless));
}

bool RelaxingAgents::wakeAnyone() {
  // Whose force is as it was when this was last asked has been woken then, if it was to be
  const std::vector<Index> unsure = forces_.unsure(awake_);
  RestlessPieces restless = piecesOf(unsure.size());
  forces_.evaluateExactly(unsure, awake_.agents, [&](std::size_t k, Index i, const AgentForce& now) {
    if (isAwake_[i]) {
      awake_.setNow(placeOf(i), now);
    } else if (now.restlessness > tolerance_) {
      restless[k / chunkSize].push_back({i, now});
    }
  });
  sight_.reset();
  wakeRestless(std::move(restless));
  return sight().restlessness > tolerance_;
}

std::vector<Index> RelaxingAgents::sleepersBesideMovers() {
  const auto asleep = [this](Index j) { return !isAwake_[j] && forces_.isFree(j); };
  const auto lookAround = [&](std::size_t begin, std::size_t end, std::vector<Index>& found) {
    MotionPiece& piece = awake_.pieceOf(begin);
    for (std::size_t k = begin; k < end; ++k) {
      const Index i = awake_.agents[k];
      const std::size_t m = awake_.inPiece(k);
      if (piece.way[m] * piece.stiffness[m] < changeUntilLook * tolerance_) continue;
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

bool RelaxingAgents::wakeRestless(RestlessPieces restless) {
  std::vector<Index> sleepers;
  for (const auto& piece : restless)
    for (const Restless& agent : piece) sleepers.push_back(agent.agent);
  if (sleepers.empty()) return false;
  if (!mayAnyoneSleep() || !areFew(awake_.size() + sleepers.size())) {
    restless = {};  // its memory may be much, and that of all who move comes on top
    wakeAllAsleep();
    return true;
  }
  wake(sleepers);
  for (const auto& piece : restless)
    for (const Restless& agent : piece) awake_.setNow(placeOf(agent.agent), agent.now);
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

bool RelaxingAgents::settled(double residual, double restlessness, double share) const {
  return residual <= share * tolerance_ && restlessness <= std::max(share, calmShare) * tolerance_;
}

bool RelaxingAgents::allSettled(double share) {
  return settled(sight().residual, sight().restlessness, share);
}

void RelaxingAgents::retireSettled(double share) {
  if (!mayAnyoneSleep()) return;
  std::vector<std::uint8_t> isRestless(awake_.size());
  forEachInChunks(awake_.size(), [&](std::size_t k) { isRestless[k] = !settled(awake_.now(k), share); });
  const auto restless = static_cast<std::size_t>(std::ranges::count(isRestless, 1));
  if (restless == awake_.size() || !areFew(restless)) return;
  forEachInChunks(awake_.size(), [&](std::size_t k) {
    if (isRestless[k]) return;
    isAwake_[awake_.agents[k]] = 0;
    forces_.place(awake_.agents[k], awake_.position(k));
  });
  std::size_t left = 0;
  for (std::size_t k = 0; k < awake_.size(); ++k) {
    if (!isRestless[k]) continue;
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

std::pair<Index, AgentForce> RelaxingAgents::mostRestless() const {
  std::size_t worst = 0;
  for (std::size_t k = 1; k < awake_.size(); ++k)
    if (awake_.now(k).restlessness > awake_.now(worst).restlessness) worst = k;
  return {awake_.agents[worst], awake_.now(worst)};
}

}  // namespace restenosis
