#pragma once

#include <cstdint>

#include "tissue/stent/InjuryParameters.h"
#include "tissue/vessel/Wall.h"

namespace restenosis {

/// What injury did, in agents unless stated.
struct InjuryReport {
  std::size_t ielBonds = 0;      ///< bonds of IEL agents that may be injured
  std::size_t brokenBonds = 0;   ///< of these, past the strain limit and removed
  double meanStrain = 0;         ///< of the IEL bonds before any broke
  double largestStrain = 0;      ///< the same
  Index iel = 0;                 ///< IEL agents that may be injured
  Index stretched = 0;           ///< of these, stretched by more than `stretchedStrain`
  Index broken = 0;              ///< at an end of a broken bond, or past the stress limit
  Index fenestrated = 0;         ///< made permeable by chance
  Index removed = 0;             ///< IEL agents removed (`removeIel`)
  Index synthetic = 0;           ///< cells that may cycle, the injured IEL agents among them
  Index syntheticByStretch = 0;  ///< of these, activated by stretch alone ([activation])
};

/// Injures a deployed wall (model 4), in this order:
/// 1. where `ielBreaks`, an IEL bond breaks when (s_around / limitAround)^2 + (s_along / limitAlong)^2 > 1,
///    where s is its strain times the cosine to either direction; it is removed and the agents at both ends
///    count as broken, as do IEL agents with a stress past the limit;
/// 2. of the other IEL agents, one about which the IEL is stretched by more than `stretchedStrain`
///    (laminaStretch) is fenestrated with the given probability;
/// 3. broken and fenestrated agents become synthetic smooth muscle cells, which keep their bonds; cells
///    within reach of one become synthetic as well, or all cells do (`synthetic`);
/// 4. `removeIel` removes the rest of the IEL, and cells within reach of it become synthetic;
/// 5. `denudation` strips the endothelium, or leaves it on the IEL and on agents that were IEL.
/// Fixed agents are never injured and never become synthetic, nor is the IEL injured within `endMargin` of
/// them, where the fixed end stretches it and not the stent. A draw depends on (seed, agent id) alone.
InjuryReport injure(Wall& wall, const InjuryParameters& parameters, std::uint64_t seed);

}  // namespace restenosis
