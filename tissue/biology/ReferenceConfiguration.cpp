#include "tissue/biology/ReferenceConfiguration.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <unordered_map>
#include <utility>

#include "tissue/agents/Capacity.h"
#include "tissue/agents/Chunks.h"

namespace restenosis {

namespace {

// A move shorter than this times the radius is reported as one disturbed place, not two. Speed only.
constexpr double shortMove = 0.5;

// In an order of copies: the agent has none yet.
constexpr Index noCopy = std::numeric_limits<Index>::max();

}  // namespace

bool ReferenceConfiguration::inOrderOf(const AgentStore& agents) const {
  return size() <= agents.size() && std::equal(id_.begin(), id_.end(), agents.id.begin());
}

void ReferenceConfiguration::appendNew(AgentId id) {
  const auto append = [](auto& values, auto value) {
    growCapacity(values, values.size() + 1);
    values.push_back(value);
  };
  append(id_, id);
  for (auto* values : {&x_, &y_, &z_, &radius_}) append(*values, 0.0);
  append(kind_, AgentKind::smc);
  append(marks_, std::uint8_t{0});
}

void ReferenceConfiguration::copy(const AgentStore& agents, Index i) {
  x_[i] = agents.x[i], y_[i] = agents.y[i], z_[i] = agents.z[i];
  radius_[i] = agents.radius[i];
  kind_[i] = agents.kind[i];
}

bool ReferenceConfiguration::differs(const AgentStore& agents, Index i, double tolerance) const {
  const double allowed = tolerance * radius_[i];
  return radius_[i] == 0 || kind_[i] != agents.kind[i] ||
         !(std::abs(agents.radius[i] - radius_[i]) <= allowed) ||
         !((agents.position(i) - shapes().position(i)).squaredNorm() <= allowed * allowed);
}

void ReferenceConfiguration::permute(std::span<const Index> order) {
  const auto reorder = [order](auto& values) {
    std::remove_reference_t<decltype(values)> ordered(order.size());
    forEachInChunks(order.size(), [&](std::size_t k) {
      if (order[k] != noCopy) ordered[k] = values[order[k]];
    });
    values = std::move(ordered);
  };
  reorder(id_), reorder(x_), reorder(y_), reorder(z_), reorder(radius_), reorder(kind_), reorder(marks_);
}

void ReferenceConfiguration::reorder(std::span<const Index> order) {
  if (order.size() == size()) permute(order);
}

std::vector<DisturbedPlace> ReferenceConfiguration::reorderLike(const AgentStore& agents) {
  std::unordered_map<AgentId, Index> copyOf;
  copyOf.reserve(size());
  for (Index i = 0; i < size(); ++i) copyOf.emplace(id_[i], i);

  std::vector<Index> order(agents.size(), noCopy);
  for (Index i = 0; i < agents.size(); ++i) {
    const auto found = copyOf.find(agents.id[i]);
    if (found == copyOf.end()) continue;
    order[i] = found->second;
    copyOf.erase(found);
  }
  std::vector<Index> gone;
  for (const auto& [id, index] : copyOf) gone.push_back(index);
  std::ranges::sort(gone);
  std::vector<DisturbedPlace> left;
  for (const Index i : gone) left.push_back(placeOf(i));

  permute(order);
  id_ = agents.id;
  return left;
}

std::vector<DisturbedPlace> ReferenceConfiguration::follow(const AgentStore& agents, double tolerance) {
  std::vector<DisturbedPlace> places;
  if (!inOrderOf(agents)) places = reorderLike(agents);
  while (size() < agents.size()) appendNew(agents.id[size()]);
  for (const Index i : agentsThat(size(), [&](Index i) { return differs(agents, i, tolerance); })) {
    const bool isNew = radius_[i] == 0;
    const DisturbedPlace before = placeOf(i);
    copy(agents, i);
    const DisturbedPlace after = placeOf(i);
    const double apart = (after.centre - before.centre).norm();
    if (isNew) {
      places.push_back(after);
    } else if (apart < shortMove * before.radius) {
      places.push_back(
          {(before.centre + after.centre) / 2, std::max(before.radius, after.radius) + apart / 2});
    } else {
      places.push_back(before);
      places.push_back(after);
    }
  }
  return places;
}

}  // namespace restenosis
