#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bridge/coupling/AlikeRemarks.h"
#include "bridge/coupling/ChangeLedger.h"
#include "bridge/flow/FlowBackend.h"
#include "bridge/output/FileDigests.h"
#include "bridge/output/PartTimer.h"
#include "bridge/output/Progress.h"
#include "bridge/output/ResultsFolder.h"
#include "bridge/scene/Scene.h"
#include "bridge/surface/LumenField.h"
#include "bridge/surface/RadialMap.h"
#include "bridge/surface/TriSurface.h"
#include "tissue/biology/Biology.h"
#include "tissue/stent/DeploymentStatistics.h"
#include "tissue/stent/Injury.h"
#include "tissue/stent/Stent.h"
#include "tissue/vessel/OuterConfinement.h"
#include "tissue/vessel/Wall.h"
#include "tissue/vessel/WallPacking.h"

namespace restenosis {

/// The lumen: its shape now, and the shapes it is compared with.
struct LumenState {
  RadialMap present;
  RadialMap afterDeployment;  ///< what neointima is measured against
  RadialMap atLastFlow;       ///< what `lumenTolerance` is measured against; empty before the first solve
  std::uint64_t detachedPieces = 0;  ///< pieces of tissue in the lumen that no flow sees
  bool closed = false;               ///< whether nothing open joins its ends

  template <class Archive>
  void archive(Archive& a) {
    a(present, afterDeployment, atLastFlow, detachedPieces, closed);
  }
};

/// The last flow solution, as long as it holds.
struct FlowState {
  std::optional<FlowSolution> last;
  double time = 0;                                       ///< of that solve [s]
  std::uint64_t solves = 0;                              ///< since the start
  std::uint64_t solvesRecorded = 0;                      ///< of these, before the last recorded state
  std::uint64_t meshesMoved = 0;                         ///< solves whose mesh was the former one, moved
  std::map<std::string, std::uint64_t> remeshedBecause;  ///< how often it was not, by reason
  std::map<std::string, std::string> settings;           ///< of its backend (flowSettings)
  bool mixed = false;                                    ///< whether earlier solves had others
  AlikeRemarks remarked;                                 ///< in World::remarks
  FileDigests startFiles;  ///< what the next solve reads of the case of that one; empty for nothing
  bool fromRest = false;   ///< the next solve has no case to start from: it was lost

  template <class Archive>
  void archive(Archive& a) {
    a(last, time, solves, solvesRecorded, meshesMoved, remeshedBecause, settings, mixed, remarked, startFiles,
      fromRest);
  }
};

/// What bringing growing tissue back to equilibrium took since the start.
struct RelaxationWork {
  std::uint64_t iterations = 0;
  std::uint64_t agentEvaluations = 0;  ///< forces computed, one an agent
  double residual = 0;  ///< largest of a free agent, asleep or not, after the last time: AgentForce::residual

  template <class Archive>
  void archive(Archive& a) {
    a(iterations, agentEvaluations, residual);
  }
};

/// Everything that a run's parts share. What `archive` passes on is the state: a run read back from it goes
/// on as if it had never stopped. The rest is given by the scene, or made again from the state when it is
/// missing.
struct World {
  World(const Scene& scene, const ResultsFolder& folder, Progress& progress);

  const Scene& scene;
  const ResultsFolder& folder;
  Progress& progress;
  PartTimer timer;

  Wall wall;
  std::optional<Stent> stent;  ///< where it stands after deployment
  Biology biology;
  LumenState lumen;
  FlowState flow;
  ChangeLedger changes;
  std::optional<PackingReport> packing;            ///< of a wall that was packed, not loaded
  std::optional<DeploymentStatistics> deployment;  ///< before injury
  std::optional<InjuryReport> injury;
  OuterConfinement confinement;  ///< by the EEL as growth found it; it holds its place
  std::uint64_t divisions = 0;   ///< since deployment
  RelaxationWork relaxation;
  std::vector<std::string> remarks;
  /// Whether, as far as is known, a run from the start would end in the same state.
  bool reproducible = true;
  /// Case of the last solve that the checkpoint knows; empty for none. A resumed run may need it.
  std::filesystem::path caseInCheckpoint;

  /// Adds a remark, if there is one, and says it.
  void remark(const std::string& text);
  /// Whether the last flow was solved with the settings of the scene. True before the first.
  bool lastFlowHasTheseSettings() const;
  /// The triangulated lumen of when updateLumen was last called; after a resumption, of the present agents.
  /// Throws Occluded.
  const TriSurface& lumenSurface();
  /// Takes the lumen's shape from the present agents.
  void updateLumen();
  /// Agents are about to move: what was taken of the lumen to make its surface is given back.
  void forgetLumen();
  /// Whether the lumen is a surface from a file. It has no radial map: LumenState stays empty.
  bool hasLoadedLumen() const { return scene.hasLoadedLumen(); }
  /// Stretch of the vessel that neointima is averaged over [m]: the stented one, or all of it.
  std::pair<double, double> measuredSection() const;

  template <class Archive>
  void archive(Archive& a) {
    a(wall, biology, lumen, flow, changes, packing, deployment, injury, confinement, divisions, relaxation,
      remarks, reproducible, timer);
  }

 private:
  void takeLumen();

  std::optional<LumenField> field_;    ///< of tissue, until the surface is made
  std::optional<TriSurface> surface_;  ///< of the field, or loaded; made when it is asked for
};

/// The settings of a scene's biology.
BiologySettings biologySettings(const Scene& scene);

}  // namespace restenosis
