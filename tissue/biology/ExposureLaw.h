#pragma once

#include "tissue/biology/ContactInhibitionLaw.h"

namespace restenosis {

/// A cell is inhibited unless it is exposed: unless more than `exposureThreshold` of the directions around it
/// are free of neighbours (ExposureMeasure). Assumed; unlike a count it distinguishes a bare surface from the
/// interior in a compressed wall as well as in one at rest.
class ExposureLaw : public ContactInhibitionLaw {
 public:
  static constexpr std::string_view name = "exposure";

  explicit ExposureLaw(const ContactInhibitionParameters&) {}

  double range() const override { return 0; }  // the measure has its own
  bool inhibits(const Surroundings& surroundings) const override { return !surroundings.exposed; }
};

}  // namespace restenosis
