#pragma once

#include "bridge/surface/BandField.h"
#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// Evens out the triangles of the isosurface 0 of a field without changing its shape: `passes` times every
/// vertex moves half way to the mean of its neighbours and back onto the isosurface. Vertices of a cap stay
/// in its plane, those on a rim follow their neighbours on the rim. A pass in which a triangle would turn
/// over or degenerate is undone around that triangle.
void relaxSurface(TriSurface& surface, const BandField& field, int passes);

}  // namespace restenosis
