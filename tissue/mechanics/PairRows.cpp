#include "PairRows.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "Room.h"

namespace restenosis {
namespace {

// So many lengths of rows are told apart; the last stands for all beyond it.
constexpr std::uint32_t lengths = 64;
// Lines that a group has beyond its longest row, for rows that get longer.
constexpr std::uint32_t spareLines = 2;

/// The places 0 to keys.size() - 1 by their keys, places of equal keys in ascending order.
template <std::size_t keyCount>
void sortByKey(std::span<const std::uint8_t> keys, std::span<std::uint8_t> order) {
  std::array<std::uint16_t, keyCount + 1> start{};
  for (const std::uint8_t key : keys) ++start[key + 1U];
  for (std::size_t n = 1; n < start.size(); ++n) start[n] += start[n - 1];
  for (std::size_t k = 0; k < keys.size(); ++k) order[start[keys[k]]++] = static_cast<std::uint8_t>(k);
}

}  // namespace

void PairRows::layOut(const PairSource& source, std::span<const Index> agents, Index nobody) {
  assert(agents.size() <= most);
  size_ = agents.size();
  nobody_ = nobody;

  thread_local std::vector<ActingPair> pairs;
  pairs.clear();
  std::array<std::size_t, most + 1> start{};
  std::array<std::uint8_t, most> key;
  for (std::size_t k = 0; k < size_; ++k) {
    const bool marked = source.append(agents[k], pairs);
    start[k + 1] = pairs.size();
    const auto length = std::min<std::size_t>(start[k + 1] - start[k], lengths - 1);
    key[k] = static_cast<std::uint8_t>(length + (marked ? lengths : 0));
  }
  sortByKey<2 * lengths>(std::span(key).first(size_), order_);

  std::uint32_t end = 0;
  for (std::size_t g = 0; g < groups(); ++g) {
    std::size_t longest = 0;
    bool marked = false;
    for (std::size_t n = g * width; n < std::min(size_, (g + 1) * width); ++n) {
      const std::size_t k = order_[n];
      longest = std::max(longest, start[k + 1] - start[k]);
      marked |= key[k] >= lengths;
    }
    const auto length = static_cast<std::uint32_t>(longest);
    groups_[g] = {.start = end, .length = length, .room = length + spareLines, .marked = marked};
    end += groups_[g].room;
  }
  if (end > lines_.capacity()) lines_ = {};  // what it holds need not be copied
  makeRoom(lines_, end);
  lines_.resize(end);
  for (std::size_t n = 0; n < groups() * width; ++n) {
    std::span<const ActingPair> row;
    if (n < size_) row = std::span(pairs).subspan(start[order_[n]], start[order_[n] + 1U] - start[order_[n]]);
    put(groups_[n / width], n % width, row);
  }
}

bool PairRows::replace(const PairSource& source, std::size_t k, Index i) {
  thread_local std::vector<ActingPair> row;
  row.clear();
  const bool marked = source.append(i, row);
  const auto place = static_cast<std::size_t>(std::ranges::find(order_, k) - order_.begin());
  Group& group = groups_[place / width];
  if (row.size() > group.room) return false;
  group.length = std::max(group.length, static_cast<std::uint32_t>(row.size()));
  group.marked |= marked;
  put(group, place % width, row);
  return true;
}

void PairRows::put(const Group& group, std::size_t lane, std::span<const ActingPair> row) {
  const auto lines = std::span(lines_).subspan(group.start, group.room);
  for (std::size_t n = 0; n < lines.size(); ++n) {
    const bool is = n < row.size();
    lines[n].partner[lane] = is ? row[n].partner : nobody_;
    lines[n].rest[lane] = is ? row[n].rest : std::numeric_limits<float>::infinity();
  }
}

}  // namespace restenosis
