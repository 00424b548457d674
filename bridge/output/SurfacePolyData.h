#pragma once

#include <vtkNew.h>
#include <vtkPolyData.h>

#include <span>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// Some triangles of a surface, in the order given, and the vertices that they use, renumbered [m].
vtkNew<vtkPolyData> polyDataOf(const TriSurface& surface, std::span<const std::size_t> triangles);

}  // namespace restenosis
