#include "Minimiser.h"

#include <array>

#include "FireMinimiser.h"
#include "NamedTable.h"
#include "OverdampedMinimiser.h"

namespace restenosis {
namespace {

struct Entry {
  std::string_view name;
  std::unique_ptr<Minimiser> (*make)(const MechanicsParameters&);
};

template <class T>
constexpr Entry entry() {
  return {T::name,
          [](const MechanicsParameters& p) -> std::unique_ptr<Minimiser> { return std::make_unique<T>(p); }};
}

constexpr std::array table{entry<FireMinimiser>(), entry<OverdampedMinimiser>()};

}  // namespace

std::unique_ptr<Minimiser> makeMinimiser(const MechanicsParameters& parameters) {
  return findNamed(table, "minimiser", parameters.minimiser).make(parameters);
}

std::vector<std::string_view> minimiserNames() { return namesOf(table); }

}  // namespace restenosis
