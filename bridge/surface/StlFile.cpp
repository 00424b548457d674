#include "StlFile.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCleanPolyData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace restenosis {
namespace {

constexpr std::array allRegions{SurfaceRegion::wall, SurfaceRegion::strut, SurfaceRegion::inlet,
                                SurfaceRegion::outlet};

void save(const std::filesystem::path& file, const std::string& content) {
  std::ofstream out(file, std::ios::binary);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  if (!out) throw std::runtime_error(fmt::format("cannot write {}", file.string()));
}

/// Distance below which vertices are one, over the diagonal of the surface's box.
constexpr double mergedWithin = 1e-6;

vtkPolyData& readPolygons(vtkSTLReader& reader, const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file))
    throw std::runtime_error(fmt::format("{} is not a file", file.string()));
  reader.SetFileName(file.string().c_str());
  reader.GlobalWarningDisplayOff();
  reader.Update();
  vtkPolyData* mesh = reader.GetOutput();
  if (!mesh || mesh->GetNumberOfPolys() == 0)
    throw std::runtime_error(fmt::format("{} holds no triangles: it must be an STL file", file.string()));
  return *mesh;
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

/// Binary files may begin with "solid" too; they are known by their size.
bool isBinary(const std::filesystem::path& file) {
  std::array<char, 84> head{};
  std::uint32_t count = 0;
  if (!std::ifstream(file, std::ios::binary).read(head.data(), head.size())) return false;
  std::memcpy(&count, head.data() + 80, sizeof(count));
  return std::filesystem::file_size(file) == 84 + 50 * std::uintmax_t{count};
}

/// The names behind the words "solid" of an ASCII file, in order.
std::vector<std::string> solidNames(const std::filesystem::path& file) {
  std::vector<std::string> names;
  if (isBinary(file)) return names;
  std::ifstream stream(file, std::ios::binary);
  for (std::string line; std::getline(stream, line);) {
    const auto start = line.find_first_not_of(" \t");
    if (start == std::string::npos || line.compare(start, 5, "solid") != 0) continue;
    const auto name = line.find_first_not_of(" \t", start + 5), end = line.find_last_not_of(" \t\r");
    names.push_back(name == std::string::npos || name > end ? "" : line.substr(name, end - name + 1));
  }
  return names;
}

}  // namespace

std::string_view regionName(SurfaceRegion region) {
  constexpr std::array<std::string_view, 4> names{"wall", "strut", "inlet", "outlet"};
  return names[static_cast<std::size_t>(region)];
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
  save(file, content);
}

void writeNamedStl(const std::filesystem::path& file, const TriSurface& surface, double metresPerUnit) {
  std::string content;
  auto out = std::back_inserter(content);
  for (const SurfaceRegion region : allRegions) {
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
  save(file, content);
}

TriSurface readStl(const std::filesystem::path& file, double metresPerUnit) {
  vtkNew<vtkSTLReader> reader;
  reader->MergingOn();
  return surfaceOf(readPolygons(*reader, file), metresPerUnit);
}

StlSolids readStlSolids(const std::filesystem::path& file, double metresPerUnit) {
  vtkNew<vtkSTLReader> reader;
  reader->MergingOff();  // vertices that are no numbers must be found before they are sorted by place
  reader->ScalarTagsOn();
  vtkPolyData& soup = readPolygons(*reader, file);
  for (vtkIdType v = 0; v < soup.GetNumberOfPoints(); ++v) {
    const double* p = soup.GetPoint(v);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      throw std::runtime_error(
          fmt::format("{} has a vertex that is not a finite number, in triangle {}", file.string(), v / 3));
  }
  vtkNew<vtkCleanPolyData> welded;
  welded->SetInputData(&soup);
  welded->SetTolerance(mergedWithin);
  welded->Update();
  vtkPolyData& mesh = *welded->GetOutput();
  StlSolids result;
  result.surface = surfaceOf(mesh, metresPerUnit);
  result.names = solidNames(file);
  // Cells that lost their area come before the triangles
  const vtkIdType before = mesh.GetNumberOfCells() - mesh.GetNumberOfPolys();
  vtkDataArray* label = mesh.GetCellData()->GetScalars();
  for (vtkIdType c = 0; c < mesh.GetNumberOfPolys(); ++c)
    result.solid.push_back(label ? static_cast<std::uint32_t>(label->GetTuple1(before + c)) : 0);
  const auto last = std::max_element(result.solid.begin(), result.solid.end());
  if (last != result.solid.end()) result.names.resize(std::max<std::size_t>(result.names.size(), *last + 1));
  return result;
}

void markEnds(TriSurface& surface, double length, double tolerance) {
  for (const auto& [z, region] : {std::pair{0.0, SurfaceRegion::inlet}, {length, SurfaceRegion::outlet}}) {
    auto near = [&](std::uint32_t v) { return std::abs(surface.vertices[v].z() - z) <= tolerance; };
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      const auto& c = surface.triangles[t];
      if (!near(c[0]) || !near(c[1]) || !near(c[2])) continue;
      surface.region[t] = region;
      for (const auto v : c) surface.vertices[v].z() = z;
    }
  }
}

}  // namespace restenosis
