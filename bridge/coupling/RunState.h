#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bridge/coupling/CrossCheck.h"
#include "bridge/coupling/LumenExtraction.h"
#include "bridge/coupling/Quantities.h"
#include "bridge/output/PartTimer.h"
#include "bridge/output/Progress.h"
#include "bridge/output/ResultsFolder.h"
#include "bridge/scene/Scene.h"
#include "bridge/surface/VesselAxis.h"
#include "tissue/biology/Biology.h"
#include "tissue/stent/DeploymentStatistics.h"
#include "tissue/stent/Injury.h"
#include "tissue/stent/Stent.h"
#include "tissue/vessel/OuterConfinement.h"
#include "tissue/vessel/WallPacking.h"

namespace restenosis {

/// What bringing growing tissue back to equilibrium took since the start.
struct RelaxationWork {
  std::uint64_t iterations = 0;
  std::uint64_t agentEvaluations = 0;  ///< forces computed, one an agent
  double residual = 0;                 ///< largest of a free agent after the last time: AgentForce::residual

  template <class Archive>
  void archive(Archive& a) {
    a(iterations, agentEvaluations, residual);
  }
};

/// The state of a run, and where it is told. What `archive` passes on is the state: a run read back from it
/// goes on as if it had never stopped. The rest is given by the scene, or made again from the state when it
/// is missing. Parts do not see it: each is given what it names (PartContext).
struct RunState {
  RunState(const Scene& scene, const ResultsFolder& folder, Progress& progress);

  const Scene& scene;
  const ResultsFolder& folder;
  Progress& progress;
  PartTimer timer;

  Quantities quantities;
  std::shared_ptr<const Centreline> axis;  ///< of a bent vessel; all else here is of the straight one
  std::optional<Stent> stent;              ///< where it stands after deployment
  LumenExtraction extraction;
  Biology biology;
  std::optional<PackingReport> packing;            ///< of a wall that was packed, not loaded
  std::optional<DeploymentStatistics> deployment;  ///< before injury
  std::optional<InjuryReport> injury;
  OuterConfinement confinement;  ///< by the EEL as growth found it; it holds its place
  std::uint64_t divisions = 0;   ///< since deployment
  RelaxationWork relaxation;
  CrossCheckState crossCheck;
  std::vector<std::string> remarks;
  /// Whether, as far as is known, a run from the start would end in the same state.
  bool reproducible = true;

  /// Adds a remark, if there is one, and says it.
  void remark(const std::string& text);
  /// Whether the last flow was solved with the settings of the scene. True before the first.
  bool lastFlowHasTheseSettings() const;

  template <class Archive>
  void archive(Archive& a) {
    a(quantities, biology, packing, deployment, injury, confinement, divisions, relaxation, crossCheck,
      remarks, reproducible, timer);
  }
};

}  // namespace restenosis
