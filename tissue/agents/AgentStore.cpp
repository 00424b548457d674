#include "tissue/agents/AgentStore.h"

#include <cassert>
#include <type_traits>
#include <utility>

#include "tissue/agents/Capacity.h"

namespace restenosis {

void AgentStore::reserve(Index agents) {
  forEachArray([agents](auto& values) { values.reserve(agents); });
}

Index AgentStore::append(AgentKind newKind, const Vec3& position, double newRadius) {
  const Index index = size();
  forEachArray([](auto& values) {
    growCapacity(values, values.size() + 1);
    values.emplace_back();
  });
  id[index] = nextId++;
  setPosition(index, position);
  radius[index] = newRadius;
  birthRadius[index] = newRadius;
  kind[index] = newKind;
  state[index] = CycleState::g0;
  return index;
}

void AgentStore::erase(std::span<const std::uint8_t> remove) {
  assert(remove.size() == size());
  forEachArray([&](auto& values) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < remove.size(); ++i) {
      if (!remove[i]) values[kept++] = values[i];
    }
    values.resize(kept);
  });
}

void AgentStore::reorder(std::span<const Index> order) {
  assert(order.size() == size());
  forEachArray([&](auto& values) {
    std::remove_reference_t<decltype(values)> ordered(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) ordered[k] = values[order[k]];
    values = std::move(ordered);
  });
}

}  // namespace restenosis
