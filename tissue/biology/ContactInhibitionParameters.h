#pragma once

#include <cstdint>
#include <string>

#include "tissue/parameters/ParameterVisitor.h"

namespace restenosis {

/// Contact inhibition (model 6).
struct ContactInhibitionParameters {
  static constexpr std::string_view section = "contactInhibition";
  static constexpr std::string_view summary = "Crowded cells rest";

  std::string law = "exposure";
  double exposureThreshold = 0.15;
  double exposureRange = 2.0;  ///< neighbours within this times R1 + R2 cover directions
  double cellCover = 1.25;     ///< a cell covers the cone of this times its radius
  double laminaCover = 1.9;    ///< a lamina agent covers the cone of this times its radius
  std::int64_t directions = 60;
  /// Share of its radius that an agent may move or grow before cells near it are evaluated again.
  double changeTolerance = 0.02;
  double countRange = 2.0;  ///< neighbourCount: neighbours within this times R1 + R2 count
  double countThreshold = 26;
  double stressThreshold = 2000;  ///< stress: a cell under a larger one is inhibited [Pa]
  double smcWeight = 1, ielWeight = 1, eelWeight = 1, strutWeight = 0.1;

  void describe(ParameterVisitor& p);
};

}  // namespace restenosis
