#include "bridge/output/SurfacePolyData.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>

#include <vector>

namespace restenosis {

vtkNew<vtkPolyData> polyDataOf(const TriSurface& surface, std::span<const std::size_t> triangles) {
  constexpr vtkIdType unused = -1;
  std::vector<vtkIdType> number(surface.vertices.size(), unused);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  vtkNew<vtkCellArray> polygons;
  for (const std::size_t t : triangles) {
    polygons->InsertNextCell(3);
    for (const auto vertex : surface.triangles[t]) {
      if (number[vertex] == unused) number[vertex] = points->InsertNextPoint(surface.vertices[vertex].data());
      polygons->InsertCellPoint(number[vertex]);
    }
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(polygons);
  return data;
}

}  // namespace restenosis
