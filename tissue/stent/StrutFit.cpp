#include "tissue/stent/StrutFit.h"

#include <fmt/format.h>

#include "tissue/parameters/LengthUnits.h"
#include "tissue/vessel/Cylindrical.h"
#include "tissue/vessel/TableBounds.h"
#include "tissue/vessel/TablePlaces.h"

namespace restenosis {
namespace {

/// Largest radius of a sphere and least distance of its centre from the axis: struts of designs have the same
/// limit of thickness, and no such sphere reaches over the axis. Assumed.
double halfLumenRadius(const VesselParameters& vessel) { return vessel.lumenDiameter / 4; }

void checkSphere(const AgentTable& table, Index i, const VesselParameters& vessel) {
  const AgentStore& spheres = table.agents;
  const double radius = spheres.radius[i], z = spheres.z[i], distance = radiusOf(spheres.position(i));
  if (spheres.kind[i] != AgentKind::strut) {
    table.fail(i, "the kind is not strut; a stent's table holds struts only, and needs no column 'kind'");
  }
  if (radius < tableBounds::leastStrutRadius || radius > halfLumenRadius(vessel)) {
    table.fail(i, fmt::format("a radius of {:.6g} um; allowed are {:.6g} to {:.6g} um, a quarter of "
                              "vessel.lumenDiameter{}",
                              radius / um, tableBounds::leastStrutRadius / um, halfLumenRadius(vessel) / um,
                              table.lines.empty() ? "" : ". Lengths of a table are in um"));
  }
  if (z < 0 || z > vessel.length) {
    table.fail(i,
               fmt::format("the sphere at z = {:.6g} um lies outside the vessel; allowed are 0 to {:.6g} um "
                           "(vessel.length)",
                           z / um, vessel.length / um));
  }
  const double farthest = tableBounds::farthest(vessel);
  if (distance - radius > farthest) {
    table.fail(
        i,
        fmt::format("the sphere lies {:.6g} um from the axis (x = y = 0); allowed are at most {:.6g} um, 1.5 "
                    "times the outer radius of the wall in [vessel], and a radius beyond",
                    distance / um, farthest / um));
  }
  if (distance < radius) {
    table.fail(i, fmt::format("the sphere lies over the axis (x = y = 0): its centre is {:.6g} um from it; "
                              "allowed is at least its radius of {:.6g} um",
                              distance / um, radius / um));
  }
}

}  // namespace

double outwardsToLumen(const AgentTable& table, const VesselParameters& vessel) {
  const AgentStore& spheres = table.agents;
  const auto reach = [&spheres](Index i) { return radiusOf(spheres.position(i)) + spheres.radius[i]; };
  Index outermost = 0;
  for (Index i = 0; i < spheres.size(); ++i) {
    checkSphere(table, i, vessel);
    if (reach(i) > reach(outermost)) outermost = i;
  }
  if (!table.lines.empty()) requireDistinctPlaces(table);  // spheres of a surface are not the user's
  const double outwards = vessel.lumenDiameter / 2 - reach(outermost);
  for (Index i = 0; i < spheres.size(); ++i) {
    const double moved = radiusOf(spheres.position(i)) + outwards;
    // The thickest sphere that is allowed lies on this bound when it touches the lumen.
    if (moved >= halfLumenRadius(vessel) * (1 - 1e-9)) continue;
    table.fail(i,
               fmt::format("the sphere lies {:.6g} um further in than the outermost one ({}) reaches, "
                           "which is put at the lumen's surface; allowed are at most {:.6g} um, a quarter of "
                           "vessel.lumenDiameter",
                           (reach(outermost) - radiusOf(spheres.position(i))) / um, table.placeOf(outermost),
                           halfLumenRadius(vessel) / um));
  }
  return outwards;
}

}  // namespace restenosis
