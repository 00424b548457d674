#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bridge/flow/PoiseuilleError.h"
#include "bridge/output/CrossCheckRecord.h"
#include "bridge/output/PartTimer.h"
#include "bridge/output/PlannedPart.h"
#include "bridge/output/Provenance.h"
#include "bridge/output/TimeSeriesRow.h"
#include "bridge/scene/DefaultDifferences.h"
#include "tissue/stent/DeploymentStatistics.h"
#include "tissue/stent/Injury.h"
#include "tissue/vessel/WallPacking.h"

namespace restenosis {

/// What summary.json says of a run; see `writeSummaryJson`.
struct Summary {
  std::string scene, title;
  std::string status = "finished";  ///< or what ended the run
  std::int64_t seed = 0;
  int threads = 1;
  int ranks = 1;                 ///< MPI processes of OpenFOAM
  std::string flowBackend;       ///< empty when no flow is modelled
  std::string sceneFingerprint;  ///< of all keys and files that decide the result, empty if these changed
  std::string stateDigest;
  TimeSeriesRow last;                              ///< the final values
  std::optional<PackingReport> packing;            ///< where the wall was packed
  std::optional<DeploymentStatistics> deployment;  ///< where there is a stent
  std::optional<InjuryReport> injury;              ///< where a scene injures
  std::uint64_t flowSolvesDone = 0;
  std::map<std::string, std::uint64_t> flowSolvesSkipped;   ///< how often, by reason
  std::uint64_t flowMeshesMoved = 0;                        ///< solves in the former mesh, moved
  std::vector<std::pair<std::string, OutletFlow>> outlets;  ///< by name, of a lumen with several
  std::optional<BeatSummary> beats;                         ///< of the last flow, where it beats
  std::map<std::string, std::uint64_t> flowRemeshed;  ///< the others, where meshes may be moved, by reason
  std::optional<CrossCheckSummary> crossCheck;        ///< where the flow is cross-checked
  std::uint64_t relaxationIterations = 0, agentEvaluations = 0;
  double relaxationResidual = 0;              ///< after the last one: AgentForce::residual
  std::optional<PoiseuilleError> poiseuille;  ///< in scenes where the exact stress is known
  std::map<std::string, PartCost> parts;
  std::vector<std::string> remarks;  ///< warnings and retries of all parts
  std::vector<PlannedPart> plan;
  std::vector<DefaultDifference> differences;  ///< of the scene, from the defaults
  Provenance provenance;
};

/// Writes summary.json: scene, title, status, version, seed, threads, ranks, agents, sceneFingerprint,
/// stateDigest, final (the columns of timeSeries.csv; null where unknown), packing, deployment and injury
/// (what they did, null without), flow (solves done, skipped, and skipped by reason; meshes moved, and made
/// anew by reason; of the last one's beats what they showed, null of steady flow; of several outlets what
/// went through each, with its share and its mean pressure less that of the first), crossCheck (method,
/// number, time, and the ranges of what it found; null without), relaxation (iterations during growth, forces
/// computed, the largest residual after the last one), poiseuille (errors, null where the exact stress is not
/// known), parts (seconds and peak memory), totalSeconds, remarks, plan (each part: whether it runs, and when
/// or why not), differsFromDefaults (of the scene), provenance (command, folder, host, time). Throws
/// WriteFailed.
void writeSummaryJson(const std::filesystem::path& file, const Summary& summary);

}  // namespace restenosis
