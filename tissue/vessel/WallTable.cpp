#include "tissue/vessel/WallTable.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "tissue/parameters/LengthUnits.h"
#include "tissue/vessel/Cylindrical.h"
#include "tissue/vessel/TableBounds.h"
#include "tissue/vessel/TableLayers.h"
#include "tissue/vessel/TablePlaces.h"

namespace restenosis {
namespace {

// All assumed: wide enough for every wall of a run, narrow enough to detect a mistaken unit.
constexpr double radiusRatio = 10;         // to the vessel's cell radius, or its inverse
constexpr double leastShareOfOuter = 0.5;  // reached by the outermost agent
constexpr double longestGap = 0.25;        // without agents, of the vessel's length
constexpr int octants = 8;                 // about the axis, none of them empty

bool hasLamina(const AgentStore& agents) {
  return std::ranges::any_of(agents.kind,
                             [](AgentKind kind) { return kind == AgentKind::iel || kind == AgentKind::eel; });
}

class WallTableCheck {
 public:
  WallTableCheck(const AgentTable& table, const VesselParameters& vessel,
                 std::optional<double> deploymentDepth)
      : table_(table), agents_(table.agents), vessel_(vessel), deploymentDepth_(deploymentDepth) {}

  void check() const {
    for (Index i = 0; i < agents_.size(); ++i) checkAgent(i);
    const auto isStrut = [](AgentKind kind) { return kind == AgentKind::strut; };
    if (std::ranges::all_of(agents_.kind, isStrut)) fail("has struts only; a wall has smc, iel or eel, too");
    checkOutermost();
    if (deploymentDepth_ || hasLamina(agents_)) {
      checkSectors();
      checkGaps();
    }
    requireInsideEel(table_, vessel_.cellRadius);
    requireDistinctPlaces(table_);
  }

 private:
  double reach(Index i) const { return radiusOf(agents_.position(i)) + agents_.radius[i]; }

  [[noreturn]] void fail(const std::string& message) const {
    throw TableError(fmt::format("{}: {}", table_.file.string(), message));
  }

  void checkAgent(Index i) const {
    const double radius = agents_.radius[i], z = agents_.z[i], distance = radiusOf(agents_.position(i));
    if (radius < vessel_.cellRadius / radiusRatio || radius > vessel_.cellRadius * radiusRatio) {
      table_.fail(i, fmt::format("a radius of {:.6g} um; allowed are {:.6g} to {:.6g} um, a tenth to ten "
                                 "times vessel.cellRadius. Lengths of a table are in um",
                                 radius / um, vessel_.cellRadius / radiusRatio / um,
                                 vessel_.cellRadius * radiusRatio / um));
    }
    if (z < -radius || z > vessel_.length + radius) {
      table_.fail(i,
                  fmt::format("the agent at z = {:.6g} um lies outside the vessel; allowed are 0 to {:.6g} "
                              "um (vessel.length), and a radius beyond",
                              z / um, vessel_.length / um));
    }
    const double farthest = tableBounds::farthest(vessel_);
    if (distance - radius > farthest) {
      table_.fail(
          i, fmt::format("the agent lies {:.6g} um from the axis (x = y = 0); allowed are at most {:.6g} um, "
                         "1.5 times the outer radius of the wall in [vessel], and a radius beyond",
                         distance / um, farthest / um));
    }
    if (deploymentDepth_ && agents_.kind[i] == AgentKind::strut) {
      table_.fail(i,
                  "a strut in the wall of a scene with [stent], which brings its own struts; remove the "
                  "line from the table, or [stent] from the scene");
    }
  }

  void checkOutermost() const {
    Index outermost = 0;
    for (Index i = 1; i < agents_.size(); ++i) {
      if (reach(i) > reach(outermost)) outermost = i;
    }
    const double least = leastShareOfOuter * tableBounds::outerRadius(vessel_);
    if (reach(outermost) >= least) return;
    table_.fail(outermost,
                fmt::format("the outermost agent reaches {:.6g} um from the axis, but the wall in [vessel] "
                            "has an outer radius of {:.6g} um (lumenDiameter / 2 + wallThickness); at least "
                            "half of it must be reached",
                            reach(outermost) / um, tableBounds::outerRadius(vessel_) / um));
  }

  void checkSectors() const {
    std::array<double, octants> outermost{};
    for (Index i = 0; i < agents_.size(); ++i) {
      const double share = toCylindrical(agents_.position(i)).angle / (2 * std::numbers::pi);  // -0.5 to 0.5
      auto& sector =
          outermost[std::min(static_cast<int>((share < 0 ? share + 1 : share) * octants), octants - 1)];
      sector = std::max(sector, reach(i));
    }
    for (int n = 0; n < octants; ++n) {
      const auto where = [n] {
        return fmt::format("between {} and {} degrees about the axis (x = y = 0)", 360 * n / octants,
                           360 * (n + 1) / octants);
      };
      if (outermost[n] == 0) {
        fail(fmt::format("no agent stands {}; a wall with laminae or a stent must surround the axis",
                         where()));
      }
      if (!deploymentDepth_) continue;
      const double deployed = vessel_.lumenDiameter / 2 + *deploymentDepth_;
      if (outermost[n] >= deployed) continue;
      fail(
          fmt::format("{} the wall reaches {:.6g} um, but the stent {:.6g} um (vessel.lumenDiameter / 2 + "
                      "stent.deploymentDepth), so that it would stand outside of the wall",
                      where(), outermost[n] / um, deployed / um));
    }
  }

  void checkGaps() const {
    std::vector<double> along = agents_.z;
    along.push_back(0);
    along.push_back(vessel_.length);
    std::ranges::sort(along);
    for (std::size_t n = 1; n < along.size(); ++n) {
      if (along[n] - along[n - 1] <= longestGap * vessel_.length) continue;
      fail(fmt::format(
          "no agent stands between z = {:.6g} and {:.6g} um; a wall with laminae or a stent must "
          "fill the vessel, of {:.6g} um (vessel.length), with no gap longer than a quarter of it",
          along[n - 1] / um, along[n] / um, vessel_.length / um));
    }
  }

  const AgentTable& table_;
  const AgentStore& agents_;
  const VesselParameters& vessel_;
  std::optional<double> deploymentDepth_;
};

}  // namespace

AgentStore readWallTable(const VesselParameters& vessel, std::optional<double> deploymentDepth) {
  AgentTable table = readAgentTable(vessel.agents, AgentKind::smc);
  WallTableCheck(table, vessel, deploymentDepth).check();
  return std::move(table.agents);
}

std::string remarkOnOpenEnds(const VesselParameters& vessel, const AgentStore& agents) {
  const double held = vessel.fixedEnds * vessel.cellRadius;
  if (held == 0 || !hasLamina(agents)) return {};
  const auto [first, last] = std::ranges::minmax(agents.z);
  if (first < held && last > vessel.length - held) return {};
  return fmt::format(
      "the wall of {} stands between z = {:.6g} and {:.6g} um of a vessel of {:.6g} um (vessel.length): "
      "agents are held within {:.6g} um of the vessel's ends (vessel.fixedEnds), and where none is, the "
      "wall can grow out of its cut face",
      vessel.agents, first / um, last / um, vessel.length / um, held / um);
}

}  // namespace restenosis
