#include "ReferenceConfiguration.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace restenosis {

namespace {

// An agent that has moved by less than this times its radius has changed one place, not two. Speed only.
constexpr double shortMove = 0.5;

}  // namespace

bool ReferenceConfiguration::inOrderOf(const AgentStore& agents) const {
  return copies_.size() <= agents.size() &&
         std::equal(copies_.id.begin(), copies_.id.end(), agents.id.begin());
}

std::vector<DisturbedPlace> ReferenceConfiguration::reorderLike(const AgentStore& agents) {
  std::unordered_map<AgentId, Index> copyOf;
  copyOf.reserve(copies_.size());
  for (Index i = 0; i < copies_.size(); ++i) copyOf.emplace(copies_.id[i], i);

  // Copies in the order of their agents first, then those whose agents are gone, which are cut off.
  std::vector<Index> order;
  order.reserve(copies_.size());
  for (Index i = 0; i < agents.size(); ++i) {
    const auto found = copyOf.find(agents.id[i]);
    if (found == copyOf.end()) {
      // Stands in until follow() copies the agent; a radius of none differs from every agent's.
      const Index stand = copies_.append(agents.kind[i], agents.position(i), 0.0);
      copies_.id[stand] = agents.id[i];
      marks_.push_back(0);
      order.push_back(stand);
    } else {
      order.push_back(found->second);
      copyOf.erase(found);
    }
  }
  std::vector<Index> gone;
  for (const auto& [id, index] : copyOf) gone.push_back(index);
  std::ranges::sort(gone);
  std::vector<DisturbedPlace> left;
  for (const Index i : gone) left.push_back(placeOf(i));

  order.insert(order.end(), gone.begin(), gone.end());
  copies_.reorder(order);
  const auto oldMarks = marks_;
  for (std::size_t k = 0; k < order.size(); ++k) marks_[k] = oldMarks[order[k]];
  std::vector<std::uint8_t> remove(copies_.size(), 0);
  std::fill(remove.begin() + agents.size(), remove.end(), std::uint8_t{1});
  copies_.erase(remove);
  marks_.resize(agents.size());
  return left;
}

std::vector<DisturbedPlace> ReferenceConfiguration::follow(const AgentStore& agents, double tolerance) {
  std::vector<DisturbedPlace> places;
  if (!inOrderOf(agents)) places = reorderLike(agents);
  for (Index i = 0; i < agents.size(); ++i) {
    if (i == copies_.size()) {
      copies_.append(agents.kind[i], agents.position(i), 0.0);
      copies_.id[i] = agents.id[i];
      marks_.push_back(0);
    }
    const double reference = copies_.radius[i];
    const double allowed = tolerance * reference;
    const bool isNew = reference == 0;
    if (!isNew && copies_.kind[i] == agents.kind[i] && std::abs(agents.radius[i] - reference) <= allowed &&
        (agents.position(i) - copies_.position(i)).squaredNorm() <= allowed * allowed) {
      continue;
    }
    const DisturbedPlace before = placeOf(i);
    copies_.setPosition(i, agents.position(i));
    copies_.radius[i] = agents.radius[i];
    copies_.kind[i] = agents.kind[i];
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
