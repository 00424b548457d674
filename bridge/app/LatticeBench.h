#pragma once

#include <iosfwd>

namespace restenosis {

/// Measures lattice Boltzmann steps in a cylinder of 300 x 130 x 130 nodes with interpolated walls, in both
/// precisions, for one thread and for all, beside the rate at which the machine can update 19 arrays in
/// place. Prints a table.
void benchLattice(std::ostream& out);

}  // namespace restenosis
