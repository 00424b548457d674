#pragma once

#include "FlowBackend.h"
#include "FoamExecution.h"
#include "FoamSettings.h"
#include "LumenCase.h"

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
  explicit FoamBackend(const FoamSettings& settings, const FoamExecution& execution = {})
      : settings_(settings), execution_(execution) {}
  std::string_view name() const override;
  FlowSolution solve(const TriSurface& lumen, const FlowConditions& conditions,
                     const std::filesystem::path& caseFolder) override;
  /// Read from the case of the last solution.
  std::vector<Vec3> velocities(const std::vector<Vec3>& points) const override;

 private:
  FlowSolution attempt(const std::filesystem::path& folder, const TriSurface& surface, const LumenCase& lumen,
                       const FlowConditions& conditions, Effort effort) const;
  /// A fresh case folder for one attempt; the logs of an earlier one are kept.
  void prepare(const std::filesystem::path& folder, const TriSurface& surface, const LumenCase& lumen,
               const FlowConditions& conditions, Effort effort) const;

  FoamSettings settings_;
  FoamExecution execution_;
  std::filesystem::path solved_;  ///< case of the last solution
};

}  // namespace restenosis
