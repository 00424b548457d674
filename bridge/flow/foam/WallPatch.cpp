#include "bridge/flow/foam/WallPatch.h"

#include <fmt/format.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <stdexcept>

namespace restenosis {
namespace {

constexpr const char* field = "wallShearStress";

struct Polygon {
  Vec3 centre, areaVector;
};

/// Centre and area vector of a polygon, by triangles about its first corner's mean.
Polygon polygon(vtkPolyData& patch, const vtkIdType* ids, vtkIdType count) {
  std::vector<Vec3> corners(count);
  Vec3 middle = Vec3::Zero();
  for (vtkIdType i = 0; i < count; ++i) {
    patch.GetPoint(ids[i], corners[i].data());
    middle += corners[i] / static_cast<double>(count);
  }
  Polygon result{Vec3::Zero(), Vec3::Zero()};
  double total = 0.0;
  for (vtkIdType i = 0; i < count; ++i) {
    const Vec3 &a = corners[i], &b = corners[(i + 1) % count];
    const Vec3 areaVector = 0.5 * (a - middle).cross(b - middle);
    result.areaVector += areaVector;
    result.centre += areaVector.norm() * (a + b + middle) / 3.0;
    total += areaVector.norm();
  }
  result.centre = total > 0.0 ? Vec3(result.centre / total) : middle;
  return result;
}

}  // namespace

Vec3 PatchFace::traction(double density, const Vec3& wallShearStress) const {
  const Vec3 normal = areaVector.normalized(), whole = -density * wallShearStress;
  return whole - whole.dot(normal) * normal;
}

std::vector<PatchFace> readWallPatch(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) throw std::runtime_error(fmt::format("{} is missing", file.string()));
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData& patch = *reader->GetOutput();
  const vtkIdType count = patch.GetNumberOfCells();
  if (reader->GetErrorCode() != 0 || count == 0)
    throw std::runtime_error(fmt::format("{} cannot be read or has no faces", file.string()));
  vtkDataArray* stress = patch.GetCellData()->GetArray(field);
  if (!stress || stress->GetNumberOfComponents() != 3 || stress->GetNumberOfTuples() != count)
    throw std::runtime_error(fmt::format("{} has no face field {}", file.string(), field));

  std::vector<PatchFace> faces(count);
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < count; ++i) {
    patch.GetCellPoints(i, ids);
    const Polygon face = polygon(patch, ids->GetPointer(0), ids->GetNumberOfIds());
    faces[i] = {face.centre, face.areaVector, {}};
    stress->GetTuple(i, faces[i].shearStress.data());
    if (!faces[i].shearStress.allFinite())
      throw std::runtime_error(fmt::format("{} has a stress that is not finite", file.string()));
  }
  return faces;
}

void appendWallPatch(const std::filesystem::path& file, SurfaceRegion region, double density,
                     std::vector<WallFace>& faces) {
  for (const PatchFace& face : readWallPatch(file)) {
    const double area = face.areaVector.norm();
    if (!(area > 0.0)) continue;
    faces.push_back({face.centre, area, face.traction(density, face.shearStress), region});
  }
}

}  // namespace restenosis
