#include "bridge/scene/LumenSurfaceChecks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bridge/flow/FlowBackendNames.h"
#include "bridge/flow/LumenFrame.h"
#include "bridge/flow/LumenShape.h"
#include "bridge/flow/OutletTable.h"
#include "bridge/flow/StraightEnds.h"
#include "bridge/scene/ArteryWidth.h"
#include "bridge/scene/LoadedWall.h"
#include "bridge/scene/SectionReader.h"
#include "bridge/surface/CentrelineFile.h"
#include "bridge/surface/LengthUnit.h"
#include "bridge/surface/LoadedLumen.h"
#include "bridge/surface/SectionAxis.h"
#include "bridge/surface/VesselAxis.h"
#include "bridge/surface/WallOutwards.h"
#include "tissue/parameters/IgnoringVisitor.h"
#include "tissue/parameters/LengthUnits.h"
#include "tissue/parameters/NameList.h"

namespace restenosis {
namespace {

/// How many times larger or smaller than `lumenDiameter` an inlet may be, and than `length` a straight lumen
/// (assumed): a mistaken unit is 1000.
constexpr double plausibleRatio = 3.0;

bool implausible(double ratio) { return ratio > plausibleRatio || ratio < 1.0 / plausibleRatio; }

/// A wall is as long as the lumen that it is built around; a given length may be rounded (assumed).
constexpr double sameLength = 0.01;

void blame(std::string_view section, std::string_view key, const std::string& message,
           const SceneDocument& document, SceneFindings& findings) {
  findings.add(document.placeOf(section, key), fmt::format("'{}' in [{}]: {}", key, section, message));
  findings.unreliable.insert(fmt::format("{}.{}", section, key));
}

bool gives(const SceneDocument& document, const std::string& key) {
  return document.find(VesselParameters::section, key) != nullptr;
}

/// What the schema says of a quantity.
class QuantityInfo final : public IgnoringVisitor {
 public:
  explicit QuantityInfo(std::string_view key) : key_(key) {}
  ParameterInfo info;

  void quantity(double&, const ParameterInfo& visited) override {
    if (visited.key == key_) info = visited;
  }

 private:
  std::string_view key_;
};

/// Why a file's own length cannot be the vessel's, which the scene of the results names; empty if it can.
/// `is`: how long it is, in words.
std::string lengthProblem(VesselParameters vessel, const Units& units, const std::string& is) {
  QuantityInfo length("length");
  vessel.describe(length);
  if (vessel.length <= units.toSi(length.info.maximum, length.info.unit)) return {};
  return fmt::format("{}, too long for 'length'; allowed: {}", is, boundsText(length.info));
}

std::string endsOf(const TriSurface& lumen) {
  const double cosine = std::clamp(
      -endPlane(lumen, SurfaceRegion::inlet).normal.dot(endPlane(lumen, SurfaceRegion::outlet).normal), -1.0,
      1.0);
  const double degrees = std::acos(cosine) * 180 / std::numbers::pi;
  if (degrees > 0.1) return fmt::format("its ends are {:.3g} degrees from parallel", degrees);
  return "part of it lies beyond the planes of its ends";
}

/// Whether tissue can be built around the lumen, and the scene's stent begins inside it.
template <class Blame>
void checkWall(const Scene& scene, const Blame& blameVessel) {
  const VesselParameters& vessel = scene.vessel;
  const std::string_view key = vessel.lumenSurface.empty() ? "centreline" : "lumenSurface";
  try {
    const TriSurface lumen = lumenOfTissue(vessel);
    wallOutwards(lumen, vessel);
    if (!scene.stent) return;
    const RadiusMap fromAxis = lumenFromAxis(lumen, vessel.cellRadius);
    const double narrowest = std::ranges::min(fromAxis.values());
    if (vessel.lumenDiameter / 2 <= narrowest + vessel.cellRadius) return;
    blameVessel(
        "lumenDiameter",
        fmt::format("the stent is put to the radius of {:.4g} mm, half of 'lumenDiameter' (the inlet's "
                    "where it is not given), but '{}' comes as near as {:.4g} mm to its axis; "
                    "allowed is at most \"{:.4g} mm\", from where 'deploymentDepth' in [stent] counts",
                    1e3 * vessel.lumenDiameter / 2, key, 1e3 * narrowest, 2e3 * narrowest));
  } catch (const std::exception& error) {
    blameVessel(key, error.what());
  }
}

/// Straight ends of a bent lumen may run into it.
void checkStraightEnds(const TriSurface& lumen, double length, const SceneDocument& document,
                       SceneFindings& findings) try {
  requireRoomForStraightEnds(lumen, length);
} catch (const std::invalid_argument& error) {
  blame(FlowParameters::section, "straightEnds",
        fmt::format("{}; there is room for {:.4g} mm, or leave it out", error.what(),
                    longestStraightEnds(lumen, length) / mm),
        document, findings);
}

/// Whether the table of outlets names those of the surface; empty where it does. What is wrong with the table
/// itself is said elsewhere.
std::string outletProblem(const Scene& scene, const std::vector<std::string>& ofSurface) try {
  if (scene.outlets() == Outlets::one) return {};
  if (ofSurface.empty())
    return "'lumenSurface' has not several solids that are named as outlets; it needs one for each line of "
           "the table";
  std::vector<std::string> ofTable;
  for (const Outlet& outlet : scene.flow->outletsOfTable()) ofTable.push_back(outlet.name);
  if (ofTable == ofSurface) return {};
  const auto list = [](const std::vector<std::string>& names) {
    return commaSeparated(std::vector<std::string_view>(names.begin(), names.end()));
  };
  return fmt::format("the table names the outlets {}, but 'lumenSurface' has {}", list(ofTable),
                     list(ofSurface));
} catch (const TableError&) {
  return {};
}

double distanceOfEnds(const TriSurface& lumen) {
  return (endPlane(lumen, SurfaceRegion::outlet).centre - endPlane(lumen, SurfaceRegion::inlet).centre)
      .norm();
}

/// A bent lumen is longer than its ends are apart: as long as its volume over an end's area, or longer.
LoadedExtent extentOf(const TriSurface& lumen) {
  const double volume = enclosedVolume(lumen);
  const double section =
      std::min(endPlane(lumen, SurfaceRegion::inlet).area, endPlane(lumen, SurfaceRegion::outlet).area);
  return {endDiameter(lumen, SurfaceRegion::inlet), std::max(distanceOfEnds(lumen), volume / section),
          volume};
}

}  // namespace

std::optional<LoadedExtent> takeLumenSurface(Scene& scene, const SceneDocument& document, const Units& units,
                                             SceneFindings& findings) {
  VesselParameters& vessel = scene.vessel;
  if (vessel.lumenSurface.empty() || findings.unreliable.contains("vessel.lumenSurface") ||
      findings.unreliable.contains("vessel.lumenSurfaceUnit"))
    return {};
  const auto blameVessel = [&](std::string_view key, const std::string& message) {
    blame(VesselParameters::section, key, message, document, findings);
  };
  TriSurface lumen;
  try {
    DescribedLumen loaded = loadDescribedLumen(vessel, scene.outlets());
    lumen = std::move(loaded.surface);
    scene.lumenParts = std::move(loaded.parts);
    scene.remarks = std::move(loaded.remarks);
    if (const std::string problem = outletProblem(scene, loaded.outlets); !problem.empty())
      blame(FlowParameters::section, "outlets", problem, document, findings);
    requireLumenWithPlanarEnds(lumen);
  } catch (const std::exception& error) {
    blameVessel("lumenSurface", error.what());
    return {};
  }

  const LoadedExtent extent = extentOf(lumen);
  const double diameter = extent.diameter;
  if (!gives(document, "lumenDiameter")) vessel.lumenDiameter = diameter;
  if (implausible(diameter / vessel.lumenDiameter))
    blameVessel(
        "lumenSurfaceUnit",
        fmt::format("in {} the inlet of the surface is {:.4g} mm wide, but 'lumenDiameter' is {:.4g} mm",
                    vessel.lumenSurfaceUnit, units.fromSi(diameter, "mm"),
                    units.fromSi(vessel.lumenDiameter, "mm")));
  else if (std::string width = remarkOnWidth(scene, diameter);
           !width.empty() && !gives(document, "lumenDiameter"))
    scene.remarks.push_back(std::move(width));
  if (scene.hasTissue() && lumen.outletCount() > 1) return {};  // which is said elsewhere
  const bool straight = frameAlongZ(lumen).has_value();
  vessel.lumenSurfaceIsBent = !straight && scene.hasTissue();
  double length = distanceOfEnds(lumen);
  if (vessel.lumenSurfaceIsBent) try {
      length = axisBySections(lumen).length();
    } catch (const std::exception& error) {
      blameVessel("lumenSurface", error.what());
      return {};
    }
  // Along a bent lumen the distance between its ends says little
  if (gives(document, "length")) {
    if (scene.hasTissue() ? std::abs(length / vessel.length - 1.0) > sameLength
                          : straight && implausible(length / vessel.length))
      blameVessel("length",
                  fmt::format("the ends of 'lumenSurface' are {:.4g} mm apart, but 'length' is {:.4g} mm; "
                              "leave it out, or correct it or 'lumenSurfaceUnit'",
                              units.fromSi(length, "mm"), units.fromSi(vessel.length, "mm")));
    else if (straight || scene.hasTissue())
      vessel.length = length;  // to the last digit: the wall ends where the lumen does
  } else {
    vessel.length = length;
    if (const std::string problem = lengthProblem(
            vessel, units, fmt::format("its ends are {:.4g} mm apart", units.fromSi(length, "mm")));
        !problem.empty())
      blameVessel("lumenSurface", problem);
  }

  if (scene.hasTissue()) {
    checkWall(scene, blameVessel);
    return extent;
  }

  if (!straight && scene.flow && scene.flow->backend == flowBackendNames::analytic)
    blame(
        FlowParameters::section, "backend",
        fmt::format(
            "\"{}\" needs a lumen between two parallel planes, but of 'lumenSurface' {}; choose foam or lbm",
            scene.flow->backend, endsOf(lumen)),
        document, findings);
  if (!straight && scene.flow && scene.flow->straightEnds > 0)
    checkStraightEnds(lumen, scene.flow->straightEnds, document, findings);
  return extent;
}

void takeCentreline(Scene& scene, const SceneDocument& document, const Units& units,
                    SceneFindings& findings) {
  VesselParameters& vessel = scene.vessel;
  if (vessel.centreline.empty() || !findings.reliable("vessel.centreline") ||
      !findings.reliable("vessel.centrelineUnit"))
    return;
  const auto blameVessel = [&](std::string_view key, const std::string& message) {
    blame(VesselParameters::section, key, message, document, findings);
  };
  double length = 0;
  std::vector<double> radii;
  try {
    radii = readCentreline(vessel.centreline, metresPer(vessel.centrelineUnit)).radii;
    length = vesselAxis(vessel)->length();
  } catch (const std::exception& error) {
    return blameVessel("centreline", error.what());
  }
  if (gives(document, "length") && std::abs(length / vessel.length - 1.0) > sameLength)
    blameVessel("length",
                fmt::format("'centreline' is {:.4g} mm long, but 'length' is {:.4g} mm; leave it out, or "
                            "correct it or 'centrelineUnit'",
                            units.fromSi(length, "mm"), units.fromSi(vessel.length, "mm")));
  vessel.length = length;
  if (const std::string problem =
          lengthProblem(vessel, units, fmt::format("it is {:.4g} mm long", units.fromSi(length, "mm")));
      !problem.empty())
    return blameVessel("centreline", problem);
  if (!gives(document, "lumenDiameter")) {
    if (radii.empty()) return blameVessel("lumenDiameter", "is needed: 'centreline' has no radii");
    vessel.lumenDiameter = 2 * radii.front();
  }
  if (radii.empty()) return;
  if (const auto [least, most] = std::ranges::minmax(radii);
      implausible(2 * most / vessel.lumenDiameter) || implausible(2 * least / vessel.lumenDiameter))
    return blameVessel(
        "centreline",
        fmt::format("its radii are {:.4g} to {:.4g} mm, those of another vessel than 'lumenDiameter', "
                    "{:.4g} mm",
                    1e3 * least, 1e3 * most, 1e3 * vessel.lumenDiameter));
  if (scene.hasTissue()) checkWall(scene, blameVessel);
}

}  // namespace restenosis
