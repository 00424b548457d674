#pragma once

#include "tissue/forces/ContactLaws.h"
#include "tissue/forces/PairKernel.h"
#include "tissue/forces/PlainPairKernel.h"

namespace restenosis {

/// The entry of a contact law in the table: a class with the members that HertzContact has.
template <class Law>
constexpr ContactLaw contactLawOf() {
  return {Law::name,
          &evaluatePairs<Law, FixedSpheres>,
          &evaluatePairs<Law, ExactSpheres>,
          &plainLoad<Law>,
          [](double modulus, double d, double R) { return Law(modulus).energy(d, R); },
          [](double R) { return Law::validOverlap(R); }};
}

}  // namespace restenosis
