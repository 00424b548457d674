#include "tissue/forces/PairList.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "tissue/agents/Capacity.h"

namespace restenosis {
namespace {

// Lists of this length and beyond are sorted as equal.
constexpr std::uint32_t longestSorted = 63;

/// The numbers 0 to keys.size() - 1 by their keys; those of equal keys in ascending order.
void sortByKey(std::span<const std::uint8_t> keys, std::span<std::uint8_t> order) {
  std::array<std::uint16_t, longestSorted + 2> start{};
  for (const std::uint8_t key : keys) ++start[key + 1U];
  for (std::size_t n = 1; n < start.size(); ++n) start[n] += start[n - 1];
  for (std::size_t k = 0; k < keys.size(); ++k) order[start[keys[k]]++] = static_cast<std::uint8_t>(k);
}

}  // namespace

void PairList::build(const PairSource& source, std::span<const Index> agents, Index none) {
  assert(agents.size() <= capacity);
  size_ = agents.size();
  thread_local std::vector<Pair> pairs;
  pairs.clear();
  std::array<std::uint32_t, capacity + 1> startOfAgent;
  std::array<std::uint8_t, capacity> key;
  for (std::size_t k = 0; k < size_; ++k) {
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
  for (std::size_t slice = 0; slice < slices(); ++slice) {
    std::size_t longest = 0;
    for (std::size_t lane = 0; lane < width; ++lane)
      longest = std::max(longest, listOf(slice * width + lane).size());
    start_[slice + 1] = start_[slice] + static_cast<std::uint32_t>(longest);
  }
  const std::size_t end = start_[slices()];
  if (end > entries_.capacity()) entries_ = {};  // what it holds need not be copied
  growCapacity(entries_, end);
  entries_.resize(end);
  for (std::size_t n = 0; n < slices() * width; ++n) {
    const std::size_t slice = n / width, lane = n % width;
    const auto list = listOf(n);
    const auto column = std::span(entries_).subspan(start_[slice], start_[slice + 1] - start_[slice]);
    for (std::size_t m = 0; m < column.size(); ++m) {
      const Pair pair = m < list.size() ? list[m] : Pair{none, std::numeric_limits<float>::infinity()};
      column[m].partner[lane] = pair.partner;
      column[m].restLength[lane] = pair.restLength;
    }
  }
}

}  // namespace restenosis
