#include "bridge/surface/SurfaceFile.h"

#include <fmt/format.h>
#include <vtkAbstractArray.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkObject.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "bridge/surface/StlFile.h"
#include "bridge/surface/StlTriangles.h"
#include "bridge/system/FileContent.h"
#include "bridge/system/OwnProcess.h"
#include "tissue/agents/StateArchive.h"

namespace restenosis {
namespace {

/// As much as of an STL file [bytes] (assumed).
constexpr std::uintmax_t largestSurfaceFile = 512 << 20;

std::string endingOf(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

template <class Reader>
vtkSmartPointer<vtkPolyData> readBy(const std::filesystem::path& file, std::string_view kind) {
  vtkObject::GlobalWarningDisplayOff();  // in a copy of this process: see readGuarded
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0) refuseFile(file, fmt::format("cannot be read as {}", kind));
  return reader->GetOutput();
}

/// Faces that name no vertex would be read from anywhere.
void requireVertices(vtkPolyData& data, const std::filesystem::path& file) {
  for (vtkIdType v = 0; v < data.GetNumberOfPoints(); ++v) {
    const double* const p = data.GetPoint(v);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      refuseFile(file, fmt::format("has a vertex that is not a finite number: {} of {}", v + 1,
                                   data.GetNumberOfPoints()));
  }
  for (vtkCellArray* const faces : {data.GetPolys(), data.GetStrips()}) {
    for (vtkIdType f = 0; f < faces->GetNumberOfCells(); ++f) {
      vtkIdType count = 0;
      const vtkIdType* corners = nullptr;
      faces->GetCellAtId(f, count, corners);
      if (std::any_of(corners, corners + count,
                      [&](vtkIdType v) { return v < 0 || v >= data.GetNumberOfPoints(); }))
        refuseFile(
            file, fmt::format("has a face that names no vertex: {} of {}", f + 1, faces->GetNumberOfCells()));
    }
  }
}

vtkSmartPointer<vtkPolyData> trianglesOf(vtkPolyData& data) {
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(&data);
  filter->PassVertsOff();
  filter->PassLinesOff();
  filter->Update();
  return filter->GetOutput();
}

/// Name of the region of a triangle.
std::string regionOf(vtkAbstractArray& regions, vtkIdType triangle, const std::filesystem::path& file) {
  if (auto* const texts = vtkStringArray::SafeDownCast(&regions)) return texts->GetValue(triangle);
  auto* const numbers = vtkDataArray::SafeDownCast(&regions);
  const double number =
      numbers != nullptr && numbers->GetNumberOfComponents() == 1 ? numbers->GetTuple1(triangle) : -1;
  for (const SurfaceRegion region :
       {SurfaceRegion::wall, SurfaceRegion::strut, SurfaceRegion::inlet, SurfaceRegion::outlet})
    if (number == static_cast<double>(region)) return std::string(regionName(region));
  refuseFile(
      file,
      "has a cell array 'region' that is neither texts nor 0 (wall), 1 (strut), 2 (inlet) or 3 (outlet)");
}

void addSolids(FileTriangles& triangles, vtkPolyData& data, const std::filesystem::path& file) {
  vtkAbstractArray* const regions = data.GetCellData()->GetAbstractArray("region");
  if (regions == nullptr) {
    triangles.names = {""};
    triangles.solid.assign(triangles.corners.size(), 0);
    return;
  }
  for (std::size_t t = 0; t < triangles.corners.size(); ++t) {
    const std::string name = regionOf(*regions, static_cast<vtkIdType>(t), file);
    const auto known = std::ranges::find(triangles.names, name);
    triangles.solid.push_back(static_cast<std::uint32_t>(known - triangles.names.begin()));
    if (known == triangles.names.end()) triangles.names.push_back(name);
  }
}

FileTriangles readPolyData(const std::filesystem::path& file, std::string_view ending) {
  const auto data = ending == ".vtp"   ? readBy<vtkXMLPolyDataReader>(file, "VTK's XML polygonal data (.vtp)")
                    : ending == ".ply" ? readBy<vtkPLYReader>(file, "PLY")
                                       : readBy<vtkOBJReader>(file, "OBJ");
  requireVertices(*data, file);
  const auto mesh = trianglesOf(*data);
  FileTriangles result;
  for (vtkIdType t = 0; t < mesh->GetNumberOfPolys(); ++t) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    mesh->GetPolys()->GetCellAtId(t, count, ids);
    std::array<double, 9>& corners = result.corners.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) mesh->GetPoint(ids[k], corners.data() + 3 * k);
  }
  if (result.corners.empty()) refuseFile(file, "holds no triangles");
  addSolids(result, *mesh, file);
  return result;
}

/// VTK's readers of PLY and OBJ believe what a file says of its own numbers, and crash where that is wrong.
FileTriangles readGuarded(const std::filesystem::path& file, std::string_view ending) {
  if (const std::string obstacle = fileObstacle(file, largestSurfaceFile); !obstacle.empty())
    refuseFile(file, obstacle);
  std::string bytes;
  try {
    bytes = inOwnProcess([&] {
      WritingArchive archive;
      FileTriangles read = readPolyData(file, ending);
      archive(read);
      return archive.buffer();
    });
  } catch (const std::runtime_error& error) {
    const std::string_view what = error.what();
    if (what.starts_with(file.string())) throw;
    refuseFile(file, fmt::format("cannot be read: {}", what));
  }
  FileTriangles result;
  ReadingArchive archive(std::move(bytes));
  archive(result);
  return result;
}

}  // namespace

bool isSurfaceFile(const std::filesystem::path& file) {
  return std::ranges::find(surfaceFileEndings, endingOf(file)) != std::end(surfaceFileEndings);
}

FileTriangles readSurfaceTriangles(const std::filesystem::path& file) {
  const std::string ending = endingOf(file);
  return ending != ".stl" && isSurfaceFile(file) ? readGuarded(file, ending) : readStlTriangles(file);
}

}  // namespace restenosis
