#pragma once

#include <vtkDataSetAttributes.h>
#include <vtkNew.h>

#include <filesystem>
#include <string>

class vtkPolyData;

namespace restenosis {

/// Writes a .vtp file, binary and compressed, atomically. `time` [s] goes in as TimeValue, in days.
/// Throws WriteFailed. Leave the cells in VTK's default 64-bit storage: read back from 32-bit storage they
/// crash VTK 9.1's cell-to-point filter.
void writePolyData(const std::filesystem::path& file, vtkPolyData* data, double time);

/// Adds an array of n scalars, or of n vectors when `components` is 3: component c of entry i is get(i, c).
template <class ArrayType, class Get>
void addArray(vtkDataSetAttributes* attributes, const char* name, std::size_t n, int components, Get&& get) {
  vtkNew<ArrayType> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(n));
  auto* out = array->GetPointer(0);
  for (std::size_t i = 0; i < n; ++i)
    for (int c = 0; c < components; ++c) *out++ = static_cast<typename ArrayType::ValueType>(get(i, c));
  attributes->AddArray(array);
}

}  // namespace restenosis
