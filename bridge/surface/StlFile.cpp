#include "bridge/surface/StlFile.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCleanPolyData.h>
#include <vtkDataArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <string>

#include "bridge/surface/StlTriangles.h"
#include "bridge/surface/SurfaceFile.h"
#include "bridge/system/AtomicFile.h"

namespace restenosis {
namespace {

/// Distance below which vertices are one, over the diagonal of the surface's box.
constexpr double mergedWithin = 1e-6;
/// Distance from the middle of a surface, over that of half of its vertices, beyond which a vertex is astray
/// (assumed).
constexpr double astray = 1e3;
/// What single precision rounds by, relative, and most of that over a surface's width (assumed).
constexpr double singleRounding = 0x1p-24, mostRounding = 1e-3;

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// A vertex far from all others would make them one.
void refuseStrayVertex(const FileTriangles& triangles, const std::filesystem::path& file) {
  std::array<std::vector<double>, 3> coordinates;
  for (const auto& corners : triangles.corners)
    for (std::size_t k = 0; k < corners.size(); ++k) coordinates[k % 3].push_back(corners[k]);
  const Vec3 middle(medianOf(coordinates[0]), medianOf(coordinates[1]), medianOf(coordinates[2]));
  std::vector<double> distances;
  for (std::size_t v = 0; v < coordinates[0].size(); ++v)
    distances.push_back((Vec3(coordinates[0][v], coordinates[1][v], coordinates[2][v]) - middle).norm());
  const double usual = medianOf(distances);
  const auto stray = std::max_element(distances.begin(), distances.end());
  if (usual == 0.0 || *stray <= astray * usual) return;
  const auto v = static_cast<std::size_t>(stray - distances.begin());
  throw std::runtime_error(fmt::format(
      "{} has a vertex far from all others: ({:g}, {:g}, {:g}) in triangle {} of {}", file.string(),
      coordinates[0][v], coordinates[1][v], coordinates[2][v], v / 3 + 1, triangles.corners.size()));
}

/// So far from the origin, single precision does not tell places of a surface apart. Its width is that of a
/// tube of its area, as long as its box; very far away no area is left.
void refuseDistant(const FileTriangles& triangles, const std::filesystem::path& file) {
  Eigen::AlignedBox3d box;
  double area = 0.0, largest = 0.0;
  for (const auto& corners : triangles.corners) {
    const Eigen::Map<const Eigen::Matrix3d> points(corners.data());
    for (int k = 0; k < 3; ++k) box.extend(points.col(k));
    area += 0.5 * (points.col(1) - points.col(0)).cross(points.col(2) - points.col(0)).norm();
    largest = std::max(largest, points.cwiseAbs().maxCoeff());
  }
  const double reach = box.diagonal().norm();
  const double width = area > 0.0 ? area / (std::numbers::pi * reach) : reach;
  if (singleRounding * largest <= mostRounding * width) return;
  throw std::runtime_error(fmt::format(
      "{} lies too far from the origin: single precision, in which binary STL files and results are kept, "
      "rounds its coordinates, up to {:.4g}, by {:.2g}: more than {:g} of its width of about {:.3g}. Move it "
      "to the origin",
      file.string(), largest, singleRounding * largest, mostRounding, width));
}

/// The triangles with their solids as cell data; every vertex appears once a triangle.
vtkNew<vtkPolyData> polygonsOf(const FileTriangles& triangles) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkIdTypeArray> solids;
  for (std::size_t t = 0; t < triangles.corners.size(); ++t) {
    std::array<vtkIdType, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = points->InsertNextPoint(triangles.corners[t].data() + 3 * k);
    polygons->InsertNextCell(3, corners.data());
    solids->InsertNextValue(triangles.solid[t]);
  }
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(polygons);
  mesh->GetCellData()->SetScalars(solids);
  return mesh;
}

TriSurface surfaceOf(vtkPolyData& mesh, double metresPerUnit) {
  TriSurface s;
  for (vtkIdType v = 0; v < mesh.GetNumberOfPoints(); ++v) {
    double p[3];
    mesh.GetPoint(v, p);
    s.vertices.push_back(metresPerUnit * Vec3(p[0], p[1], p[2]));
  }
  for (vtkIdType c = 0; c < mesh.GetPolys()->GetNumberOfCells(); ++c) {
    vtkIdType count;
    const vtkIdType* ids;
    mesh.GetPolys()->GetCellAtId(c, count, ids);
    s.triangles.push_back({static_cast<std::uint32_t>(ids[0]), static_cast<std::uint32_t>(ids[1]),
                           static_cast<std::uint32_t>(ids[2])});
  }
  s.region.assign(s.triangles.size(), SurfaceRegion::wall);
  return s;
}

/// Makes vertices within a distance, over the diagonal of the surface's box, one.
SurfaceSolids weld(const FileTriangles& triangles, double within, double metresPerUnit) {
  const vtkNew<vtkPolyData> soup = polygonsOf(triangles);
  vtkNew<vtkCleanPolyData> welded;
  welded->SetInputData(soup);
  welded->SetTolerance(within);
  welded->Update();
  vtkPolyData& mesh = *welded->GetOutput();
  SurfaceSolids result;
  result.surface = surfaceOf(mesh, metresPerUnit);
  result.names = triangles.names;
  // Cells that lost their area come before the triangles
  const vtkIdType before = mesh.GetNumberOfCells() - mesh.GetNumberOfPolys();
  vtkDataArray& solids = *mesh.GetCellData()->GetScalars();
  for (vtkIdType c = 0; c < mesh.GetNumberOfPolys(); ++c)
    result.solid.push_back(static_cast<std::uint32_t>(solids.GetTuple1(before + c)));
  return result;
}

}  // namespace

std::string_view regionName(SurfaceRegion region) {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all{"wall", "strut", "inlet", "outlet"};
    for (std::size_t n = 2; n <= mostOutlets; ++n) all.push_back(fmt::format("outlet{}", n));
    return all;
  }();
  return names[static_cast<std::size_t>(region)];
}

std::vector<SurfaceRegion> allRegions(const TriSurface& surface) {
  std::vector<SurfaceRegion> regions{SurfaceRegion::wall, SurfaceRegion::strut, SurfaceRegion::inlet};
  for (std::size_t n = 0; n < surface.outletCount(); ++n) regions.push_back(outletRegion(n));
  return regions;
}

void writeStl(const std::filesystem::path& file, const TriSurface& surface, double metresPerUnit,
              std::span<const SurfaceRegion> regions) {
  std::string content("restenosisFoam lumen surface");
  content.resize(84, ' ');
  std::uint32_t count = 0;
  auto append = [&](const Vec3& v) {
    const std::array<float, 3> f{static_cast<float>(v.x()), static_cast<float>(v.y()),
                                 static_cast<float>(v.z())};
    content.append(reinterpret_cast<const char*>(f.data()), sizeof(f));
  };
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (!regions.empty() && std::find(regions.begin(), regions.end(), surface.region[t]) == regions.end())
      continue;
    append(surface.areaVector(t).normalized());
    for (const auto v : surface.triangles[t]) append(surface.vertices[v] / metresPerUnit);
    content.append(2, '\0');
    ++count;
  }
  std::memcpy(content.data() + 80, &count, sizeof(count));
  atomicWrite(file, content);
}

void writeNamedStl(const std::filesystem::path& file, const TriSurface& surface, double metresPerUnit) {
  std::string content;
  auto out = std::back_inserter(content);
  for (const SurfaceRegion region : allRegions(surface)) {
    if (std::find(surface.region.begin(), surface.region.end(), region) == surface.region.end()) continue;
    fmt::format_to(out, "solid {}\n", regionName(region));
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      if (surface.region[t] != region) continue;
      const Vec3 n = surface.areaVector(t).normalized();
      fmt::format_to(out, "facet normal {:.6g} {:.6g} {:.6g}\nouter loop\n", n.x(), n.y(), n.z());
      for (const auto v : surface.triangles[t]) {
        const Vec3 p = surface.vertices[v] / metresPerUnit;
        fmt::format_to(out, "vertex {:.9g} {:.9g} {:.9g}\n", p.x(), p.y(), p.z());
      }
      content += "endloop\nendfacet\n";
    }
    fmt::format_to(out, "endsolid {}\n", regionName(region));
  }
  atomicWrite(file, content);
}

TriSurface readStl(const std::filesystem::path& file, double metresPerUnit) {
  return weld(readStlTriangles(file), 0.0, metresPerUnit).surface;
}

SurfaceSolids readSurfaceSolids(const std::filesystem::path& file, double metresPerUnit) {
  const FileTriangles triangles = readSurfaceTriangles(file);
  refuseStrayVertex(triangles, file);
  refuseDistant(triangles, file);
  SurfaceSolids result = weld(triangles, mergedWithin, metresPerUnit);
  if (result.surface.triangles.empty())
    throw std::runtime_error(fmt::format("{} holds no triangles that have an area", file.string()));
  return result;
}

void markEnds(TriSurface& surface, double length, double tolerance) {
  for (const auto& [z, region] : {std::pair{0.0, SurfaceRegion::inlet}, {length, SurfaceRegion::outlet}}) {
    auto near = [&, z = z](std::uint32_t v) { return std::abs(surface.vertices[v].z() - z) <= tolerance; };
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      const auto& c = surface.triangles[t];
      if (!near(c[0]) || !near(c[1]) || !near(c[2])) continue;
      surface.region[t] = region;
      for (const auto v : c) surface.vertices[v].z() = z;
    }
  }
}

}  // namespace restenosis
