#pragma once

#include <array>
#include <vector>

#include "bridge/compare/CarriedTraction.h"
#include "bridge/compare/ComparedParts.h"
#include "bridge/compare/FieldDifference.h"
#include "bridge/compare/ProbeLines.h"
#include "bridge/flow/FlowBackend.h"

namespace restenosis {

/// One backend's answer and what it took.
struct SolvedFlow {
  std::string backend;
  FlowSolution solution;
  double seconds = 0.0;          ///< from the surface to the solution, by wall clock
  std::vector<Vec3> velocities;  ///< at ProbeLines::points [m/s]; empty: not known
};

/// Solves for this lumen and asks for the velocities. Throws FlowFailed.
SolvedFlow solveForComparison(FlowBackend& backend, const TriSurface& lumen, const ProbeLines& lines,
                              const FlowConditions& conditions, const std::filesystem::path& caseFolder);

/// Two flows in one lumen, side by side; the first is the reference.
struct FlowComparison {
  ComparedFaces faces;
  std::array<std::vector<Vec3>, 2> traction;                ///< on the faces [Pa]
  std::array<FieldDifference, comparedParts.size()> parts;  ///< of wall shear stress, by ComparedPart
  FieldDifference wall, strut;                              ///< by region, ends left out
  std::size_t unknownFaces = 0;                             ///< on which a flow gives no stress
  ProbeLines lines;
  bool hasVelocities = false;
  FieldDifference axis;                 ///< of the velocity's component along the vessel
  std::vector<FieldDifference> planes;  ///< the same, by plane
};

/// `struts`: places on the struts' middles, as far as known; see comparedFaces.
FlowComparison compareFlows(const TriSurface& lumen, const ProbeLines& lines, const SolvedFlow& reference,
                            const SolvedFlow& other, std::span<const Vec3> struts);

}  // namespace restenosis
