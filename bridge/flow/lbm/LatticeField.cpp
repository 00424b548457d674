#include "bridge/flow/lbm/LatticeField.h"

#include <fmt/format.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLImageDataWriter.h>

#include <cmath>
#include <limits>

#include "bridge/system/AtomicFile.h"

namespace restenosis {
namespace {

constexpr const char* velocityName = "U";
constexpr const char* pressureName = "pressure";

LatticeField emptyField(const LatticeFrame& frame) {
  LatticeField field;
  field.frame = frame;
  const auto& n = frame.size;
  field.index.assign(field.at({n[0] - 1, n[1] - 1, n[2] - 1}) + 1, -1);
  return field;
}

/// Calls act(node) in the order of an image: x fastest.
template <class Act>
void forEachNode(const d3q19::Step& size, Act&& act) {
  for (int z = 0; z < size[2]; ++z)
    for (int y = 0; y < size[1]; ++y)
      for (int x = 0; x < size[0]; ++x) act(d3q19::Step{x, y, z});
}

vtkNew<vtkFloatArray> arrayOf(const char* name, int components, vtkIdType nodes) {
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(nodes);
  return array;
}

}  // namespace

LatticeField latticeField(const SteadyLattice& solved) {
  LatticeField field = emptyField(solved.lattice().frame);
  field.points.reserve(solved.nodes());
  for (const NodeRun& run : solved.lattice().layout.runs())
    for (std::uint32_t n = 0; n < run.count; ++n) {
      field.index[field.at({run.x, run.y, run.z + static_cast<int>(n)})] =
          static_cast<std::int32_t>(field.points.size());
      field.points.push_back(solved.at(run.first + n));
    }
  return field;
}

void writeLatticeField(const std::filesystem::path& file, const LatticeField& field) {
  const auto nodes = static_cast<vtkIdType>(field.index.size());
  const auto velocity = arrayOf(velocityName, 3, nodes), pressure = arrayOf(pressureName, 1, nodes);
  constexpr float outside = std::numeric_limits<float>::quiet_NaN();
  float *u = velocity->GetPointer(0), *p = pressure->GetPointer(0);
  forEachNode(field.frame.size, [&](const d3q19::Step& node) {
    const std::int32_t at = field.index[field.at(node)];
    for (int d = 0; d < 3; ++d)
      *u++ = at < 0 ? outside : static_cast<float>(field.points[static_cast<std::size_t>(at)].velocity[d]);
    *p++ = at < 0 ? outside : static_cast<float>(field.points[static_cast<std::size_t>(at)].pressure);
  });
  vtkNew<vtkImageData> image;
  image->SetDimensions(field.frame.size.data());
  const Vec3& origin = field.frame.origin;
  image->SetOrigin(origin.x(), origin.y(), origin.z());
  image->SetSpacing(field.frame.dx, field.frame.dx, field.frame.dx);
  image->GetPointData()->AddArray(velocity);
  image->GetPointData()->AddArray(pressure);
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(image);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToNone();
  writer->SetHeaderTypeToUInt64();
  writer->WriteToOutputStringOn();
  if (writer->Write() == 0) throw WriteFailed(fmt::format("cannot encode {}", file.string()));
  atomicWrite(file, writer->GetOutputString());
}

LatticeField readLatticeField(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) throw std::runtime_error("is not there");
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  auto* velocity = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray(velocityName));
  auto* pressure = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray(pressureName));
  if (velocity == nullptr || pressure == nullptr || velocity->GetNumberOfComponents() != 3)
    throw std::runtime_error(fmt::format("holds no {} and {}", velocityName, pressureName));
  LatticeFrame frame;
  frame.dx = image->GetSpacing()[0];
  frame.origin = Vec3(image->GetOrigin());
  image->GetDimensions(frame.size.data());
  LatticeField field = emptyField(frame);
  const float *u = velocity->GetPointer(0), *p = pressure->GetPointer(0);
  forEachNode(frame.size, [&](const d3q19::Step& node) {
    if (!std::isnan(*p)) {
      field.index[field.at(node)] = static_cast<std::int32_t>(field.points.size());
      field.points.push_back({Vec3(u[0], u[1], u[2]), *p});
    }
    u += 3;
    ++p;
  });
  return field;
}

}  // namespace restenosis
