#include "tissue/forces/ContactLaws.h"

#include <array>

#include "tissue/forces/ContactLawOf.h"
#include "tissue/forces/HertzContact.h"
#include "tissue/forces/HertzNeoHookeanContact.h"
#include "tissue/parameters/NamedTable.h"

namespace restenosis {
namespace {

constexpr std::array contactLaws{contactLawOf<HertzContact>(), contactLawOf<HertzNeoHookeanContact>()};

}  // namespace

const ContactLaw& contactLaw(std::string_view name) { return findNamed(contactLaws, "contact law", name); }

std::vector<std::string_view> contactLawNames() { return namesOf(contactLaws); }

}  // namespace restenosis
