#include "tissue/biology/ContactInhibitionLaw.h"

#include <array>

#include "tissue/biology/ExposureLaw.h"
#include "tissue/biology/NeighbourCountLaw.h"
#include "tissue/biology/StressLaw.h"
#include "tissue/parameters/NamedTable.h"

namespace restenosis {

namespace {

struct Entry {
  std::string_view name;
  std::unique_ptr<const ContactInhibitionLaw> (*make)(const ContactInhibitionParameters&);
};

template <class Law>
constexpr Entry entry{
    Law::name, [](const ContactInhibitionParameters& p) -> std::unique_ptr<const ContactInhibitionLaw> {
      return std::make_unique<Law>(p);
    }};

constexpr std::array laws{entry<ExposureLaw>, entry<NeighbourCountLaw>, entry<StressLaw>};

}  // namespace

std::vector<std::string_view> contactInhibitionLawNames() { return namesOf(laws); }

std::unique_ptr<const ContactInhibitionLaw> makeContactInhibitionLaw(
    const ContactInhibitionParameters& parameters) {
  return findNamed(laws, "law of contact inhibition", parameters.law).make(parameters);
}

}  // namespace restenosis
