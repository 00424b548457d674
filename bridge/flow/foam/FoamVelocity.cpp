#include "FoamVelocity.h"

#include <fmt/format.h>
#include <vtkCharArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOpenFOAMReader.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProbeFilter.h>
#include <vtkUnstructuredGrid.h>

#include <limits>
#include <stdexcept>

namespace restenosis {
namespace {

constexpr double millimetre = 1e-3;

/// The volume mesh with the last time's fields.
vtkUnstructuredGrid* lastTime(vtkOpenFOAMReader& reader, const std::filesystem::path& caseFolder) {
  const std::string file = (caseFolder / "case.foam").string();
  reader.SetFileName(file.c_str());
  reader.CreateCellToPointOn();
  reader.DecomposePolyhedraOn();
  reader.UpdateInformation();
  vtkDoubleArray* times = reader.GetTimeValues();
  const vtkIdType count = times ? times->GetNumberOfTuples() : 0;
  if (count == 0) throw std::runtime_error(fmt::format("{} has no times", caseFolder.string()));
  reader.UpdateTimeStep(times->GetValue(count - 1));
  for (unsigned block = 0; block < reader.GetOutput()->GetNumberOfBlocks(); ++block) {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(reader.GetOutput()->GetBlock(block));
    if (grid && grid->GetPointData()->GetArray("U")) return grid;
  }
  throw std::runtime_error(fmt::format("{} has no velocities", caseFolder.string()));
}

}  // namespace

std::vector<Vec3> foamVelocities(const std::filesystem::path& caseFolder, const std::vector<Vec3>& points) {
  vtkNew<vtkOpenFOAMReader> reader;
  vtkUnstructuredGrid* grid = lastTime(*reader, caseFolder);
  vtkNew<vtkPoints> places;
  for (const Vec3& p : points) places->InsertNextPoint((p / millimetre).eval().data());
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(places);
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputData(cloud);
  probe->SetSourceData(grid);
  probe->Update();
  vtkPointData* found = probe->GetOutput()->GetPointData();
  vtkDataArray* velocity = found->GetArray("U");
  auto* valid = vtkCharArray::SafeDownCast(found->GetArray(probe->GetValidPointMaskArrayName()));
  if (!velocity || !valid) throw std::runtime_error(fmt::format("{} cannot be sampled", caseFolder.string()));
  std::vector<Vec3> result(points.size(), Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto at = static_cast<vtkIdType>(i);
    if (valid->GetValue(at) == 0) continue;
    velocity->GetTuple(at, result[i].data());
    result[i] *= millimetre;
  }
  return result;
}

}  // namespace restenosis
