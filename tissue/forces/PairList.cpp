#include "tissue/forces/PairList.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tissue/agents/Capacity.h"

namespace restenosis {
namespace {

// Lists of this length and beyond are sorted as equal.
constexpr std::uint32_t longestSorted = 63;
// The lists of an agent are fetched so many agents before they are read.
constexpr std::size_t agentsAhead = 8;
// Entries of a slice beyond its longest list, for lists that get longer.
constexpr std::uint32_t spareEntries = 2;

/// The numbers 0 to keys.size() - 1 by their keys; those of equal keys in ascending order.
void sortByKey(std::span<const std::uint8_t> keys, std::span<std::uint8_t> order) {
  std::array<std::uint16_t, longestSorted + 2> start{};
  for (const std::uint8_t key : keys) ++start[key + 1U];
  for (std::size_t n = 1; n < start.size(); ++n) start[n] += start[n - 1];
  for (std::size_t k = 0; k < keys.size(); ++k) order[start[keys[k]]++] = static_cast<std::uint8_t>(k);
}

}  // namespace

void PairList::Attractions::add(float restLength) {
  bonds |= std::isfinite(restLength);
  cohesion |= std::signbit(restLength);
}

void PairList::build(const PairSource& source, std::span<const Index> agents, Index none) {
  assert(agents.size() <= capacity);
  size_ = agents.size();
  none_ = none;
  thread_local std::vector<Pair> pairs;
  pairs.clear();
  std::array<std::uint32_t, capacity + 1> startOfAgent;
  std::array<std::uint8_t, capacity> key;
  for (std::size_t k = 0; k < size_; ++k) {
    if (k + agentsAhead < size_) source.prefetch(agents[k + agentsAhead]);
    startOfAgent[k] = static_cast<std::uint32_t>(pairs.size());
    source.append(agents[k], pairs);
    const auto length = static_cast<std::uint32_t>(pairs.size()) - startOfAgent[k];
    key[k] = static_cast<std::uint8_t>(std::min(length, longestSorted));
  }
  startOfAgent[size_] = static_cast<std::uint32_t>(pairs.size());
  sortByKey(std::span(key).first(size_), order_);

  const auto listOf = [&](std::size_t n) {
    if (n >= size_) return std::span<const Pair>();
    const std::uint32_t begin = startOfAgent[order_[n]], end = startOfAgent[order_[n] + std::size_t{1}];
    return std::span<const Pair>(pairs).subspan(begin, end - begin);
  };
  std::uint32_t end = 0;
  for (std::size_t s = 0; s < slices(); ++s) {
    std::size_t longest = 0;
    for (std::size_t lane = 0; lane < width; ++lane)
      longest = std::max(longest, listOf(s * width + lane).size());
    const auto length = static_cast<std::uint32_t>(longest);
    slices_[s] = {.start = end, .length = length, .capacity = length + spareEntries, .attractions = {}};
    end += slices_[s].capacity;
  }
  if (end > entries_.capacity()) entries_ = {};  // what it holds need not be copied
  growCapacity(entries_, end);
  entries_.resize(end);
  for (std::size_t s = 0; s < slices(); ++s) {
    std::array<std::span<const Pair>, width> lists;
    for (std::size_t lane = 0; lane < width; ++lane) lists[lane] = listOf(s * width + lane);
    for (std::size_t m = 0; m < slices_[s].capacity; ++m) {
      Entry& entry = entries_[slices_[s].start + m];
      for (std::size_t lane = 0; lane < width; ++lane) {
        const Pair pair = m < lists[lane].size() ? lists[lane][m] : Pair{none, Pair::unbonded};
        entry.partner[lane] = pair.partner;
        entry.restLength[lane] = pair.restLength;
        slices_[s].attractions.add(pair.restLength);
      }
    }
  }
}

bool PairList::replace(const PairSource& source, std::size_t k, Index i) {
  const auto n = static_cast<std::size_t>(std::ranges::find(order_, k) - order_.begin());
  Slice& slice = slices_[n / width];
  thread_local std::vector<Pair> pairs;
  pairs.clear();
  source.append(i, pairs);
  if (pairs.size() > slice.capacity) return false;
  slice.length = std::max(slice.length, static_cast<std::uint32_t>(pairs.size()));
  pairs.resize(slice.capacity, {none_, Pair::unbonded});
  for (std::size_t m = 0; m < pairs.size(); ++m) {
    Entry& entry = entries_[slice.start + m];
    entry.partner[n % width] = pairs[m].partner;
    entry.restLength[n % width] = pairs[m].restLength;
    slice.attractions.add(pairs[m].restLength);
  }
  return true;
}

}  // namespace restenosis
