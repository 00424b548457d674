#pragma once

#include <string>

#include "bridge/flow/TubeFlow.h"

namespace restenosis {

/// The velocity of developed flow in a circular tube, in OpenFOAM's expressions: a polynomial of w = 1 -
/// (r/R)^2, which is Poiseuille's profile over its peak; any factor is left out. It is fitted by least
/// squares over the section, to a per mille of the mean velocity.
std::string thinningProfile(const TubeFlow& flow, double radius);

}  // namespace restenosis
