#include "bridge/flow/foam/LumenStl.h"

#include <fmt/format.h>

#include <iterator>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "bridge/surface/StlFile.h"
#include "bridge/system/AtomicFile.h"

namespace restenosis {
namespace {

std::uint64_t key(std::uint32_t from, std::uint32_t to) { return (std::uint64_t{from} << 32) | to; }

void facet(fmt::memory_buffer& out, const Vec3& a, const Vec3& b, const Vec3& c) {
  auto it = std::back_inserter(out);
  fmt::format_to(it, "facet normal 0 0 0\nouter loop\n");
  for (const Vec3* v : {&a, &b, &c})
    fmt::format_to(it, "vertex {:.9g} {:.9g} {:.9g}\n", v->x(), v->y(), v->z());
  fmt::format_to(it, "endloop\nendfacet\n");
}

bool isCut(SurfaceRegion region, LumenEnds ends) {
  if (ends == LumenEnds::inletCut) return region == SurfaceRegion::inlet;
  return ends == LumenEnds::cut && isEnd(region);
}

bool isCap(SurfaceRegion region, LumenEnds ends) { return isEnd(region) && !isCut(region, ends); }

void save(const fmt::memory_buffer& text, const std::filesystem::path& file) {
  atomicWrite(file, std::string_view(text.data(), text.size()));
}

}  // namespace

void writeRims(const TriSurface& lumen, LumenEnds ends, const std::filesystem::path& file) {
  const auto ofEnd = [&](std::size_t t) { return isCap(lumen.region[t], ends); };
  std::unordered_set<std::uint64_t> sides;
  for (std::size_t i = 0; i < lumen.triangles.size(); ++i) {
    const auto& t = lumen.triangles[i];
    for (int k = 0; k < 3 && !ofEnd(i); ++k) sides.insert(key(t[k], t[(k + 1) % 3]));
  }
  fmt::memory_buffer out;
  auto it = std::back_inserter(out);
  for (const Vec3& v : lumen.vertices) fmt::format_to(it, "v {:.9g} {:.9g} {:.9g}\n", v.x(), v.y(), v.z());
  for (std::size_t i = 0; i < lumen.triangles.size(); ++i) {
    const auto& t = lumen.triangles[i];
    for (int k = 0; k < 3 && ofEnd(i); ++k)
      if (sides.contains(key(t[(k + 1) % 3], t[k])))
        fmt::format_to(it, "l {} {}\n", t[k] + 1, t[(k + 1) % 3] + 1);
  }
  save(out, file);
}

void writeLumenStl(const TriSurface& lumen, LumenEnds ends, double overshoot,
                   const std::filesystem::path& file) {
  const auto beyond = [&](SurfaceRegion end) -> Vec3 {
    return Vec3::UnitZ() * (end == SurfaceRegion::inlet ? -overshoot : overshoot);
  };
  // Directed edges of the ends that are cut: a wall edge that runs against one of them is a rim
  std::unordered_map<std::uint64_t, Vec3> rim;
  for (std::size_t i = 0; i < lumen.triangles.size(); ++i) {
    if (!isCut(lumen.region[i], ends)) continue;
    const auto& t = lumen.triangles[i];
    for (int k = 0; k < 3; ++k) rim.emplace(key(t[k], t[(k + 1) % 3]), beyond(lumen.region[i]));
  }

  fmt::memory_buffer out;
  for (const SurfaceRegion region : allRegions(lumen)) {
    if (isCut(region, ends)) continue;
    bool begun = false;
    for (std::size_t i = 0; i < lumen.triangles.size(); ++i) {
      const auto& t = lumen.triangles[i];
      const auto vertex = [&](int k) -> const Vec3& { return lumen.vertices[t[k % 3]]; };
      // The lid behind an inlet that alone is cut belongs to the wall
      const bool lid = region == SurfaceRegion::wall && ends == LumenEnds::inletCut &&
                       lumen.region[i] == SurfaceRegion::inlet;
      if (lumen.region[i] != region && !lid) continue;
      if (!begun) fmt::format_to(std::back_inserter(out), "solid {}\n", regionName(region));
      begun = true;
      if (lid) {
        const Vec3 shift = beyond(SurfaceRegion::inlet);
        facet(out, vertex(0) + shift, vertex(1) + shift, vertex(2) + shift);
        continue;
      }
      facet(out, vertex(0), vertex(1), vertex(2));
      for (int k = 0; k < 3; ++k) {
        const auto end = rim.find(key(t[(k + 1) % 3], t[k]));
        if (end == rim.end()) continue;
        const Vec3 a = vertex(k), b = vertex(k + 1), aBeyond = a + end->second, bBeyond = b + end->second;
        facet(out, b, a, aBeyond);
        facet(out, b, aBeyond, bBeyond);
      }
    }
    if (begun) fmt::format_to(std::back_inserter(out), "endsolid {}\n", regionName(region));
  }
  save(out, file);
}

}  // namespace restenosis
