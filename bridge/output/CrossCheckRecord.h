#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace restenosis {

/// How another method's wall shear stress differs on a part of the lumen, over that of the run's own.
struct StressDifference {
  double mean = 0;  ///< of the means
  double l2 = 0;    ///< rms

  template <class Archive>
  void archive(Archive& a) {
    a(mean, l2);
  }
};

/// One solve of the flow by two methods. Empty: there is no such part, or nothing to decide.
struct CrossCheckRecord {
  double time = 0;  ///< of the solve, since deployment [s]
  std::optional<StressDifference> smoothWall, nearStruts, struts;
  /// Share of the covered cells that the other method's stress would have put to rest, or not, otherwise.
  std::optional<double> decidedOtherwise;

  template <class Archive>
  void archive(Archive& a) {
    a(time, smoothWall, nearStruts, struts, decidedOtherwise);
  }
};

/// All of a run.
struct CrossCheckSummary {
  std::string method;  ///< flow.crossCheck
  std::vector<CrossCheckRecord> checks;
  std::uint64_t failed = 0;
  double seconds = 0, shareOfFlow = 0;  ///< wall clock; over that of meshes and flows
};

}  // namespace restenosis
