#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "bridge/scene/Scene.h"

namespace restenosis {

/// What the flow of a scene will take, estimated from one solve in the lumen as the scene gives it.
struct FlowCost {
  double pieces = 0;
  std::string_view kind;                        ///< what these are: cells, lattice nodes, places on the wall
  double bytes = 0;                             ///< of the solver, and of the program beside its tissue
  double secondsASolve = 0;                     ///< with the mesh, on two cores
  std::uint32_t fewSolves = 1, manySolves = 1;  ///< likely, where the tissue decides how often
};

/// What the tissue of a scene will take without its flow.
struct TissueCost {
  double agents = 0;     ///< with those of the struts
  double struts = 0;     ///< of these
  bool counted = false;  ///< in a table, not estimated
  double bytes = 0;
  double seconds = 0;    ///< on two cores
  std::string openEnds;  ///< what is to be said of a loaded wall; or empty
};

/// From so many cells of OpenFOAM's mesh on two processes are faster than one. Measured: with 78,000 they
/// take 0.73 of its time, with some 15,000 they take 1.1.
inline constexpr double cellsWorthTwoRanks = 5e4;

/// Processes of OpenFOAM where none are asked for: two or one, by the cells that are expected in the lumen as
/// the scene gives it. The scene has a flow. Throws as loadLumen does.
int usualRanks(const Scene& scene);

/// Nothing where no flow is solved. Throws as loadLumen does.
std::optional<FlowCost> flowCost(const Scene& scene);
/// Nothing where there is no tissue. Throws as makeStent does.
std::optional<TissueCost> tissueCost(const Scene& scene);

/// Both in words, a line each.
std::string costText(const Scene& scene);

}  // namespace restenosis
