#include "LumenStl.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <unordered_map>

namespace restenosis {
namespace {

constexpr double millimetre = 1e-3;

std::uint64_t key(std::uint32_t from, std::uint32_t to) { return (std::uint64_t{from} << 32) | to; }

void facet(fmt::memory_buffer& out, const Vec3& a, const Vec3& b, const Vec3& c) {
  auto it = std::back_inserter(out);
  fmt::format_to(it, "facet normal 0 0 0\nouter loop\n");
  for (const Vec3* v : {&a, &b, &c})
    fmt::format_to(it, "vertex {:.9g} {:.9g} {:.9g}\n", v->x() / millimetre, v->y() / millimetre,
                   v->z() / millimetre);
  fmt::format_to(it, "endloop\nendfacet\n");
}

}  // namespace

void writeLumenStl(const TriSurface& lumen, double overshoot, const std::filesystem::path& file) {
  // Directed edges of the ends: a wall edge that runs against one of them is a rim
  std::unordered_map<std::uint64_t, Vec3> rim;
  for (std::size_t i = 0; i < lumen.triangles.size(); ++i) {
    if (lumen.region[i] != SurfaceRegion::inlet && lumen.region[i] != SurfaceRegion::outlet) continue;
    const Vec3 beyond = Vec3::UnitZ() * (lumen.region[i] == SurfaceRegion::inlet ? -overshoot : overshoot);
    const auto& t = lumen.triangles[i];
    for (int k = 0; k < 3; ++k) rim.emplace(key(t[k], t[(k + 1) % 3]), beyond);
  }

  fmt::memory_buffer out;
  for (const auto& [region, name] :
       {std::pair{SurfaceRegion::wall, "wall"}, {SurfaceRegion::strut, "strut"}}) {
    bool begun = false;
    for (std::size_t i = 0; i < lumen.triangles.size(); ++i) {
      if (lumen.region[i] != region) continue;
      if (!begun) fmt::format_to(std::back_inserter(out), "solid {}\n", name);
      begun = true;
      const auto& t = lumen.triangles[i];
      const auto vertex = [&](int k) -> const Vec3& { return lumen.vertices[t[k % 3]]; };
      facet(out, vertex(0), vertex(1), vertex(2));
      for (int k = 0; k < 3; ++k) {
        const auto end = rim.find(key(t[(k + 1) % 3], t[k]));
        if (end == rim.end()) continue;
        const Vec3 a = vertex(k), b = vertex(k + 1), aBeyond = a + end->second, bBeyond = b + end->second;
        facet(out, b, a, aBeyond);
        facet(out, b, aBeyond, bBeyond);
      }
    }
    if (begun) fmt::format_to(std::back_inserter(out), "endsolid {}\n", name);
  }
  std::ofstream stream(file, std::ios::binary);
  stream.write(out.data(), static_cast<std::streamsize>(out.size()));
  stream.close();
  if (!stream) throw std::runtime_error(fmt::format("cannot write {}", file.string()));
}

}  // namespace restenosis
