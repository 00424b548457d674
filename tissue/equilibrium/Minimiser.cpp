#include "tissue/equilibrium/Minimiser.h"

#include <array>

#include "tissue/equilibrium/FireMinimiser.h"
#include "tissue/equilibrium/OverdampedMinimiser.h"
#include "tissue/parameters/NamedTable.h"

namespace restenosis {
namespace {

struct MakesMinimiser {
  std::string_view name;
  std::unique_ptr<Minimiser> (*make)(const RelaxationParameters&);
};

template <class T>
constexpr MakesMinimiser maker() {
  return {T::name,
          [](const RelaxationParameters& p) -> std::unique_ptr<Minimiser> { return std::make_unique<T>(p); }};
}

constexpr std::array minimisers{maker<FireMinimiser>(), maker<OverdampedMinimiser>()};

}  // namespace

std::unique_ptr<Minimiser> makeMinimiser(const RelaxationParameters& parameters) {
  return findNamed(minimisers, "minimiser", parameters.minimiser).make(parameters);
}

std::vector<std::string_view> minimiserNames() { return namesOf(minimisers); }

}  // namespace restenosis
