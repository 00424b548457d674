#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bridge/coupling/LumenExtraction.h"
#include "bridge/coupling/Part.h"
#include "bridge/coupling/PartContext.h"
#include "bridge/flow/FlowBackend.h"
#include "bridge/output/PlannedPart.h"
#include "tissue/biology/ArrestRules.h"

namespace restenosis {

/// Solves blood flow in the present lumen (model 8). It is due when 1 % of the lumen has moved by more than
/// the tolerance, or when it has moved that far at more than a share of the cells that a change of their
/// stress may send to rest or wake (ArrestRules::undecidedCells): these are few, and stand where the tissue
/// grows. And when the last solve was made with other settings, by a run that was then resumed.
class FlowPart : public Part {
 public:
  static std::vector<PlannedPart> explain(const Scene& scene);
  static std::unique_ptr<FlowPart> make(const PartContext& context);
  /// The scene has [flow]. Remarks on solves are added to `remarks`.
  FlowPart(Quantities& quantities, const Scene& scene, const ResultsFolder& folder, const ArrestRules& rules,
           LumenExtraction& extraction, std::vector<std::string>& remarks, PartTimer& timer,
           std::unique_ptr<FlowBackend> backend);

  std::string_view name() const override { return "flow"; }
  Verdict inputsChanged(const Instant& now) const override;
  /// Throws FlowFailed, or Occluded when the lumen has closed.
  void run(const Instant& now) override;
  bool takesLong() const override { return true; }

  /// Digests of what a solve would read of a former case, as it is now; empty where that is nothing. Throws
  /// std::runtime_error where it cannot be read.
  FileDigests startFiles(const std::filesystem::path& formerCase) const;

 private:
  /// Share of the undecided cells where the lumen has moved by more than the tolerance since the last solve.
  double undecidedShareMoved() const;
  /// Refuses a lumen that is too narrow, too short or too large for the backend as the scene gives it. Later
  /// ones may be narrower: tissue grows. Throws FlowFailed.
  void requireResolution() const;
  /// Throws FlowFailed.
  void requireMeshable(const TriSurface& lumen, const std::filesystem::path& folder) const;
  void solve(FlowState& flow, const TriSurface& lumen, const Instant& now);
  /// Throws FlowFailed where the exact answer is known, and the solution is far from it.
  void requirePoiseuille(const FlowSolution& solution, const FlowConditions& conditions,
                         const std::filesystem::path& folder) const;
  /// The same as startFiles, or none where they cannot be read: the next solve says so when it comes to them.
  FileDigests startFilesOrNone(const std::filesystem::path& folder) const;
  void remark(FlowState& flow, const Instant& now, const std::string& text);

  Read<Quantity::lumen> lumen_ = read<Quantity::lumen>();
  Write<Quantity::wallTraction> flow_ = write<Quantity::wallTraction>();
  Read<Quantity::wallShearStress> stress_ = observe<Quantity::wallShearStress>();
  Read<Quantity::agentPositions> wall_ = observe<Quantity::agentPositions>();
  const Scene& scene_;
  const ResultsFolder& folder_;
  const ArrestRules& rules_;
  LumenExtraction& extraction_;
  std::vector<std::string>& remarks_;
  PartTimer& timer_;
  std::unique_ptr<FlowBackend> backend_;
  std::map<std::string, std::string> settings_;  ///< flowSettings of the scene
};

}  // namespace restenosis
