#pragma once

#include "tissue/parameters/ParameterVisitor.h"

namespace restenosis {

/// Matrix that cells lay down (model 5).
struct ExtracellularMatrixParameters {
  static constexpr std::string_view section = "extracellularMatrix";
  static constexpr std::string_view summary = "Synthetic cells lay down matrix around themselves";

  double rate =
      0.2 / 86400.0;  ///< volume that a fully activated cell lays down, over its volume at birth [1/s]
  double largestShare = 0.6;  ///< of an agent's volume that is matrix

  void describe(ParameterVisitor& p);
};

}  // namespace restenosis
