#include "tissue/equilibrium/ActiveSet.h"

namespace restenosis {

void ActiveSet::reset(std::size_t agents) {
  for (const Index i : agents_) isActive_[i] = 0;
  if (size() < chunks_.capacity() * ActiveChunk::capacity / 4) chunks_ = {};
  isActive_.resize(agents, 0);
  resize(0);
}

std::size_t ActiveSet::placeOf(Index i) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(agents_, i) - agents_.begin());
}

void ActiveSet::resize(std::size_t count) {
  agents_.resize(count);
  chunks_.resize((count + ActiveChunk::capacity - 1) / ActiveChunk::capacity);
  for (ActiveChunk& chunk : chunks_) chunk.pairsCurrent = false;
}

void ActiveSet::copy(std::size_t to, std::size_t from) {
  agents_[to] = agents_[from];
  chunkOf(to).copy(inChunk(to), chunkOf(from), inChunk(from));
}

void ActiveSet::makePlaces(std::span<const Index> added) {
  for (const Index i : added) isActive_[i] = 1;
  // Merges two sorted lists from the back on, so that no agent is overwritten before it is copied
  std::size_t former = size(), next = added.size(), place = former + next;
  resize(place);
  while (next > 0) {
    --place;
    if (former > 0 && agents_[former - 1] > added[next - 1]) {
      copy(place, --former);
    } else {
      agents_[place] = added[--next];
    }
  }
}

void ActiveSet::keepOnly(std::span<const std::uint8_t> keep) {
  std::size_t kept = 0;
  for (std::size_t place = 0; place < size(); ++place) {
    if (!keep[place]) {
      isActive_[agents_[place]] = 0;
    } else {
      if (kept != place) copy(kept, place);
      ++kept;
    }
  }
  resize(kept);
  fillLastLanes();
}

void ActiveSet::fillLastLanes() {
  if (!empty()) chunks_.back().fillLanes(inChunk(size() - 1) + 1);
}

}  // namespace restenosis
