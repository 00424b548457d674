#pragma once

#include "bridge/coupling/Part.h"
#include "bridge/coupling/PartContext.h"
#include "bridge/coupling/PlannedPart.h"
#include "bridge/output/PvdSeries.h"
#include "bridge/output/TimeSeries.h"

namespace restenosis {

/// Writes a state for the user: a row of the time series, the agents and the lumen for ParaView (model 10).
class RecordPart : public Part {
 public:
  /// Nothing: every run records.
  static std::vector<PlannedPart> explain(const Scene& scene);
  static std::unique_ptr<RecordPart> make(const PartContext& context);
  explicit RecordPart(World& world);
  std::string_view name() const override { return "record"; }
  std::vector<Quantity> reads() const override;
  std::vector<Quantity> writes() const override { return {}; }
  bool isPurpose(const Instant&) const override { return true; }
  bool appliesAt(const Instant& now) const override { return now.recorded; }
  Verdict needs(Quantity quantity, const Instant& now) const override;
  void run(const Instant& now) override;

  /// Starts the files: empty ones, or those of the state that was read by `archive`.
  void begin();
  /// Nothing more is recorded. Throws WriteFailed.
  void end() { timeSeries_.end(); }
  const TimeSeries& timeSeries() const { return timeSeries_; }

  template <class Archive>
  void archive(Archive& a) {
    a(timeSeries_, tissue_, lumen_);
  }

 private:
  TimeSeriesRow row(const Instant& now) const;
  void measureLumen(TimeSeriesRow& row) const;
  void measureFlow(TimeSeriesRow& row) const;

  World& world_;
  TimeSeries timeSeries_;
  PvdSeries tissue_, lumen_;
};

}  // namespace restenosis
