#pragma once

#include <string>

#include "ParameterVisitor.h"

namespace restenosis {

/// Return of the endothelium and its nitric oxide (model 7).
struct EndotheliumParameters {
  static constexpr std::string_view section = "endothelium";
  static constexpr std::string_view summary =
      "Endothelium returns and turns wall shear stress into nitric oxide";

  std::string scenario = "3-23 days";
  double nitricOxideThreshold = 0.001;  ///< [nmol/mm^3]

  void describe(ParameterVisitor& p);
};

}  // namespace restenosis
