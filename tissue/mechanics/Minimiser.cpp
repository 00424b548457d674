#include "Minimiser.h"

#include <array>

#include "FireMinimiser.h"
#include "NamedTable.h"
#include "OverdampedMinimiser.h"

namespace restenosis {
namespace {

struct MakesMinimiser {
  std::string_view name;
  std::unique_ptr<Minimiser> (*make)(const MechanicsParameters&);
};

template <class T>
constexpr MakesMinimiser maker() {
  return {T::name,
          [](const MechanicsParameters& p) -> std::unique_ptr<Minimiser> { return std::make_unique<T>(p); }};
}

constexpr std::array minimisers{maker<FireMinimiser>(), maker<OverdampedMinimiser>()};

}  // namespace

std::unique_ptr<Minimiser> makeMinimiser(const MechanicsParameters& parameters) {
  return findNamed(minimisers, "minimiser", parameters.minimiser).make(parameters);
}

std::vector<std::string_view> minimiserNames() { return namesOf(minimisers); }

}  // namespace restenosis
