#pragma once

#include <optional>

#include "tissue/stent/Stent.h"

namespace restenosis {

/// A stretch of the vessel along z [m].
struct Section {
  double from, to;
};

/// Where neointima is measured: between the centrelines of the outermost struts and 2.5 widths of the widest
/// one to either side (assumed), for the tissue beside them belongs to them; without a stent all of the
/// vessel, of this length [m].
Section stentedSection(const std::optional<Stent>& stent, double length);

/// Where histology is measured: between the centrelines of the outermost struts, for pathologists cut through
/// the stent. Of a stent that is shorter than both margins of stentedSection, as a single ring is, it is that
/// section.
Section histologySection(const std::optional<Stent>& stent, double length);

}  // namespace restenosis
