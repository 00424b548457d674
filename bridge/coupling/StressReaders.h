#pragma once

#include <vector>

#include "tissue/agents/AgentStore.h"

namespace restenosis {

/// Whether a rule reads the wall shear stress of this agent: a smooth muscle cell that is covered, synthetic,
/// free to move and not inhibited, and has not yet passed G1. All others rest or divide whatever it is.
bool readsStress(const AgentStore& agents, Index agent);

/// The cells that read their stress and whose answer a small change of the flow may turn: those with less
/// than `margin` times the stress that arrests a cell [Pa]. A cell with more stays arrested.
std::vector<Index> undecidedCells(const AgentStore& agents, double arrestingWss, double margin);

}  // namespace restenosis
