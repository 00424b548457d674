#include "bridge/output/LumenWriter.h"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <limits>

#include "bridge/flow/RegionalFaces.h"
#include "bridge/output/BentPolyData.h"
#include "bridge/output/PolyDataFile.h"
#include "bridge/output/SurfacePolyData.h"
#include "bridge/surface/StlFile.h"

namespace restenosis {

namespace {

constexpr double notKnown = std::numeric_limits<double>::quiet_NaN();

std::vector<std::size_t> sideTriangles(const TriSurface& lumen) {
  std::vector<std::size_t> side;
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t)
    if (lumen.region[t] == SurfaceRegion::wall || lumen.region[t] == SurfaceRegion::strut) side.push_back(t);
  return side;
}

SurfaceRegion otherThan(SurfaceRegion region) {
  return region == SurfaceRegion::strut ? SurfaceRegion::wall : SurfaceRegion::strut;
}

/// The flow's face nearest to each triangle; null where there is none.
std::vector<const WallFace*> nearestFaces(const TriSurface& lumen, const std::vector<std::size_t>& triangles,
                                          const FlowSolution* flow) {
  std::vector<const WallFace*> found(triangles.size(), nullptr);
  if (flow == nullptr || flow->wall.empty()) return found;
  const RegionalFaces faces(flow->wall);
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const SurfaceRegion region = lumen.region[triangles[k]];
    const Vec3 centre = lumen.centre(triangles[k]);
    auto nearest = faces.nearest(centre, region, 1);
    if (nearest.empty()) nearest = faces.nearest(centre, otherThan(region), 1);
    if (!nearest.empty()) found[k] = nearest.front().face;
  }
  return found;
}

/// The stress over a beat, by triangle.
void addBeatArrays(vtkCellData& cells, const std::vector<const WallFace*>& faces) {
  const auto add = [&](const char* name, auto&& value) {
    addArray<vtkFloatArray>(&cells, name, faces.size(), 1, [&](std::size_t k, int) {
      return faces[k] != nullptr ? value(faces[k]->beat) : notKnown;
    });
  };
  add("TAWSS", [](const BeatStress& beat) { return beat.average; });
  add("OSI", [](const BeatStress& beat) { return beat.oscillatoryIndex(); });
  add("RRT", [](const BeatStress& beat) { return beat.residenceTime(); });
  add("transWSS", [](const BeatStress& beat) { return beat.transverse; });
}

/// Notes the centre of an end, if there is one; of a bent vessel where it is in the bend.
void addCentre(vtkPolyData& data, const std::string& name, const TriSurface& lumen, SurfaceRegion end,
               const Centreline* axis) {
  double area = 0.0;
  Vec3 centre = Vec3::Zero();
  for (std::size_t t = 0; t < lumen.triangles.size(); ++t) {
    if (lumen.region[t] != end) continue;
    const double weight = lumen.areaVector(t).norm();
    area += weight;
    centre += weight * lumen.centre(t);
  }
  if (!(area > 0.0)) return;
  centre /= area;
  if (axis != nullptr) centre = axis->toBent(centre);
  vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(3);
  array->InsertNextTuple(centre.data());
  data.GetFieldData()->AddArray(array);
}

}  // namespace

void writeLumen(const std::filesystem::path& file, const TriSurface& lumen, const FlowSolution* flow,
                double time, const RadialMap* postDeployment, const Centreline* axis) {
  const auto triangles = sideTriangles(lumen);
  const auto faces = nearestFaces(lumen, triangles, flow);
  std::vector<Vec3> tractions(triangles.size(), Vec3::Constant(notKnown));
  for (std::size_t k = 0; k < faces.size(); ++k)
    if (faces[k] != nullptr) tractions[k] = faces[k]->traction;
  const auto data = polyDataOf(lumen, triangles);
  auto* cells = data->GetCellData();
  addArray<vtkUnsignedCharArray>(cells, "region", triangles.size(), 1,
                                 [&](std::size_t k, int) { return lumen.region[triangles[k]]; });
  addArray<vtkFloatArray>(cells, "WSS", triangles.size(), 1,
                          [&](std::size_t k, int) { return tractions[k].norm(); });
  addArray<vtkFloatArray>(cells, "traction", triangles.size(), 3,
                          [&](std::size_t k, int c) { return tractions[k][c]; });
  if (flow != nullptr && flow->beats.beats > 0) addBeatArrays(*cells, faces);
  const auto points = static_cast<std::size_t>(data->GetNumberOfPoints());
  const auto place = [&](std::size_t p) { return Vec3(data->GetPoint(static_cast<vtkIdType>(p))); };
  const auto radius = [&](std::size_t p) { return std::hypot(place(p).x(), place(p).y()); };
  addArray<vtkFloatArray>(data->GetPointData(), "lumenRadius", points, 1,
                          [&](std::size_t p, int) { return radius(p); });
  if (postDeployment != nullptr) {
    addArray<vtkFloatArray>(data->GetPointData(), "neointimaThickness", points, 1, [&](std::size_t p, int) {
      return postDeployment->radiusAt(place(p)) - radius(p);
    });
  }
  if (axis != nullptr) bendPolyData(*data, *axis);
  for (const SurfaceRegion region : allRegions(lumen))
    if (isEnd(region)) addCentre(*data, fmt::format("{}Centre", regionName(region)), lumen, region, axis);
  writePolyData(file, data, time);
}

}  // namespace restenosis
