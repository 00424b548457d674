#pragma once

#include <string>

#include "tissue/parameters/ParameterVisitor.h"

namespace restenosis {

/// Return of the endothelium and its nitric oxide (model 7).
struct EndotheliumParameters {
  static constexpr std::string_view section = "endothelium";
  static constexpr std::string_view summary =
      "Endothelium returns and turns wall shear stress into nitric oxide";

  std::string scenario = "3-23 days";
  double maturationTime = 0;  ///< in which a new endothelium comes to make all its nitric oxide but 1/e [s]
  double nitricOxideReach =
      0;  ///< distance over which nitric oxide falls to 1/e [m]; 0: it stays in the cell
  double nitricOxideThreshold = 0.001;  ///< [nmol/mm^3], which is [mol/m^3]
  // NO = slope w up to the transition, constant + first w + second w^2 above it; w [Pa], NO [nmol/mm^3].
  double nitricOxideSlope = 0.00366;
  double nitricOxideTransition = 1.05;
  double nitricOxideConstant = 0.062;
  double nitricOxideFirst = -0.11;
  double nitricOxideSecond = 0.052;

  void describe(ParameterVisitor& p);
};

}  // namespace restenosis
