#include "tissue/equilibrium/ActiveSet.h"

namespace restenosis {

void ActiveSet::reset(std::size_t agents) {
  for (const Index i : agents_) isActive_[i] = 0;
  if (size() < chunks_.capacity() * ActiveChunk::capacity / 4) chunks_ = {};
  isActive_.resize(agents, 0);
  place_.resize(agents, 0);
  resize(0);
}

void ActiveSet::resize(std::size_t count) {
  agents_.resize(count);
  const std::size_t before = chunks_.size();
  chunks_.resize((count + ActiveChunk::capacity - 1) / ActiveChunk::capacity);
  for (std::size_t c = before; c < chunks_.size(); ++c) chunks_[c].pairsCurrent = false;
}

void ActiveSet::append(std::span<const Index> added) {
  if (!empty()) chunks_.back().pairsCurrent = false;
  const std::size_t first = size();
  resize(first + added.size());
  for (std::size_t k = 0; k < added.size(); ++k) {
    agents_[first + k] = added[k];
    isActive_[added[k]] = 1;
    place_[added[k]] = static_cast<Index>(first + k);
  }
}

void ActiveSet::keepOnly(std::span<const std::uint8_t> keep) {
  std::size_t kept = 0;
  for (std::size_t place = 0; place < size(); ++place) {
    const Index i = agents_[place];
    if (!keep[place]) {
      isActive_[i] = 0;
      chunkOf(place).pairsCurrent = false;
      continue;
    }
    if (kept != place) {
      agents_[kept] = i;
      place_[i] = static_cast<Index>(kept);
      chunkOf(kept).copy(inChunk(kept), chunkOf(place), inChunk(place));
      chunkOf(kept).pairsCurrent = false;
    }
    ++kept;
  }
  resize(kept);
  fillLastLanes();
}

void ActiveSet::fillLastLanes() {
  if (!empty()) chunks_.back().fillLanes(inChunk(size() - 1) + 1);
}

}  // namespace restenosis
