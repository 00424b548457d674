#include "bridge/compare/LumenFile.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUtilities.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "bridge/surface/SurfaceEnds.h"

namespace restenosis {
namespace {

/// An end's vertices keep to their plane to this share of its radius: far more than what rounding to single
/// precision moves them by, unless the lumen lies very far from the origin.
constexpr double flatness = 1e-3;

/// The rims of the tube.
std::vector<std::vector<std::uint32_t>> rimsOf(const TriSurface& tube, const std::filesystem::path& file) {
  const SurfaceEdges edges = surfaceEdges(tube);
  if (edges.opposed > 0)
    throw std::runtime_error(fmt::format("{}: triangles of the lumen face opposite ways", file.string()));
  try {
    return openRims(edges.open);
  } catch (const std::runtime_error&) {
    throw std::runtime_error(fmt::format("{}: a rim of the lumen is not closed", file.string()));
  }
}

using Rim = std::vector<std::uint32_t>;

/// The centres of a lumen's ends [m].
struct EndCentres {
  Vec3 inlet, outlet;
};

/// As writeLumen has noted them; of a file of a former version, which did not, the inlet is the lower end.
EndCentres endCentres(vtkPolyData& data, const std::vector<FittedPlane>& planes) {
  vtkDataArray* const inlet = data.GetFieldData()->GetArray("inletCentre");
  vtkDataArray* const outlet = data.GetFieldData()->GetArray("outletCentre");
  const auto isPlace = [](vtkDataArray* array) {
    return array != nullptr && array->GetNumberOfTuples() == 1 && array->GetNumberOfComponents() == 3;
  };
  EndCentres ends;
  if (isPlace(inlet) && isPlace(outlet)) {
    inlet->GetTuple(0, ends.inlet.data());
    outlet->GetTuple(0, ends.outlet.data());
    return ends;
  }
  const auto height = [](const FittedPlane& plane) { return plane.centre.z(); };
  const auto [low, high] = std::ranges::minmax_element(planes, {}, height);
  return {low->centre, high->centre};
}

/// Closes a rim by a fan about its centre. Coordinates in a file are rounded, so the rim is moved into its
/// plane, unless that is one of constant z, which rounding leaves one.
void addCap(TriSurface& tube, const Rim& rim, const FittedPlane& plane, SurfaceRegion end) {
  const double z = tube.vertices[rim.front()].z();
  Vec3 centre = plane.centre;
  if (std::ranges::all_of(rim, [&](auto v) { return tube.vertices[v].z() == z; })) {
    centre.z() = z;
  } else {
    for (const auto v : rim) {
      Vec3& vertex = tube.vertices[v];
      vertex -= plane.normal.dot(vertex - plane.centre) * plane.normal;
    }
  }
  const auto middle = static_cast<std::uint32_t>(tube.vertices.size());
  tube.vertices.push_back(centre);
  for (std::size_t k = 0; k < rim.size(); ++k) {
    tube.triangles.push_back({rim[(k + 1) % rim.size()], rim[k], middle});
    tube.region.push_back(end);
  }
}

/// Closes both ends of the tube that was read from `data`.
void addCaps(TriSurface& tube, vtkPolyData& data, const std::filesystem::path& file) {
  const std::vector<Rim> rims = rimsOf(tube, file);
  const auto refuse = [&](std::string_view what) {
    return std::runtime_error(fmt::format("{}: the lumen {}", file.string(), what));
  };
  if (rims.size() < 2) throw refuse("has not two open ends");
  std::vector<FittedPlane> planes;
  for (const Rim& rim : rims) planes.push_back(fitPlane(tube, rim));
  const EndCentres ends = endCentres(data, planes);
  const auto nearest = [&](const Vec3& place) {
    const auto distance = [&](const FittedPlane& plane) { return (plane.centre - place).squaredNorm(); };
    return static_cast<std::size_t>(std::ranges::min_element(planes, {}, distance) - planes.begin());
  };
  const std::size_t inlet = nearest(ends.inlet), outlet = nearest(ends.outlet);
  if (inlet == outlet) throw refuse("has not two open ends");
  for (std::size_t k = 0; k < rims.size(); ++k) {
    const Vec3 place = 1e3 * planes[k].centre;
    if (k != inlet && k != outlet)
      throw refuse(fmt::format("has a hole at ({:.4g}, {:.4g}, {:.4g}) mm", place.x(), place.y(), place.z()));
    const double width = (tube.vertices[rims[k].front()] - planes[k].centre).norm();
    if (!(planes[k].departure <= flatness * width))
      throw refuse(fmt::format("has no planar {}", k == inlet ? "inlet" : "outlet"));
  }
  addCap(tube, rims[inlet], planes[inlet], SurfaceRegion::inlet);
  addCap(tube, rims[outlet], planes[outlet], SurfaceRegion::outlet);
}

/// What the attribute says; empty where there is none.
std::string_view attribute(vtkXMLDataElement& element, const char* name) {
  const char* const text = element.GetAttribute(name);
  return text == nullptr ? std::string_view() : text;
}

std::optional<double> numberIn(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

}  // namespace

std::vector<RecordedLumen> recordedLumens(const std::filesystem::path& results) {
  const auto index = results / "lumen.pvd";
  if (!std::filesystem::exists(index))
    throw std::runtime_error(fmt::format("{} is missing: no lumen has been recorded", index.string()));
  const auto damaged = [&](std::string_view how) {
    return std::runtime_error(fmt::format("{} is damaged: {}", index.string(), how));
  };
  const auto root =
      vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(index.c_str()));
  vtkXMLDataElement* const collection = root ? root->FindNestedElementWithName("Collection") : nullptr;
  if (collection == nullptr) throw damaged("it holds no collection of files");
  std::vector<RecordedLumen> lumens;
  for (int k = 0; k < collection->GetNumberOfNestedElements(); ++k) {
    vtkXMLDataElement& element = *collection->GetNestedElement(k);
    const auto day = numberIn(attribute(element, "timestep"));
    const std::string_view file = attribute(element, "file");
    if (!day || file.empty()) throw damaged("an entry has no day or no file");
    lumens.push_back({*day, results / file});
  }
  if (lumens.empty()) throw std::runtime_error(fmt::format("{} names no lumen yet", index.string()));
  return lumens;
}

const RecordedLumen& lumenOfDay(const std::vector<RecordedLumen>& lumens, double day) {
  return *std::min_element(lumens.begin(), lumens.end(), [day](const auto& a, const auto& b) {
    return std::abs(a.day - day) < std::abs(b.day - day);
  });
}

TriSurface readLumen(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) throw std::runtime_error(fmt::format("{} is missing", file.string()));
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData& data = *reader->GetOutput();
  vtkDataArray* region = data.GetCellData()->GetArray("region");
  if (reader->GetErrorCode() != 0 || data.GetNumberOfPolys() == 0 || region == nullptr)
    throw std::runtime_error(fmt::format("{} is no recorded lumen", file.string()));
  TriSurface tube;
  tube.vertices.resize(static_cast<std::size_t>(data.GetNumberOfPoints()));
  for (std::size_t v = 0; v < tube.vertices.size(); ++v)
    data.GetPoint(static_cast<vtkIdType>(v), tube.vertices[v].data());
  if (!std::ranges::all_of(tube.vertices, [](const Vec3& vertex) { return vertex.allFinite(); }))
    throw std::runtime_error(fmt::format("{} is damaged: a vertex is not finite", file.string()));
  vtkNew<vtkIdList> corners;
  for (vtkIdType t = 0; t < data.GetNumberOfPolys(); ++t) {
    data.GetPolys()->GetCellAtId(t, corners);
    if (corners->GetNumberOfIds() != 3)
      throw std::runtime_error(fmt::format("{} has faces that are no triangles", file.string()));
    const auto corner = [&](vtkIdType k) {
      const vtkIdType id = corners->GetId(k);
      if (id < 0 || id >= data.GetNumberOfPoints())
        throw std::runtime_error(fmt::format("{} is damaged: a face names no vertex", file.string()));
      return static_cast<std::uint32_t>(id);
    };
    tube.triangles.push_back({corner(0), corner(1), corner(2)});
    tube.region.push_back(region->GetComponent(t, 0) == 1.0 ? SurfaceRegion::strut : SurfaceRegion::wall);
  }
  addCaps(tube, data, file);
  return tube;
}

}  // namespace restenosis
