#include "bridge/output/TissueWriter.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedIntArray.h>

#include <array>
#include <utility>

#include "bridge/output/BentPolyData.h"
#include "bridge/output/PolyDataFile.h"

namespace restenosis {

namespace {

constexpr std::array<std::pair<const char*, AgentFlag>, 7> flagArrays{{{"fixed", fixed},
                                                                       {"synthetic", synthetic},
                                                                       {"inhibited", inhibited},
                                                                       {"covered", covered},
                                                                       {"exposed", exposed},
                                                                       {"injuredIel", injuredIel},
                                                                       {"daughter", daughter}}};

}  // namespace

void writeTissue(const std::filesystem::path& file, const AgentStore& agents, double time,
                 const Centreline* axis) {
  const Index n = agents.size();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->SetNumberOfPoints(n);
  vtkNew<vtkCellArray> vertices;
  vertices->AllocateExact(n, n);
  for (Index i = 0; i < n; ++i) {
    points->SetPoint(i, agents.x[i], agents.y[i], agents.z[i]);
    const vtkIdType point = i;
    vertices->InsertNextCell(1, &point);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(vertices);

  auto* arrays = data->GetPointData();
  const auto floats = [&](const char* name, const std::vector<double>& values) {
    addArray<vtkFloatArray>(arrays, name, n, 1, [&values](std::size_t i, int) { return values[i]; });
  };
  const auto bytes = [&](const char* name, auto&& get) {
    addArray<vtkUnsignedCharArray>(arrays, name, n, 1, get);
  };
  floats("radius", agents.radius);
  floats("birthRadius", agents.birthRadius);
  bytes("kind", [&](std::size_t i, int) { return agents.kind[i]; });
  bytes("state", [&](std::size_t i, int) { return agents.state[i]; });
  floats("stress", agents.stress);
  floats("NO", agents.nitricOxide);
  floats("wss", agents.wss);
  const auto optional = [&](const char* name, const OptionalArray<float>& values) {
    if (!values.modelled()) return;
    addArray<vtkFloatArray>(arrays, name, n, 1, [&values](std::size_t i, int) { return values[i]; });
  };
  optional("activation", agents.activation);
  optional("endotheliumMaturity", agents.maturity);
  if (agents.matrix.modelled()) {
    addArray<vtkFloatArray>(arrays, "matrixShare", n, 1,
                            [&](std::size_t i, int) { return agents.matrixShare(static_cast<Index>(i)); });
  }
  for (const auto& [name, flag] : flagArrays)
    bytes(name, [&, bit = flag](std::size_t i, int) { return agents.has(static_cast<Index>(i), bit); });
  addArray<vtkUnsignedIntArray>(arrays, "generation", n, 1,
                                [&](std::size_t i, int) { return agents.generation[i]; });
  addArray<vtkTypeInt64Array>(arrays, "id", n, 1, [&](std::size_t i, int) { return agents.id[i]; });
  if (axis != nullptr) bendPolyData(*data, *axis);
  writePolyData(file, data, time);
}

}  // namespace restenosis
