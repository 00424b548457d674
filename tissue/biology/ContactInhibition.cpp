#include "tissue/biology/ContactInhibition.h"

#include <algorithm>
#include <atomic>

#include "tissue/agents/Chunks.h"

namespace restenosis {

namespace {

// Range of the first search for neighbours, in R1 + R2. Speed only.
constexpr double nearRange = 1.5;

/// Marks of the reference configuration.
enum Mark : std::uint8_t { usesFlags = 1, isInhibited = 2, isExposed = 4, coveredByNear = 8 };

bool couldUse(const AgentStore& agents, Index i) {
  return agents.kind[i] == AgentKind::smc && agents.has(i, synthetic) && !agents.has(i, fixed);
}

}  // namespace

ContactInhibition::ContactInhibition(const ContactInhibitionParameters& parameters,
                                     std::unique_ptr<const ContactInhibitionLaw> law, double vesselLength)
    : measure_(parameters),
      law_(std::move(law)),
      range_(std::max(measure_.range(), law_ ? law_->range() : 0.0)),
      startsNear_(nearRange < range_ && (!law_ || law_->range() <= nearRange)),
      tolerance_(parameters.changeTolerance),
      vesselLength_(vesselLength) {}

InhibitionReport ContactInhibition::evaluate(AgentStore& agents) {
  InhibitionReport report;
  const auto places = reference_.follow(agents, tolerance_);
  report.disturbances = static_cast<Index>(places.size());
  const std::span<std::uint8_t> marks = reference_.marks();

  forEachInChunks(agents.size(), [&](std::size_t i) {
    if (!couldUse(agents, static_cast<Index>(i))) marks[i] = 0;
  });
  const auto fresh = agentsThat(agents.size(), [&](Index i) { return marks[i] == 0 && couldUse(agents, i); });
  std::vector<Index> cells;
  if (!places.empty() || !fresh.empty()) {
    std::vector<std::uint8_t> due(agents.size(), 0);
    for (const Index i : fresh) due[i] = 1;
    const MirroredNeighbours neighbours(reference_.shapes(), range_, vesselLength_);
    const auto markAround = [&](const MirroredNeighbours& those, double range) {
      forEachHeavyChunk(places.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
          const auto [centre, radius] = places[k];
          those.forEachWithin(range, centre, radius, [&](const MirroredNeighbours::Found& near) {
            std::atomic_ref(due[near.agent]).store(1, std::memory_order_relaxed);
          });
        }
      });
    };
    markAround(neighbours, startsNear_ ? nearRange : range_);
    if (startsNear_) {
      // Few: near neighbours alone cover most cells
      const auto uncovered = agentsThat(
          agents.size(), [&](Index i) { return (marks[i] & (usesFlags | coveredByNear)) == usesFlags; });
      markAround(MirroredNeighbours(reference_.shapes(), uncovered, range_, vesselLength_), range_);
    }
    cells = agentsThat(agents.size(), [&](Index i) { return due[i] && couldUse(agents, i); });
    forEachHeavyChunk(cells.size(), [&](std::size_t begin, std::size_t end) {
      std::vector<ContactNeighbour> scratch;
      for (std::size_t k = begin; k < end; ++k) marks[cells[k]] = marksOf(neighbours, cells[k], scratch);
    });
  }
  report.evaluated = static_cast<Index>(cells.size());

  forEachInChunks(agents.size(), [&](std::size_t k) {
    const auto i = static_cast<Index>(k);
    const bool isPressed =
        law_ && law_->readsStress() && (marks[i] & usesFlags) &&
        law_->inhibits({agents.radius[i], (marks[i] & isExposed) != 0, {}, agents.stress[i]});
    agents.set(i, inhibited, isPressed || (marks[i] & isInhibited));
    agents.set(i, exposed, marks[i] & isExposed);
  });
  return report;
}

std::uint8_t ContactInhibition::marksOf(const MirroredNeighbours& neighbours, Index cell,
                                        std::vector<ContactNeighbour>& scratch) const {
  const double radius = reference_.shapes().radius[cell];
  const auto surroundingsWithin = [&](double range) -> Surroundings {
    neighbours.gather(cell, range, scratch);
    return {radius, measure_.exposed(radius, scratch), scratch};
  };
  Surroundings surroundings = surroundingsWithin(startsNear_ ? nearRange : range_);
  std::uint8_t mark = usesFlags;
  if (startsNear_ && !surroundings.exposed) {
    mark |= coveredByNear;
  } else if (startsNear_) {
    surroundings = surroundingsWithin(range_);
  }
  if (surroundings.exposed) mark |= isExposed;
  if (law_ && !law_->readsStress() && law_->inhibits(surroundings)) mark |= isInhibited;
  return mark;
}

}  // namespace restenosis
