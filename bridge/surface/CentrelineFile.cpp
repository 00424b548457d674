#include "bridge/surface/CentrelineFile.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <string>
#include <string_view>

#include "bridge/surface/FileTriangles.h"
#include "bridge/system/FileContent.h"
#include "bridge/system/OwnProcess.h"
#include "tissue/agents/StateArchive.h"
#include "tissue/parameters/CsvLines.h"
#include "tissue/parameters/Shown.h"

namespace restenosis {
namespace {

constexpr std::size_t mostPointsKept = 400;
constexpr std::string_view radiusArray = "MaximumInscribedSphereRadius";

CentrelinePoints readTable(const std::filesystem::path& file) {
  if (const std::string obstacle = fileObstacle(file); !obstacle.empty()) refuseFile(file, obstacle);
  CsvLines lines(file);
  CentrelinePoints read;
  std::size_t columns = 0;
  if (lines.next()) {
    columns = lines.text() == "x,y,z,radius" ? 4 : 3;
    if (columns == 3 && lines.text() != "x,y,z")
      lines.fail(fmt::format("{} is no header of a centreline; it must be 'x,y,z' or 'x,y,z,radius'",
                             shown(lines.text())));
  }
  while (lines.next()) {
    std::vector<double> numbers;
    for (const std::string_view cell : lines.cells())
      if (const auto number = finiteNumber(cell)) numbers.push_back(*number);
    if (numbers.size() != columns || lines.cells().size() != columns)
      lines.fail(fmt::format("{} is not {} numbers with commas between", shown(lines.text()), columns));
    read.points.emplace_back(numbers[0], numbers[1], numbers[2]);
    if (columns == 4 && !(numbers[3] > 0))
      lines.fail(fmt::format("the radius {:g} is not positive", numbers[3]));
    if (columns == 4) read.radii.push_back(numbers[3]);
  }
  return read;
}

CentrelinePoints readPolyline(const std::filesystem::path& file) {
  vtkObject::GlobalWarningDisplayOff();  // in a copy of this process
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0) refuseFile(file, "cannot be read as VTK's XML polygonal data (.vtp)");
  vtkPolyData& data = *reader->GetOutput();
  if (const vtkIdType lines = data.GetLines()->GetNumberOfCells(); lines != 1)
    refuseFile(file, fmt::format("has {} lines; a centreline is one, from the inlet to the outlet", lines));
  vtkDataArray* const radii = data.GetPointData()->GetArray(radiusArray.data());
  CentrelinePoints read;
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  data.GetLines()->GetCellAtId(0, count, ids);
  for (vtkIdType n = 0; n < count; ++n) {
    if (ids[n] < 0 || ids[n] >= data.GetNumberOfPoints()) refuseFile(file, "has a line that names no point");
    const Vec3& point = read.points.emplace_back(data.GetPoint(ids[n]));
    const double radius = radii != nullptr ? radii->GetTuple1(ids[n]) : 1;
    if (!point.allFinite() || !std::isfinite(radius) || !(radius > 0))
      refuseFile(file, fmt::format("has a point that is not finite, or without a positive radius: {} of {}",
                                   n + 1, count));
    if (radii != nullptr) read.radii.push_back(radius);
  }
  return read;
}

CentrelinePoints readGuarded(const std::filesystem::path& file) {
  if (const std::string obstacle = fileObstacle(file); !obstacle.empty()) refuseFile(file, obstacle);
  std::string bytes = inOwnProcess([&] {
    WritingArchive archive;
    CentrelinePoints read = readPolyline(file);
    archive(read);
    return archive.buffer();
  });
  CentrelinePoints result;
  ReadingArchive archive(std::move(bytes));
  archive(result);
  return result;
}

/// Some evenly in between; first and last stay.
CentrelinePoints thinned(const CentrelinePoints& all) {
  if (all.points.size() <= mostPointsKept) return all;
  CentrelinePoints few;
  for (std::size_t n = 0; n < mostPointsKept; ++n) {
    const std::size_t from = n * (all.points.size() - 1) / (mostPointsKept - 1);
    few.points.push_back(all.points[from]);
    if (!all.radii.empty()) few.radii.push_back(all.radii[from]);
  }
  return few;
}

}  // namespace

CentrelinePoints readCentreline(const std::filesystem::path& file, double metresPerUnit) {
  CentrelinePoints read = file.extension() == ".vtp" ? readGuarded(file) : readTable(file);
  if (read.points.size() < 2)
    refuseFile(file, fmt::format("holds {} points of a centreline", read.points.size()));
  for (std::size_t n = 1; n < read.points.size(); ++n)
    if (read.points[n] == read.points[n - 1])
      refuseFile(file, fmt::format("has two neighbours in one place: points {} and {}", n, n + 1));
  for (Vec3& point : read.points) point *= metresPerUnit;
  for (double& radius : read.radii) radius *= metresPerUnit;
  return thinned(read);
}

}  // namespace restenosis
