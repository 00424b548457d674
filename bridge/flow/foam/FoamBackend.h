#pragma once

#include <span>

#include "bridge/flow/FlowBackend.h"
#include "bridge/flow/foam/FoamExecution.h"
#include "bridge/flow/foam/FoamSettings.h"
#include "bridge/flow/foam/FoamStart.h"
#include "bridge/flow/foam/LumenCase.h"

namespace restenosis {

/// Steady laminar flow by OpenFOAM: the case template is filled with the lumen, meshed by snappyHexMesh and
/// solved by simpleFoam, each program with its own log in the case (log.snappyHexMesh, ...).
///
/// With the case of a former solve (startFrom) the solver starts from its flow, and with Remeshing::onDemand
/// the mesh is the former one, moved onto the lumen, as long as that keeps within the limits of FoamSettings.
/// A moved mesh that does not, or in which the flow is not solved, is replaced by a new one.
///
/// Nothing is believed that was not checked: the surface before it is meshed; the mesher's own verdict, the
/// mesh's volume, patches and quality; convergence, flow rates, pressure drop and stresses. After a
/// violated check of the mesh or the solution, a second attempt is made with more careful meshing and
/// stronger relaxation, and, where the mesh fails once more, a third with other cells; FlowSolution::remarks
/// says so. The logs of the first stay in `firstAttempt`, those of the second in `secondAttempt`, those of a
/// moved mesh that was given up in `movedMesh`.
/// Then FlowFailed names the step, the reason and the log.
class FoamBackend : public FlowBackend {
 public:
  enum class Remeshing : std::uint8_t { always, onDemand };
  explicit FoamBackend(const FoamSettings& settings, const FoamExecution& execution = {},
                       Remeshing remeshing = Remeshing::always)
      : settings_(settings), execution_(execution), remeshing_(remeshing) {
    execution_.silenceLimit = std::chrono::duration<double>(settings.silenceLimit);
  }
  std::string_view name() const override;
  FlowSolution solve(const TriSurface& lumen, const FlowConditions& conditions,
                     const std::filesystem::path& caseFolder) override;
  void startFrom(const std::filesystem::path& formerCase) override;
  bool needsFormerCase() const override;
  std::vector<std::filesystem::path> filesToStartFrom(const std::filesystem::path& formerCase) const override;
  /// Read from the case of the last solution.
  std::vector<Vec3> velocities(const std::vector<Vec3>& points) const override;

 private:
  /// solve() in a lumen that has been measured.
  FlowSolution solveMeasured(const TriSurface& lumen, const LumenCase& shape,
                             const FlowConditions& conditions, const std::filesystem::path& folder);
  /// A case that has been solved, which another is started from.
  struct Former {
    std::filesystem::path folder;
    FoamSolution solution;
  };
  /// How a solve is attempted.
  struct Attempt {
    enum class Mesh : std::uint8_t { made, moved, oGrid };
    Mesh mesh = Mesh::made;
    Effort effort = Effort::normal;
    const Former* former = nullptr;  ///< null: from rest. Not null for Mesh::moved
    double cells = 1.0;              ///< size of the cells over that of the settings
    /// Folder in the case for the logs of the attempt before; empty for none.
    std::string_view keepLogsIn = {};
  };
  FlowSolution attempt(const std::filesystem::path& folder, const TriSurface& surface, const LumenCase& lumen,
                       const FlowConditions& conditions, const Attempt& how) const;
  /// The settings with cells of so many times the size.
  FoamSettings settingsFor(double cells) const;
  struct FurtherAttempt;
  /// Up to three attempts with a new mesh; `how` is for the first.
  FlowSolution solveWithNewMesh(const std::filesystem::path& folder, const TriSurface& surface,
                                const LumenCase& lumen, const FlowConditions& conditions,
                                const Attempt& how) const;
  /// The first of these attempts and, where its mesh fails, the others. `before`: what is said of those
  /// before.
  FlowSolution solveOnceMore(const std::filesystem::path& folder, const TriSurface& lumen,
                             const FlowConditions& conditions, std::span<const FurtherAttempt> attempts,
                             const std::string& before, const std::filesystem::path& logBefore) const;
  /// A fresh case folder for one attempt; the logs of an earlier one are kept.
  void prepare(const std::filesystem::path& folder, const TriSurface& surface, const LumenCase& lumen,
               const FlowConditions& conditions, const Attempt& how) const;

  FoamSettings settings_;
  FoamExecution execution_;
  Remeshing remeshing_;
  std::filesystem::path former_;  ///< case that the next solve starts from; empty for none
  std::filesystem::path solved_;  ///< case of the last solution
};

}  // namespace restenosis
