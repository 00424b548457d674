#include "bridge/compare/ComparisonWriter.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <nlohmann/json.hpp>

#include "bridge/output/PolyDataFile.h"
#include "bridge/output/Version.h"
#include "bridge/system/AtomicFile.h"
#include "tissue/parameters/SecondsPerDay.h"

namespace restenosis {
namespace {

using Json = nlohmann::ordered_json;

constexpr double perMillimetre = 1e3, perSquareMillimetre = 1e6;

Json costJson(const SolvedFlow& flow) {
  Json json;
  json["cells"] = flow.solution.cells;
  json["iterations"] = flow.solution.iterations;
  json["seconds"] = flow.seconds;
  json["meshSeconds"] = flow.solution.meshSeconds;
  json["solveSeconds"] = flow.solution.solveSeconds;
  json["pressureDrop_Pa"] = flow.solution.pressureDrop;
  json["massImbalance"] = flow.solution.massImbalance;
  json["remarks"] = flow.solution.remarks;
  return json;
}

/// Rows of the rotation and the translation after it: where a place of the other files is along z.
Json motionJson(const Eigen::Isometry3d& motion) {
  Json json;
  const Eigen::Matrix3d turn = motion.linear();
  for (int row = 0; row < 3; ++row) json["rotation"].push_back({turn(row, 0), turn(row, 1), turn(row, 2)});
  const Vec3 shift = perMillimetre * motion.translation();
  json["translation_mm"] = {shift.x(), shift.y(), shift.z()};
  return json;
}

class DifferenceJson {
 public:
  DifferenceJson(std::string reference, std::string other, std::string unit)
      : reference_(std::move(reference)), other_(std::move(other)), unit_(std::move(unit)) {}
  Json operator()(const FieldDifference& d) const {
    Json json;
    json["count"] = d.count;
    if (d.count == 0) return json;
    json[reference_ + "Mean_" + unit_] = d.referenceMean;
    json[other_ + "Mean_" + unit_] = d.mean;
    json["meanDifference"] = d.meanDifference;
    json["relativeL2"] = d.relativeL2;
    json["correlation"] = d.correlation;
    json["relativeDifferenceP95"] = d.relativeP95;
    json["bias_" + unit_] = d.bias;
    json["limitsOfAgreement_" + unit_] = {d.lowerLimit, d.upperLimit};
    return json;
  }

 private:
  std::string reference_, other_, unit_;
};

}  // namespace

void writeComparisonJson(const std::filesystem::path& file, const ComparedCase& what, const FlowComparison& c,
                         const SolvedFlow& reference, const SolvedFlow& other) {
  Json json;
  json["scene"] = what.scene;
  json["day"] = what.day;
  json["fidelity"] = what.fidelity;
  json["latticeSpacing_um"] = what.latticeSpacing * 1e6;
  json["bent"] = what.bent;
  json["alongZ"] = motionJson(what.alongZ);
  json["version"] = version();
  json["reference"] = reference.backend;
  json[reference.backend] = costJson(reference);
  json[other.backend] = costJson(other);
  json["pressureDropDifference"] = other.solution.pressureDrop / reference.solution.pressureDrop - 1.0;
  const DifferenceJson stress(reference.backend, other.backend, "Pa");
  const auto withArea = [&](const FieldDifference& d) {
    Json part = stress(d);
    part["area_mm2"] = d.weight * perSquareMillimetre;
    return part;
  };
  json["wss"]["wall"] = withArea(c.wall);
  json["wss"]["strut"] = withArea(c.strut);
  for (const ComparedPart part : comparedParts)
    if (part != ComparedPart::strut)
      json["wss"][std::string(partName(part))] = withArea(c.parts[static_cast<std::size_t>(part)]);
  json["wss"]["unknownFaces"] = c.unknownFaces;
  if (c.hasVelocities && !c.lines.axis.empty()) {
    const DifferenceJson velocity(reference.backend, other.backend, "m_s");
    json["velocity"]["axis"] = velocity(c.axis);
    for (std::size_t i = 0; i < c.planes.size(); ++i) {
      Json plane = velocity(c.planes[i]);
      plane["z_mm"] = c.lines.planes[i].z * perMillimetre;
      json["velocity"]["planes"].push_back(plane);
    }
  }
  atomicWrite(file, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

void writeComparisonSurface(const std::filesystem::path& file, const TriSurface& lumen,
                            const FlowComparison& c, const SolvedFlow& reference, const SolvedFlow& other,
                            const ComparedCase& what) {
  const Eigen::Isometry3d back = what.alongZ.inverse();
  vtkNew<vtkPoints> points;
  for (const Vec3& v : lumen.vertices) points->InsertNextPoint((back * v).eval().data());
  vtkNew<vtkCellArray> polygons;
  for (const auto t : c.faces.triangle) {
    polygons->InsertNextCell(3);
    for (const auto v : lumen.triangles[t]) polygons->InsertCellPoint(v);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(polygons);
  auto* cells = data->GetCellData();
  const std::size_t n = c.faces.size();
  addArray<vtkUnsignedCharArray>(cells, "part", n, 1, [&](std::size_t i, int) { return c.faces.part[i]; });
  const SolvedFlow* flows[] = {&reference, &other};
  for (std::size_t f = 0; f < 2; ++f) {
    const auto& traction = c.traction[f];
    addArray<vtkFloatArray>(cells, ("WSS_" + flows[f]->backend).c_str(), n, 1,
                            [&](std::size_t i, int) { return traction[i].norm(); });
    addArray<vtkFloatArray>(cells, ("traction_" + flows[f]->backend).c_str(), n, 3,
                            [&](std::size_t i, int d) { return back.linear().row(d).dot(traction[i]); });
  }
  addArray<vtkFloatArray>(cells, "WSS_difference", n, 1, [&](std::size_t i, int) {
    return c.traction[1][i].norm() - c.traction[0][i].norm();
  });
  writePolyData(file, data, what.day * secondsPerDay);
}

void writeComparedVelocities(const std::filesystem::path& file, const FlowComparison& c,
                             const SolvedFlow& reference, const SolvedFlow& other, const ComparedCase& what) {
  if (!c.hasVelocities) return;
  const Eigen::Isometry3d back = what.alongZ.inverse();
  std::string text = "where,x_mm,y_mm,z_mm";
  for (const SolvedFlow* flow : {&reference, &other})
    for (const char axis : {'x', 'y', 'z'}) text += fmt::format(",{}_u{}_m_s", flow->backend, axis);
  text += '\n';
  std::size_t at = 0;
  const auto rows = [&](const std::string& where, const std::vector<Vec3>& points) {
    for (const Vec3& point : points) {
      const Vec3 p = back * point;
      text += fmt::format("{},{:.6g},{:.6g},{:.6g}", where, perMillimetre * p.x(), perMillimetre * p.y(),
                          perMillimetre * p.z());
      for (const SolvedFlow* flow : {&reference, &other})
        for (const double u : Vec3(back.linear() * flow->velocities[at])) text += fmt::format(",{:.6g}", u);
      text += '\n';
      ++at;
    }
  };
  rows("axis", c.lines.axis);
  for (std::size_t i = 0; i < c.lines.planes.size(); ++i)
    rows(fmt::format("plane{}", i + 1), c.lines.planes[i].points);
  rows("probe", c.lines.others);
  atomicWrite(file, text);
}

}  // namespace restenosis
