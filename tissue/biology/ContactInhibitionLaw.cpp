#include "ContactInhibitionLaw.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

#include "ExposureLaw.h"
#include "NameList.h"
#include "NeighbourCountLaw.h"

namespace restenosis {

namespace {

template <class Law>
constexpr ContactInhibitionLawEntry entry{
    Law::name, [](const ContactInhibitionParameters& p) -> std::unique_ptr<const ContactInhibitionLaw> {
      return std::make_unique<Law>(p);
    }};

constexpr std::array laws{entry<ExposureLaw>, entry<NeighbourCountLaw>};

}  // namespace

std::span<const ContactInhibitionLawEntry> contactInhibitionLaws() { return laws; }

std::vector<std::string_view> contactInhibitionLawNames() {
  std::vector<std::string_view> names;
  for (const auto& law : laws) names.push_back(law.name);
  return names;
}

std::unique_ptr<const ContactInhibitionLaw> makeContactInhibitionLaw(
    const ContactInhibitionParameters& parameters) {
  for (const auto& law : laws) {
    if (law.name == parameters.law) return law.make(parameters);
  }
  throw std::invalid_argument(fmt::format("unknown law of contact inhibition \"{}\"; there are: {}",
                                          parameters.law, commaSeparated(contactInhibitionLawNames())));
}

}  // namespace restenosis
