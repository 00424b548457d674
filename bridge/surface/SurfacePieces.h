#pragma once

#include <cstdint>
#include <vector>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// Makes triangles that meet run along their edge in opposite directions, in each piece starting from its
/// first. Returns the piece that each triangle belongs to, counted from 0: what no edge joins is another. A
/// piece with only one side, like a Moebius strip, keeps edges that are `opposed`.
std::vector<std::uint32_t> orientPieces(TriSurface& surface);

}  // namespace restenosis
