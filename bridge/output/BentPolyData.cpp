#include "bridge/output/BentPolyData.h"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include "bridge/output/PolyDataFile.h"

namespace restenosis {
namespace {

Vec3 middleOf(vtkPolyData& data, vtkIdType cell) {
  vtkNew<vtkIdList> corners;
  data.GetCellPoints(cell, corners);
  Vec3 middle = Vec3::Zero();
  for (const vtkIdType corner : *corners) middle += Vec3(data.GetPoint(corner));
  return middle / static_cast<double>(corners->GetNumberOfIds());
}

}  // namespace

void bendPolyData(vtkPolyData& data, const Centreline& axis) {
  if (vtkDataArray* traction = data.GetCellData()->GetArray("traction"))
    for (vtkIdType cell = 0; cell < data.GetNumberOfCells(); ++cell)
      traction->SetTuple(
          cell, Vec3(axis.vectorToBent(middleOf(data, cell), Vec3(traction->GetTuple3(cell)))).data());
  const auto points = static_cast<std::size_t>(data.GetNumberOfPoints());
  const auto place = [&](std::size_t n) { return Vec3(data.GetPoint(static_cast<vtkIdType>(n))); };
  addArray<vtkFloatArray>(data.GetPointData(), "straightPosition", points, 3,
                          [&](std::size_t n, int c) { return place(n)[c]; });
  for (std::size_t n = 0; n < points; ++n)
    data.GetPoints()->SetPoint(static_cast<vtkIdType>(n), axis.toBent(place(n)).data());
  data.GetPoints()->Modified();
}

}  // namespace restenosis
