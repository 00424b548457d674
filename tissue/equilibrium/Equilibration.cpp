#include "tissue/equilibrium/Equilibration.h"

#include <algorithm>
#include <cmath>

#include "tissue/agents/Chunks.h"

namespace restenosis {
namespace {

// Converged agents are deactivated, and the neighbours of active ones reviewed, this often: seldom enough to
// cost little, often enough that what they add is not missed for long. A day of growth of the thesis vessel
// needs 137, 123, 121 and 761 million evaluations at 10, 15, 20 and 30.
constexpr int iterationsBetweenReviews = 15;

// Active agents are brought this far below the tolerance that activates others. Were they left just below it,
// all that has moved would stay somewhat out of balance, and a growing wall would be looser than it is in
// equilibrium (docs/results/growth.md).
constexpr double aimShare = 0.1;

// More than this share of the free agents are moved all together: inactive ones would only hold the others
// back, being activated layer by layer. Fewer than `fewAgents` are an active set however small the tissue.
constexpr double localShare = 0.5;
constexpr std::size_t fewAgents = 500;

// The neighbours of an active agent are reviewed once it has come so many tolerances, of its radius; all that
// may have changed are verified before the iteration ends.
constexpr float pathUntilReview = 1;

// The neighbours of an agent are fetched so many agents before they are read.
constexpr std::size_t agentsAhead = 8;

// Of what is added to a path or subtracted from a margin: single precision errs by less.
constexpr float longer = 1 + 1e-5F;
constexpr double shorter = 1 - 1e-5;

}  // namespace

Equilibration::Equilibration(AgentStore& agents, const BondTable& bonds,
                             std::span<const Constraint* const> constraints, const ForceField& field,
                             NeighbourList& neighbours, const ForceCache::Settings& settings,
                             const RelaxationParameters& parameters)
    : agents_(agents),
      constraints_(constraints),
      parameters_(parameters),
      aim_(aimShare * parameters.tolerance),
      neighbours_(neighbours),
      forces_(agents, bonds, constraints_, field, neighbours, settings) {}

RelaxationReport Equilibration::run(const std::function<void()>& beforeIteration) {
  const std::uint64_t evaluationsBefore = forces_.evaluations();
  RelaxationReport report;
  report.converged = begin();
  while (!report.converged && report.iterations < parameters_.maximumIterations) {
    if (beforeIteration) beforeIteration();
    step();
    forces_.evaluate(active_);
    ++report.iterations;
    // Activating one after another is a slow path to equilibrium in a long soft chain, for example.
    if (report.iterations == parameters_.maximumIterations / 2) activateAll();
    const bool due = report.iterations % iterationsBetweenReviews == 0;
    const bool converged = activeConverged();
    // Before any is deactivated: what has moved is still active, so none of its neighbours is missed.
    const bool activated = (converged || due) && review();
    if (due) deactivateConverged();
    report.converged = converged && !activated && verify();
  }
  // Less than was aimed at will do, but not less than the tolerance
  if (!report.converged) report.converged = verify();
  report.residual = largestResidual();
  report.agentEvaluations = forces_.evaluations() - evaluationsBefore;
  return report;
}

bool Equilibration::begin() {
  minimiser_ = makeMinimiser(parameters_);
  allForGood_ = false;
  active_.reset(agents_.size());
  reviewed_.resize(agents_.size());
  free_ = agentsThat(agents_.size(), [this](Index i) { return forces_.isFree(i); });
  forEachInChunks(free_.size(), [this](std::size_t k) {
    const Index i = free_[k];
    const Vec3 before = agents_.position(i);
    if (constraints_.margin(agents_.kind[i], agents_.radius[i], before) > 0) return;
    Vec3 position = before;
    constraints_.project(agents_.kind[i], agents_.radius[i], position);
    if (position != before) agents_.setPosition(i, position);
  });
  forces_.refresh();
  return verify();
}

void Equilibration::step() {
  minimiser_->begin(active_.reduce<StepTotals>(
      [this](const ActiveChunk& chunk, std::span<const Index> agents, StepTotals& part) {
        minimiser_->total(chunk, agents.size(), part);
      }));
  const std::vector<Index> smallMargins =
      active_.gather([this](ActiveChunk& chunk, std::span<const Index> agents, std::size_t first,
                            std::vector<Index>& small) {
        Moves moves;
        minimiser_->step(chunk, agents.size(), moves);
        move(chunk, agents, moves, first, small);
      });
  updateNeighbours(smallMargins);
}

void Equilibration::move(ActiveChunk& chunk, std::span<const Index> agents, const Moves& moves,
                         std::size_t first, std::vector<Index>& small) {
  const auto smallMargin = static_cast<float>(neighbours_.smallMargin());
  ActiveChunk::Floats lengths;
  for (std::size_t k = 0; k < agents.size(); ++k) {
    const float dx = moves.x[k], dy = moves.y[k], dz = moves.z[k];
    lengths[k] = longer * std::sqrt(dx * dx + dy * dy + dz * dz);
  }
  for (std::size_t k = 0; k < agents.size(); ++k) {
    const Vec3 before = chunk.position(k);
    Vec3 position = before + Vec3(moves.x[k], moves.y[k], moves.z[k]);
    float length = lengths[k];
    chunk.constraintMargin[k] -= length;
    if (!(chunk.constraintMargin[k] > 0)) {
      constraints_.project(chunk.kind[k], chunk.radius[k], position);
      chunk.constraintMargin[k] = constraints_.margin(chunk.kind[k], chunk.radius[k], position);
      length = longer * static_cast<float>((position - before).norm());
    }
    chunk.x[k] = position.x(), chunk.y[k] = position.y(), chunk.z[k] = position.z();
    chunk.path[k] += length;
    chunk.unreviewed[k] += length;
    chunk.listMargin[k] -= length;
    forces_.move(agents[k], position, chunk.radius[k]);
    if (chunk.listMargin[k] > smallMargin) continue;
    chunk.listMargin[k] = static_cast<float>(shorter * neighbours_.margin(agents[k], position));
    if (!(chunk.listMargin[k] > smallMargin)) small.push_back(static_cast<Index>(first + k));
  }
}

void Equilibration::updateNeighbours(std::span<const Index> smallMargins) {
  if (std::ranges::all_of(smallMargins, [this](Index place) {
        return active_.chunkOf(place).listMargin[ActiveSet::inChunk(place)] >= 0;
      })) {
    return;
  }
  forces_.updateNeighbours(active_, smallMargins);
}

bool Equilibration::review() {
  if (active_.size() == free_.size()) return false;
  const auto wanted = [this](Index j) { return !active_.contains(j) && forces_.isFree(j); };
  active_.forEach([&](ActiveChunk& chunk, std::span<const Index> agents, std::size_t) {
    const auto tolerance = static_cast<float>(parameters_.tolerance);
    for (std::size_t k = 0; k < agents.size(); ++k) {
      if (k + agentsAhead < agents.size()) forces_.prefetch(agents[k + agentsAhead]);
      if (chunk.unreviewed[k] < pathUntilReview * tolerance * chunk.radius[k]) continue;
      chunk.unreviewed[k] = 0;
      // Listed ones out of range are left out, so that the agents reviewed do not depend on the list.
      for (const Index j : neighbours_.of(agents[k]))
        if (wanted(j) && forces_.mayAct(agents[k], j, 0)) reviewed_.mark(j);
      for (const Bond& bond : forces_.bonds().of(agents[k]))
        if (wanted(bond.partner)) reviewed_.mark(bond.partner);
    }
  });
  const std::vector<Index> beside = reviewed_.extract([](Index) { return true; });
  return activateDisturbed(beside, forces_.evaluate(beside));
}

bool Equilibration::verify() {
  forEachInChunks(active_.size(), [this](std::size_t place) { forces_.store(active_, place); });
  active_.forEach([this](ActiveChunk& chunk, std::span<const Index> agents, std::size_t) {
    for (std::size_t k = 0; k < agents.size(); ++k) {
      if (k + agentsAhead < agents.size()) forces_.prefetch(agents[k + agentsAhead]);
      forces_.markAround(agents[k], chunk.path[k]);
      chunk.path[k] = 0;
    }
  });
  forces_.checkPrecision(active_.agents());
  const std::vector<Index> stale = forces_.extractStale(active_);
  activateDisturbed(stale, forces_.evaluate(stale));
  return active_.empty() || largestActiveResidual() <= parameters_.tolerance;
}

bool Equilibration::activateDisturbed(std::span<const Index> agents, std::span<const AgentForce> forces) {
  std::vector<Index> disturbed;
  std::vector<AgentForce> ofDisturbed;
  for (std::size_t k = 0; k < agents.size(); ++k) {
    if (!(forces[k].residual > parameters_.tolerance) || !forces_.isFree(agents[k])) continue;
    disturbed.push_back(agents[k]);
    ofDisturbed.push_back(forces[k]);
  }
  if (disturbed.empty()) return false;
  if (mayDeactivate() && isLocal(active_.size() + disturbed.size())) {
    activate(disturbed, ofDisturbed);
  } else {
    disturbed = {}, ofDisturbed = {};  // gives memory back before all are active
    const std::vector<Index> inactive = agentsOf(free_, [this](Index i) { return !active_.contains(i); });
    activate(inactive, forces_.evaluate(inactive));
  }
  return true;
}

void Equilibration::activateAll() {
  allForGood_ = true;
  const std::vector<Index> inactive = agentsOf(free_, [this](Index i) { return !active_.contains(i); });
  activate(inactive, forces_.evaluate(inactive));
}

void Equilibration::activate(std::span<const Index> agents, std::span<const AgentForce> forces) {
  if (agents.empty()) return;
  active_.add(agents, [&](ActiveChunk& chunk, std::size_t n, std::size_t k) {
    const Index i = agents[k];
    const Vec3 position = agents_.position(i);
    chunk.set(n, agents_.kind[i], position, agents_.radius[i]);
    chunk.setForce(n, forces[k]);
    chunk.listMargin[n] = static_cast<float>(shorter * neighbours_.margin(i, position));
    chunk.constraintMargin[n] = constraints_.margin(agents_.kind[i], agents_.radius[i], position);
  });
}

void Equilibration::deactivateConverged() {
  if (!mayDeactivate()) return;
  std::vector<std::uint8_t> keep(active_.size());
  active_.forEach([&](const ActiveChunk& chunk, std::span<const Index> agents, std::size_t first) {
    for (std::size_t k = 0; k < agents.size(); ++k) keep[first + k] = !(chunk.residual[k] <= aim_);
  });
  std::vector<std::size_t> leaving;
  for (std::size_t place = 0; place < keep.size(); ++place)
    if (!keep[place]) leaving.push_back(place);
  if (leaving.empty() || !isLocal(active_.size() - leaving.size())) return;
  forEachInChunks(leaving.size(), [&](std::size_t k) { forces_.store(active_, leaving[k]); });
  std::vector<Index> agents(leaving.size());
  forEachInChunks(leaving.size(), [&](std::size_t k) {
    const std::size_t place = leaving[k];
    if (k + agentsAhead < leaving.size()) forces_.prefetch(active_.agents()[leaving[k + agentsAhead]]);
    agents[k] = active_.agents()[place];
    forces_.markAround(agents[k], active_.chunkOf(place).path[ActiveSet::inChunk(place)]);
  });
  forces_.checkPrecision(agents);
  active_.keepOnly(keep);
}

bool Equilibration::isLocal(std::size_t agents) const {
  const double share = localShare * static_cast<double>(free_.size());
  return agents <= std::max(fewAgents, static_cast<std::size_t>(share));
}

float Equilibration::largestActiveResidual() const {
  struct Largest {
    float residual = 0;
    void join(const Largest& other) { residual = std::max(residual, other.residual); }
  };
  return active_
      .reduce<Largest>([](const ActiveChunk& chunk, std::span<const Index> agents, Largest& part) {
        for (std::size_t k = 0; k < agents.size(); ++k) part.join({chunk.residual[k]});
      })
      .residual;
}

double Equilibration::largestResidual() const {
  double largest = 0;
  for (const Index i : free_) largest = std::max(largest, forces_.residual(i));
  return largest;
}

Index Equilibration::worstAgent() const {
  return *std::ranges::max_element(active_.agents(), {}, [this](Index i) { return forces_.residual(i); });
}

}  // namespace restenosis
