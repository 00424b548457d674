#include "tissue/forces/PairRows.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "tissue/agents/Room.h"

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

/// Makes the vector so long; what it holds need not be kept.
template <class T>
void resizeAnew(std::vector<T>& values, std::size_t size) {
  if (size > values.capacity()) values = {};
  makeRoom(values, size);
  values.resize(size);
}

}  // namespace

void PairRows::layOut(const PairSource& source, std::span<const Index> agents, Index nobody) {
  assert(agents.size() <= most);
  size_ = agents.size();
  nobody_ = nobody;

  struct Row {
    Kind kind;
    std::uint32_t length, start;  // in `pairs`, but for marked rows in groups of these
  };
  source.readAhead(agents);
  thread_local std::vector<ActingPair> pairs;
  pairs.clear();
  std::array<Row, most> rows;
  std::array<std::uint8_t, most> key;
  for (std::size_t k = 0; k < size_; ++k) {
    Row& row = rows[k];
    row.start = static_cast<std::uint32_t>(pairs.size());
    if (source.allMarked(agents[k])) {
      row.kind = Kind::marked;
      row.length = static_cast<std::uint32_t>(source.neighbours.of(agents[k]).size());
    } else {
      row.kind = source.append(agents[k], pairs) ? Kind::mixed : Kind::unmarked;
      row.length = static_cast<std::uint32_t>(pairs.size()) - row.start;
    }
    const std::uint32_t length = std::min(row.length, lengths - 1);
    key[k] = static_cast<std::uint8_t>(length + lengths * static_cast<std::uint32_t>(row.kind));
  }
  sortByKey<3 * lengths>(std::span(key).first(size_), order_);

  std::uint32_t end = 0, endOfRests = 0;
  for (std::size_t g = 0; g < groups(); ++g) {
    const std::size_t last = std::min(size_, (g + 1) * width) - 1;
    std::uint32_t longest = 0;
    for (std::size_t n = g * width; n <= last; ++n) longest = std::max(longest, rows[order_[n]].length);
    const Kind first = rows[order_[g * width]].kind;
    const Kind kind = first == rows[order_[last]].kind ? first : Kind::mixed;
    if (kind == Kind::mixed) {
      for (std::size_t n = g * width; n <= last; ++n) {
        Row& row = rows[order_[n]];
        if (row.kind != Kind::marked) continue;
        row.start = static_cast<std::uint32_t>(pairs.size());
        source.append(agents[order_[n]], pairs);
      }
    }
    groups_[g] = {
        .start = end, .restStart = endOfRests, .length = longest, .room = longest + spareLines, .kind = kind};
    end += groups_[g].room;
    if (kind != Kind::marked) endOfRests += groups_[g].room;
  }
  resizeAnew(partners_, end);
  resizeAnew(rests_, endOfRests);
  for (std::size_t n = 0; n < groups() * width; ++n) {
    const Group& group = groups_[n / width];
    const std::size_t lane = n % width;
    const bool free = n >= size_;
    if (group.kind == Kind::marked) {
      put(group, lane, free ? std::span<const Index>() : source.neighbours.of(agents[order_[n]]));
    } else {
      const Row row = free ? Row{} : rows[order_[n]];
      put(group, lane, std::span<const ActingPair>(pairs).subspan(row.start, row.length));
    }
  }
}

bool PairRows::replace(const PairSource& source, std::size_t k, Index i) {
  const auto place = static_cast<std::size_t>(std::ranges::find(order_, k) - order_.begin());
  Group& group = groups_[place / width];
  const auto putIfRoom = [&](const auto& row) {
    if (row.size() > group.room) return false;
    group.length = std::max(group.length, static_cast<std::uint32_t>(row.size()));
    put(group, place % width, row);
    return true;
  };
  if (group.kind == Kind::marked) {
    // Who is a daughter remains one, and bonds do not change while agents move.
    assert(source.allMarked(i));
    return putIfRoom(source.neighbours.of(i));
  }
  thread_local std::vector<ActingPair> row;
  row.clear();
  const bool marked = source.append(i, row);
  if (!putIfRoom(row)) return false;
  if (marked) group.kind = Kind::mixed;
  return true;
}

void PairRows::put(const Group& group, std::size_t lane, std::span<const ActingPair> row) {
  const auto partners = std::span(partners_).subspan(group.start, group.room);
  const auto rests = std::span(rests_).subspan(group.restStart, group.room);
  for (std::size_t n = 0; n < group.room; ++n) {
    const bool is = n < row.size();
    partners[n].agent[lane] = is ? row[n].partner : nobody_;
    rests[n].length[lane] = is ? row[n].rest : std::numeric_limits<float>::infinity();
  }
}

void PairRows::put(const Group& group, std::size_t lane, std::span<const Index> markedRow) {
  const auto partners = std::span(partners_).subspan(group.start, group.room);
  for (std::size_t n = 0; n < markedRow.size(); ++n) partners[n].agent[lane] = markedRow[n];
  for (std::size_t n = markedRow.size(); n < group.room; ++n) partners[n].agent[lane] = nobody_;
}

}  // namespace restenosis
