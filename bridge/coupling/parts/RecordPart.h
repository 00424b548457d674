#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "bridge/coupling/LumenExtraction.h"
#include "bridge/coupling/Part.h"
#include "bridge/coupling/PartContext.h"
#include "bridge/output/CrossCheckRecord.h"
#include "bridge/output/PlannedPart.h"
#include "bridge/output/PvdSeries.h"
#include "bridge/output/TimeSeries.h"

namespace restenosis {

/// Writes a state for the user: a row of the time series, the agents and the lumen for ParaView (model 10),
/// and once the struts.
class RecordPart : public Part {
 public:
  /// Nothing: every run records.
  static std::vector<PlannedPart> explain(const Scene& scene);
  static std::unique_ptr<RecordPart> make(const PartContext& context);
  /// `stent` is where it stands after deployment; `divisions` are those since then.
  RecordPart(Quantities& quantities, const Scene& scene, const ResultsFolder& folder, const Biology& biology,
             LumenExtraction& extraction, const std::optional<Stent>& stent, const std::uint64_t& divisions,
             const std::vector<CrossCheckRecord>& crossChecks, PartTimer& timer,
             std::shared_ptr<const Centreline> axis);

  std::string_view name() const override { return "record"; }
  bool isPurpose(const Instant&) const override { return true; }
  bool appliesAt(const Instant& now) const override { return now.recorded; }
  Verdict needs(Quantity quantity, const Instant& now) const override;
  void run(const Instant& now) override;

  /// Starts the files: empty ones, or those of the state that was read by `archiveFiles`.
  void begin();
  /// Nothing more is recorded. Throws WriteFailed.
  void end() { timeSeries_.end(); }
  const TimeSeries& timeSeries() const { return timeSeries_; }

  /// What has been recorded: part of a checkpoint.
  template <class Archive>
  void archiveFiles(Archive& a) {
    a(timeSeries_, tissue_, lumenFiles_, solvesRecorded_, crossChecksRecorded_);
  }

 private:
  TimeSeriesRow row(const Instant& now) const;
  void measureLumen(TimeSeriesRow& row) const;
  void measureFlow(TimeSeriesRow& row) const;
  void fillCrossCheck(TimeSeriesRow& row) const;

  Read<Quantity::cellStates> wall_ = read<Quantity::cellStates>();
  Read<Quantity::lumen> lumen_ = read<Quantity::lumen>();
  Read<Quantity::wallTraction> flow_ = read<Quantity::wallTraction>();
  const Scene& scene_;
  const Biology& biology_;
  LumenExtraction& extraction_;
  const std::optional<Stent>& stent_;
  const std::uint64_t& divisions_;
  const std::vector<CrossCheckRecord>& crossChecks_;
  PartTimer& timer_;
  std::shared_ptr<const Centreline> axis_;  ///< null of a straight vessel
  TimeSeries timeSeries_;
  PvdSeries tissue_, lumenFiles_;
  std::filesystem::path strutsFile_;
  std::uint64_t solvesRecorded_ = 0;       ///< solves of the flow before the last recorded state
  std::uint64_t crossChecksRecorded_ = 0;  ///< likewise
};

}  // namespace restenosis
