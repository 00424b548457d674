#include "bridge/surface/LumenRims.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>

#include "bridge/surface/LumenRefusal.h"
#include "bridge/surface/SurfaceEnds.h"

namespace restenosis {
namespace {

/// Says where holes are, how wide, and which of them are in a cap.
[[noreturn]] void refuseHoles(TriSurface s, const std::vector<Rim>& rims, const std::vector<bool>& isHole) {
  std::vector<LumenCap> closed;
  for (const Rim& rim : rims) closed.push_back(closeByFan(s, rim, fitPlane(s, rim).centre));
  turnOutwards(s);
  const auto caps = planarCaps(s, surfaceEdges(s));
  const auto count = static_cast<std::size_t>(std::count(isHole.begin(), isHole.end(), true));
  std::string list;
  std::size_t listed = 0;
  bool anyInCap = false;
  for (std::size_t n = 0; n < rims.size() && listed < placesShown; ++n) {
    if (!isHole[n]) continue;
    list += fmt::format("{} {} edges, {:.3g} mm wide, around {}", listed++ == 0 ? "" : ", and one of",
                        rims[n].size(), 1e3 * closed[n].diameter(s), shownPlace(fitPlane(s, rims[n]).centre));
    const auto cap = std::find_if(caps.begin(), caps.end(), [&](const auto& triangles) {
      return std::find(triangles.begin(), triangles.end(), closed[n].triangles.front()) != triangles.end();
    });
    if (cap == caps.end()) continue;
    anyInCap = true;
    list += fmt::format(" in an end cap of {:.3g} mm", 1e3 * LumenCap{*cap, std::nullopt}.diameter(s));
  }
  refuseLumen(fmt::format(
      "it has {}{}{}. An open rim is an end only where the surface does not go on in its plane: close {}{}",
      count == 1 ? "a hole of" : fmt::format("{} holes: one of", count), list,
      count > placesShown ? ", and more" : "", count == 1 ? "the hole" : "the holes",
      anyInCap ? ", or remove the whole cap" : ""));
}

}  // namespace

LumenCap closeByFan(TriSurface& s, const Rim& rim, const Vec3& centre) {
  LumenCap end;
  const auto middle = static_cast<std::uint32_t>(s.vertices.size());
  s.vertices.push_back(centre);
  for (std::size_t k = 0; k < rim.size(); ++k) {
    end.triangles.push_back(static_cast<std::uint32_t>(s.triangles.size()));
    s.triangles.push_back({rim[(k + 1) % rim.size()], rim[k], middle});
    s.region.push_back(SurfaceRegion::wall);
  }
  return end;
}

std::vector<Rim> endRims(const TriSurface& s, const SurfaceEdges& edges) {
  std::vector<Rim> rims;
  try {
    rims = openRims(edges.open);
  } catch (const std::runtime_error& error) {
    refuseLumen(error.what());
  }
  const auto isHole = holesAmong(s, edges, rims);
  if (std::find(isHole.begin(), isHole.end(), true) != isHole.end()) refuseHoles(s, rims, isHole);
  std::vector<std::uint32_t> all;
  for (const Rim& rim : rims) all.insert(all.end(), rim.begin(), rim.end());
  std::sort(all.begin(), all.end());
  if (const auto twice = std::adjacent_find(all.begin(), all.end()); twice != all.end())
    refuseLumen(fmt::format("its open rims touch each other at {}", shownPlace(s.vertices[*twice])));
  return rims;
}

LumenCap closeRim(TriSurface& s, const Rim& rim) {
  const FittedPlane plane = fitPlane(s, rim);
  double length = 0.0;
  for (std::size_t k = 0; k < rim.size(); ++k)
    length += (s.vertices[rim[k]] - s.vertices[rim[(k + 1) % rim.size()]]).norm();
  if (plane.departure > lumenEndPlanarity * length / std::numbers::pi)
    refuseLumen(
        fmt::format("an open rim of {} edges around {} is not planar (off by {:.3g} mm): it is a hole, or "
                    "an end that must be cut straight",
                    rim.size(), shownPlace(plane.centre), 1e3 * plane.departure));
  for (const auto v : rim) s.vertices[v] -= plane.normal.dot(s.vertices[v] - plane.centre) * plane.normal;
  return closeByFan(s, rim, plane.centre);
}

void turnOutwards(TriSurface& s) {
  if (enclosedVolume(s) < 0.0)
    for (auto& t : s.triangles) std::swap(t[1], t[2]);
}

}  // namespace restenosis
