#pragma once

#include "tissue/agents/AgentStore.h"

namespace restenosis {

/// Lets nitric oxide spread from the covered cells, which hold what they produce, over the free synthetic
/// ones: each has the largest of
///
///     NO_j exp(-distance / reach)
///
/// over the covered cells j, itself among them if it is one, and 0 where that is below `negligible`
/// [nmol/mm^3]. It is the steady concentration that decays with the length sqrt(diffusivity / rate of decay)
/// below an endothelium of which the nearest part counts. `reach` [m], above 0.
void spreadNitricOxide(AgentStore& agents, double reach, double negligible);

}  // namespace restenosis
