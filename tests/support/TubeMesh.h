#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bridge/flow/foam/PolyMesh.h"

namespace restenosis::support {

/// A mesh of a straight tube along z [m]: wedges around the axis, in rings and layers. Its wall is that
/// of `tube` with as many sides as it has wedges.
inline PolyMesh tubeMesh(double radius, double length, int sides, int rings, int layers) {
  PolyMesh mesh;
  const double step = 2.0 * std::numbers::pi / sides, equalArea = std::sqrt(step / std::sin(step));
  // The axis first, then ring by ring
  const auto point = [&](int layer, int ring, int side) {
    const int ofLayer = ring == 0 ? 0 : 1 + (ring - 1) * sides + side % sides;
    return static_cast<std::int32_t>(layer * (1 + rings * sides) + ofLayer);
  };
  for (int l = 0; l <= layers; ++l) {
    const double z = length * l / layers;
    mesh.points.emplace_back(0, 0, z);
    for (int r = 1; r <= rings; ++r)
      for (int s = 0; s < sides; ++s) {
        const double at = equalArea * radius * r / rings;
        mesh.points.emplace_back(at * std::cos(s * step), at * std::sin(s * step), z);
      }
  }
  const auto cell = [&](int l, int r, int s) {
    return static_cast<std::int32_t>((l * rings + r) * sides + s % sides);
  };
  mesh.faceStart = {0};
  const auto face = [&](std::initializer_list<std::int32_t> corners, std::int32_t owner, std::int32_t other) {
    for (const auto c : corners)  // a face at the axis has the axis for a corner once
      if (std::find(mesh.faceCorners.begin() + mesh.faceStart.back(), mesh.faceCorners.end(), c) ==
          mesh.faceCorners.end())
        mesh.faceCorners.push_back(c);
    mesh.faceStart.push_back(static_cast<std::int32_t>(mesh.faceCorners.size()));
    mesh.owner.push_back(owner);
    if (other >= 0) mesh.neighbour.push_back(other);
  };
  const auto across = [&](int l, int r, int s, std::int32_t owner, std::int32_t other) {
    face({point(l, r, s), point(l, r + 1, s), point(l, r + 1, s + 1), point(l, r, s + 1)}, owner, other);
  };
  const auto around = [&](int l, int r, int s, std::int32_t owner, std::int32_t other) {
    face({point(l, r, s), point(l, r, s + 1), point(l + 1, r, s + 1), point(l + 1, r, s)}, owner, other);
  };
  for (int l = 0; l < layers; ++l)
    for (int r = 0; r < rings; ++r)
      for (int s = 0; s < sides; ++s) {
        if (l + 1 < layers) across(l + 1, r, s, cell(l, r, s), cell(l + 1, r, s));
        if (r + 1 < rings) around(l, r + 1, s, cell(l, r, s), cell(l, r + 1, s));
        face({point(l, r, s + 1), point(l, r + 1, s + 1), point(l + 1, r + 1, s + 1), point(l + 1, r, s + 1)},
             cell(l, r, s), cell(l, r, s + 1));
      }
  const auto patch = [&](const char* name, auto add) {
    const std::size_t start = mesh.faces();
    add();
    mesh.patches.push_back({name, start, mesh.faces() - start});
  };
  for (const bool outlet : {false, true})
    patch(outlet ? "outlet" : "inlet", [&] {
      const int l = outlet ? layers : 0;
      for (int r = 0; r < rings; ++r)
        for (int s = 0; s < sides; ++s) across(l, r, s, cell(outlet ? layers - 1 : 0, r, s), -1);
    });
  patch("wall", [&] {
    for (int l = 0; l < layers; ++l)
      for (int s = 0; s < sides; ++s) around(l, rings, s, cell(l, rings - 1, s), -1);
  });
  return mesh;
}

}  // namespace restenosis::support
