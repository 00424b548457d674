#include "bridge/surface/Isosurface.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bridge/surface/SurfaceRelaxation.h"

namespace restenosis {
namespace {

/// Far outside [m]: next to it, the isosurface comes to lie on the node inside.
constexpr float farOutside = -1.0F;

/// Nodes from the first to the last, along an axis.
struct Extent {
  int first = std::numeric_limits<int>::max(), last = std::numeric_limits<int>::min();
  void join(int node) { first = std::min(first, node), last = std::max(last, node); }
  void join(const Extent& other) { join(other.first), join(other.last); }
  bool empty() const { return last < first; }
  int count() const { return last - first + 1; }
};

/// The nodes in x and y beside which the field is above 0 in some plane: a lumen is narrower than its grid.
std::array<Extent, 2> extentInside(const BandField& field) {
  const LumenGrid& g = field.grid();
  std::vector<std::array<Extent, 2>> ofPlanes(g.nz);
#pragma omp parallel
  {
    std::vector<float> row(g.nx);
#pragma omp for schedule(static)
    for (int k = 0; k < g.nz; ++k) {
      std::array<Extent, 2> open;
      for (int j = 0; j < g.ny; ++j) {
        field.copyRow(j, k, row.data());
        for (int i = 0; i < g.nx; ++i)
          if (row[i] > 0) open[0].join(i), open[1].join(j);
      }
      ofPlanes[k] = open;
    }
  }
  std::array<Extent, 2> all;
  for (const auto& open : ofPlanes)
    for (int axis = 0; axis < 2; ++axis)
      if (!open[axis].empty()) all[axis].join(open[axis]);
  if (all[0].empty()) return all;
  for (int axis = 0; axis < 2; ++axis) {
    const int nodes = axis == 0 ? g.nx : g.ny;
    all[axis] = {std::max(all[axis].first - 1, 0), std::min(all[axis].last + 1, nodes - 1)};
  }
  return all;
}

/// The field around its inside as an image in node numbers, with one more plane before and behind. The
/// outermost nodes are far outside, which closes the surface; at the ends the caps come to lie on the planes
/// of nodes z = 0 and z = length.
vtkNew<vtkImageData> paddedImage(const BandField& field, const std::array<Extent, 2>& extent,
                                 float clearance) {
  const LumenGrid& g = field.grid();
  const Extent &x = extent[0], &y = extent[1];  // clang captures no structured binding in a parallel region
  vtkNew<vtkImageData> image;
  image->SetExtent(x.first, x.last, y.first, y.last, 0, g.nz + 1);
  const std::size_t plane = static_cast<std::size_t>(x.count()) * y.count();
  vtkNew<vtkFloatArray> array;
  array->SetNumberOfTuples(static_cast<vtkIdType>(plane * (g.nz + 2)));
  float* values = array->GetPointer(0);
  std::fill_n(values, plane, farOutside);
  std::fill_n(values + plane * (g.nz + 1), plane, farOutside);
#pragma omp parallel
  {
    std::vector<float> row(g.nx);
#pragma omp for schedule(static)
    for (int k = 0; k < g.nz; ++k)
      for (int j = y.first; j <= y.last; ++j) {
        field.copyRow(j, k, row.data());
        float* to = values + plane * (k + 1) + static_cast<std::size_t>(j - y.first) * x.count();
        for (int i = x.first; i <= x.last; ++i) {
          float v = row[i];
          if (std::abs(v) < clearance) v = v > 0 ? clearance : -clearance;
          if (i == 0 || j == 0 || i == g.nx - 1 || j == g.ny - 1) v = std::min(v, -clearance);
          *to++ = v;
        }
      }
  }
  image->GetPointData()->SetScalars(array);
  return image;
}

/// Metres from node numbers; what lies within a ten-thousandth of a spacing of an end lies on it.
Vec3 toMetres(const LumenGrid& g, const double (&p)[3]) {
  const double k = p[2] - 1.0, tolerance = 1e-4;
  const double z = k < tolerance ? 0.0 : k > g.nz - 1 - tolerance ? g.length : k * g.spacingZ;
  return {g.x(0) + p[0] * g.spacing, g.y(0) + p[1] * g.spacing, z};
}

}  // namespace

TriSurface isosurface(const BandField& field, const IsosurfaceSettings& settings) {
  const LumenGrid& g = field.grid();
  const std::array<Extent, 2> extent = extentInside(field);
  if (extent[0].empty()) return {};
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(paddedImage(field, extent, static_cast<float>(settings.nodeClearance * g.spacing)));
  contour->SetValue(0, 0.0);
  contour->ComputeNormalsOff();
  contour->ComputeGradientsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  vtkPolyData* mesh = contour->GetOutput();

  TriSurface surface;
  surface.vertices.resize(mesh->GetNumberOfPoints());
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    double p[3];
    mesh->GetPoint(static_cast<vtkIdType>(v), p);
    surface.vertices[v] = toMetres(g, p);
  }
  surface.triangles.reserve(mesh->GetNumberOfPolys());
  vtkCellArray* cells = mesh->GetPolys();
  for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c) {
    vtkIdType count;
    const vtkIdType* ids;
    cells->GetCellAtId(c, count, ids);
    surface.triangles.push_back({static_cast<std::uint32_t>(ids[0]), static_cast<std::uint32_t>(ids[1]),
                                 static_cast<std::uint32_t>(ids[2])});
  }

  double volume = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    volume += surface.areaVector(t).dot(surface.centre(t)) / 3;
  if (volume < 0)
    for (auto& t : surface.triangles) std::swap(t[1], t[2]);

  surface.region.reserve(surface.triangles.size());
  for (const auto& t : surface.triangles) {
    auto allAt = [&](double z) {
      return surface.vertices[t[0]].z() == z && surface.vertices[t[1]].z() == z &&
             surface.vertices[t[2]].z() == z;
    };
    surface.region.push_back(allAt(0)          ? SurfaceRegion::inlet
                             : allAt(g.length) ? SurfaceRegion::outlet
                                               : SurfaceRegion::wall);
  }
  relaxSurface(surface, field, settings.relaxations);
  return surface;
}

}  // namespace restenosis
