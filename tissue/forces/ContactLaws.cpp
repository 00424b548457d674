#include "tissue/forces/ContactLaws.h"

#include <array>

#include "tissue/forces/HertzContact.h"
#include "tissue/forces/HertzNeoHookeanContact.h"
#include "tissue/forces/PairForces.h"
#include "tissue/parameters/NamedTable.h"

namespace restenosis {
namespace {

template <class Law>
constexpr ContactLaw entry() {
  return {Law::name, &evaluatePairs<Law, FixedSpheres>, &evaluatePairs<Law, ExactSpheres>,
          [](double modulus, double d, double R) { return Law(modulus).energy(d, R); },
          [](double R) { return Law::validOverlap(R); }};
}

constexpr std::array contactLaws{entry<HertzContact>(), entry<HertzNeoHookeanContact>()};

}  // namespace

const ContactLaw& contactLaw(std::string_view name) { return findNamed(contactLaws, "contact law", name); }

std::vector<std::string_view> contactLawNames() { return namesOf(contactLaws); }

}  // namespace restenosis
