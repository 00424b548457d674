#pragma once

#include <string>

#include "tissue/parameters/ParameterVisitor.h"

namespace restenosis {

/// The vessel before stenting (model 2).
struct VesselParameters {
  static constexpr std::string_view section = "vessel";
  static constexpr std::string_view summary =
      "The vessel before stenting: a cylinder of packed agents, straight or bent, or one loaded";

  double length = 4.5e-3;          ///< [m]
  double lumenDiameter = 1.8e-3;   ///< [m]
  double wallThickness = 0.2e-3;   ///< [m]
  double cellRadius = 15e-6;       ///< mean radius of all wall agents [m]
  double radiusSpread = 0.0;       ///< standard deviation of the radius over its mean
  double packingFraction = 0.62;   ///< volume of all wall agents over volume of the wall
  double laminaCoverage = 0.82;    ///< area of a lamina's agents' cross-sections over its area
  double bondRange = 1.1;          ///< bonds join agents nearer than this times R1 + R2
  double fixedEnds = 2.0;          ///< centres within this many cell radii of an end never move
  double stenosis = 0.0;           ///< largest share of the diameter removed, halfway along
  double stenosisLength = 1.8e-3;  ///< [m]
  double curvatureRadius = 0.0;    ///< of the axis [m]; 0: straight
  std::string centreline;          ///< table or polyline of the axis, with radii or without
  std::string centrelineUnit = "mm";
  std::string agents;        ///< CSV of agents to load instead of packing
  std::string lumenSurface;  ///< STL of the lumen to use instead of a cylinder
  std::string lumenSurfaceUnit = "mm";
  bool lumenSurfaceIsBent = false;  ///< no key: found where tissue is built around the surface

  bool isBent() const { return curvatureRadius > 0 || !centreline.empty() || lumenSurfaceIsBent; }
  void describe(ParameterVisitor& p);
};

}  // namespace restenosis
