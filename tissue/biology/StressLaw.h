#pragma once

#include "tissue/biology/ContactInhibitionLaw.h"

namespace restenosis {

/// A cell is inhibited while its structural stress, compression positive, is above `stressThreshold` (Montel
/// 2011, Delarue 2014: pressure arrests cells late in G1, and the arrest ends with it).
class StressLaw : public ContactInhibitionLaw {
 public:
  static constexpr std::string_view name = "stress";

  explicit StressLaw(const ContactInhibitionParameters& parameters)
      : threshold_(parameters.stressThreshold) {}

  double range() const override { return 0; }
  bool readsStress() const override { return true; }
  bool inhibits(const Surroundings& surroundings) const override { return surroundings.stress > threshold_; }

 private:
  double threshold_;  ///< [Pa]
};

}  // namespace restenosis
