#include "bridge/surface/SceneStent.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "bridge/surface/LengthUnit.h"
#include "bridge/surface/LoadedStruts.h"
#include "bridge/surface/SolidCover.h"
#include "bridge/surface/SurfaceFile.h"
#include "tissue/parameters/LengthUnits.h"
#include "tissue/stent/StrutAgents.h"
#include "tissue/vessel/Cylindrical.h"
#include "tissue/vessel/TableBounds.h"

namespace restenosis {
namespace {

/// Share of the struts' surface that may be at places too thin for any sphere, such as sharp edges (assumed).
constexpr double mostTooThin = 0.1;
/// Spheres that a stent may have: assumed, far beyond any use.
constexpr double mostSpheres = 2e6;

class SurfaceStruts {
 public:
  SurfaceStruts(const StentParameters& stent, const VesselParameters& vessel)
      : stent_(stent), vessel_(vessel), surface_(loadStruts(stent.file, metresPer(stent.fileUnit))) {}

  AgentTable spheres() const {
    requirePlace();
    requireSize();
    const SolidCover cover = coverSolid(surface_, vessel_.cellRadius, tableBounds::leastStrutRadius);
    if (cover.tooThin > mostTooThin)
      refuse(
          fmt::format("{:.3g} % of the struts' surface is where they are thinner than {:.4g} um; allowed "
                      "are {:.3g} %",
                      100 * cover.tooThin, 2 * tableBounds::leastStrutRadius / um, 100 * mostTooThin));
    AgentTable result;
    result.file = stent_.file;
    for (const Ball& ball : cover.balls) result.agents.append(AgentKind::strut, ball.centre, ball.radius);
    return result;
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw std::runtime_error(fmt::format("{}: {}. Its length unit is taken to be {} (fileUnit)", stent_.file,
                                         what, stent_.fileUnit));
  }

  void requirePlace() const {
    double low = HUGE_VAL, high = -HUGE_VAL, farthest = 0;
    for (const Vec3& v : surface_.vertices) {
      low = std::min(low, v.z());
      high = std::max(high, v.z());
      farthest = std::max(farthest, radiusOf(v));
    }
    const double slack = 1e-6 * vessel_.length;  // coordinates of a file are single precision
    if (low < -slack || high > vessel_.length + slack)
      refuse(
          fmt::format("the struts reach from z = {:.6g} to {:.6g} um; allowed are 0 to {:.6g} um "
                      "(vessel.length)",
                      low / um, high / um, vessel_.length / um));
    if (farthest > tableBounds::farthest(vessel_))
      refuse(
          fmt::format("the struts reach {:.6g} um from the axis (x = y = 0); allowed are at most {:.6g} "
                      "um, 1.5 times the outer radius of the wall in [vessel]",
                      farthest / um, tableBounds::farthest(vessel_) / um));
  }

  /// What would fill the machine is found before it does.
  void requireSize() const {
    double area = 0;
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t) area += surface_.areaVector(t).norm();
    const double count = area / (vessel_.cellRadius * vessel_.cellRadius);
    if (count > mostSpheres)
      refuse(
          fmt::format("the struts' surface of {:.3g} mm2 takes about {:.2g} spheres of vessel.cellRadius; "
                      "at most {:.2g} are allowed",
                      area * 1e6, count, mostSpheres));
  }

  const StentParameters& stent_;
  const VesselParameters& vessel_;
  TriSurface surface_;
};

}  // namespace

AgentTable readStruts(const StentParameters& stent, const VesselParameters& vessel) {
  if (isSurfaceFile(stent.file)) return SurfaceStruts(stent, vessel).spheres();
  return readAgentTable(stent.file, AgentKind::strut);
}

std::string describeStentFile(const StentParameters& stent) {
  return isSurfaceFile(stent.file) ? describeStruts(stent.file, metresPer(stent.fileUnit)) : "";
}

Stent makeStent(const StentParameters& stent, const VesselParameters& vessel) {
  return stent.file.empty() ? stentOfDesign(stent, vessel)
                            : stentOfSpheres(readStruts(stent, vessel), vessel);
}

}  // namespace restenosis
