#pragma once

#include "tissue/biology/ContactInhibitionLaw.h"

namespace restenosis {

/// A cell is inhibited if the weighted number of neighbours within `countRange` (R1 + R2) exceeds
/// `countThreshold` (T6, ISR3D). A threshold holds for one packing at one compression (model 6).
class NeighbourCountLaw : public ContactInhibitionLaw {
 public:
  static constexpr std::string_view name = "neighbourCount";

  explicit NeighbourCountLaw(const ContactInhibitionParameters& parameters) : p_(parameters) {}

  double range() const override { return p_.countRange; }
  bool inhibits(const Surroundings& surroundings) const override;

 private:
  ContactInhibitionParameters p_;
};

}  // namespace restenosis
