#pragma once

#include <span>
#include <vector>

#include "bridge/flow/FlowBackend.h"
#include "tissue/agents/AgentStore.h"

namespace restenosis {

/// Wall shear stress as the cells feel it.
struct CellShear {
  std::vector<double> wss;     ///< by agent: area-weighted mean of the stress it received [Pa]; 0 without any
  std::vector<double> area;    ///< by agent: area of the faces it received [m^2]
  std::size_t facesGiven = 0;  ///< wall faces given to cells
  std::size_t cellsFilled = 0;  ///< exposed cells that received no face and took the nearest face's value
};

/// Gives the wall's shear stress to the agents it acts on, conservatively: every wall face (struts keep
/// theirs) gives its whole area to the wall agent, of whatever kind, whose sphere is nearest to the face's
/// centre (ties: the lower agent id), and an agent's stress is
///   wss = sum(A |traction|) / sum(A)   [Pa],
/// so that the sum of wss * area over the agents is what the wall carries, and no cell is charged with the
/// stress on an intact lamina beside it. Cells with AgentFlag::exposed that receive no face take the nearest
/// face's stress, with area 0. Without agents or wall faces nothing is given. The result does not depend on
/// the number of threads.
CellShear sampleWss(const AgentStore& agents, std::span<const WallFace> faces);

}  // namespace restenosis
