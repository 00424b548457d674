#pragma once

#include "FlowBackend.h"
#include "FoamSettings.h"

namespace restenosis {

/// Steady laminar flow by OpenFOAM: the case template is filled with the lumen, meshed by snappyHexMesh and
/// solved by simpleFoam, each program with its own log in the case (log.snappyHexMesh, ...).
///
/// Nothing is believed that was not checked: the surface before it is meshed; the mesher's own verdict, the
/// mesh's volume, patches and quality; convergence, flow rates, pressure drop and stresses. After a
/// violated check of the mesh or the solution, a second attempt is made with more careful meshing and
/// stronger relaxation, and recorded in FlowSolution::remarks; the logs of the first stay in `firstAttempt`.
/// Then FlowFailed names the step, the reason and the log.
class FoamBackend : public FlowBackend {
 public:
  explicit FoamBackend(const FoamSettings& settings) : settings_(settings) {}
  std::string_view name() const override;
  FlowSolution solve(const TriSurface& lumen, const FlowConditions& conditions,
                     const std::filesystem::path& caseFolder) override;

 private:
  FoamSettings settings_;
};

}  // namespace restenosis
