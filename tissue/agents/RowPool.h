#pragma once

#include <algorithm>
#include <cassert>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "tissue/agents/PlainArray.h"
#include "tissue/agents/ReadAhead.h"
#include "tissue/agents/Capacity.h"

namespace restenosis {

/// Rows of elements, short and of many lengths, in one array. A row that outgrows its room moves to the end
/// of the array, and what it leaves is abandoned until the rows are moved together.
template <class T>
class RowPool {
 public:
  static constexpr std::uint32_t mostSpare = 255;  ///< elements for which a row may have room beyond its own

  std::size_t size() const { return rows_.size(); }
  bool empty() const { return rows_.empty(); }
  std::span<const T> operator[](std::size_t row) const {
    return {elements_.data() + rows_[row].start, rows_[row].count};
  }
  std::span<T> operator[](std::size_t row) { return {elements_.data() + rows_[row].start, rows_[row].count}; }
  /// Brings into the cache where a row is; its first and last element.
  void readRoomAhead(std::size_t row) const { restenosis::readAhead(&rows_[row]); }
  void readAhead(std::size_t row) const {
    const std::span<const T> elements = (*this)[row];
    if (elements.empty()) return;
    restenosis::readAhead(&elements.front());
    restenosis::readAhead(&elements.back());
  }
  /// The same for many rows, which wait together.
  void readAhead(std::span<const std::uint32_t> rows) const {
    for (const std::uint32_t row : rows) readRoomAhead(row);
    for (const std::uint32_t row : rows) readAhead(row);
  }
  /// How many elements all rows have.
  std::size_t elementCount() const {
    std::size_t elements = 0;
    for (const Row& row : rows_) elements += row.count;
    return elements;
  }

  /// Appends empty rows, or drops the last, until there are so many.
  void resize(std::size_t rows) {
    growCapacity(rows_, rows);
    rows_.resize(rows);
  }
  /// Makes the pool one of so many rows side by side, the k-th of countOf(k) elements that are yet to be set,
  /// each with room for `spare` more if it has any. Throws std::length_error as append() does.
  template <class CountOf>
  void layOut(std::size_t rows, const CountOf& countOf, std::uint32_t spare = 0) {
    layOut(rows, countOf, [&](std::size_t k) { return countOf(k) > 0 ? spare : 0U; });
  }
  /// The same with room for spareOf(k) more elements, at most mostSpare.
  template <class CountOf, class SpareOf>
  requires std::invocable<SpareOf, std::size_t>
  void layOut(std::size_t rows, const CountOf& countOf, const SpareOf& spareOf) {
    rows_.clear();
    resize(rows);
    abandoned_ = 0;
    std::size_t end = 0;
    for (std::size_t k = 0; k < rows; ++k) {
      const std::size_t count = countOf(k);
      rows_[k] = rowAt(end, count, spareOf(k));
      end += rows_[k].room();
    }
    elements_ = {};  // what it holds need not be copied
    growCapacity(elements_, end);
    elements_.resize(end);
    for (const Row& row : rows_) clearSpare(row);
  }
  /// Makes room for so many rows, which have so many elements together.
  void reserve(std::size_t rows, std::size_t elements) {
    rows_.reserve(rows);
    elements_.reserve(elements);
  }
  /// Appends a row of these elements, without room for more. Throws as append() does.
  void addRow(std::span<const T> elements) {
    resize(size() + 1);
    move(size() - 1, elements.size(), 0);
    std::ranges::copy(elements, (*this)[size() - 1].begin());
  }
  /// Moves the rows together, each with room for `spare` more elements if it has any.
  void compact(std::uint32_t spare = 0) {
    spread([&](std::size_t k) { return rows_[k].count > 0 ? spare : 0U; });
  }
  /// Moves the rows, the k-th getting room for moreOf(k) more elements, at most mostSpare.
  template <class MoreOf>
  void spread(const MoreOf& moreOf) {
    RowPool moved;
    moved.layOut(
        size(), [this](std::size_t k) { return rows_[k].count; }, moreOf);
    for (std::size_t k = 0; k < size(); ++k) std::ranges::copy(std::as_const(*this)[k], moved[k].begin());
    *this = std::move(moved);
  }
  /// Whether much of the array is abandoned, so that moving the rows together pays.
  bool wasteful() const { return 4 * abandoned_ > elements_.size(); }

  /// Replaces a row by elements that are not in the pool; where there is no room for them, it gets room for
  /// `spare` more, at most mostSpare.
  void set(std::size_t row, std::span<const T> elements, std::uint32_t spare) {
    if (elements.size() > rows_[row].room()) {
      move(row, elements.size(), spare);
    } else {
      resizeInPlace(rows_[row], elements.size());
    }
    std::ranges::copy(elements, (*this)[row].begin());
  }
  /// The same where there is room for them and they leave no more than a row may have to spare; else nothing
  /// is done and false returned. For several threads, each row by one.
  bool setInPlace(std::size_t row, std::span<const T> elements) {
    Row& place = rows_[row];
    const std::size_t room = place.room();
    if (elements.size() > room || room - elements.size() > mostSpare) return false;
    place.count = static_cast<std::uint32_t>(elements.size());
    place.spare = static_cast<std::uint32_t>(room - elements.size());
    std::ranges::copy(elements, (*this)[row].begin());
    return true;
  }
  /// Appends an element to a row; where there is no room for it, the row gets room for `spare` more. Throws
  /// std::length_error for more elements than rows can tell apart.
  void append(std::size_t row, T element, std::uint32_t spare) {
    const Row before = rows_[row];
    if (before.spare > 0) {
      resizeInPlace(rows_[row], before.count + 1);
    } else {
      move(row, before.count + 1, spare);
      std::copy_n(elements_.begin() + before.start, before.count, elements_.begin() + rows_[row].start);
    }
    (*this)[row].back() = element;
  }
  /// Drops the last elements of a row, until `count` are left.
  void shorten(std::size_t row, std::size_t count) {
    assert(count <= rows_[row].count);
    resizeInPlace(rows_[row], count);
  }

  template <class Archive>
  void archive(Archive& a) {
    a(elements_, rows_);
  }

 private:
  /// Where a row's elements are, and for how many more there is room.
  struct Row {
    std::uint32_t start = 0;
    std::uint32_t count : 24 = 0, spare : 8 = 0;
    std::uint32_t room() const { return count + spare; }
  };
  static constexpr std::size_t mostElements = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::size_t longest = (1U << 24) - 1;

  static Row rowAt(std::size_t start, std::size_t count, std::uint32_t spare) {
    if (count > longest || start > mostElements - count - spare)
      throw std::length_error("rows of more than four thousand million elements, or one of 16 million");
    Row row;
    row.start = static_cast<std::uint32_t>(start);
    row.count = static_cast<std::uint32_t>(count);
    row.spare = std::min(spare, mostSpare);
    return row;
  }
  void resizeInPlace(Row& row, std::size_t count) {
    const std::uint32_t room = row.room();
    row.count = static_cast<std::uint32_t>(count);
    row.spare = std::min(room - row.count, mostSpare);
    abandoned_ += room - row.room();
  }
  /// Gives a row other room, at the end; its elements are yet to be set.
  void move(std::size_t row, std::size_t count, std::uint32_t spare) {
    const Row place = rowAt(elements_.size(), count, spare);
    growCapacity(elements_, elements_.size() + place.room());
    elements_.resize(elements_.size() + place.room());
    clearSpare(place);
    abandoned_ += rows_[row].room();
    rows_[row] = place;
  }
  /// So that the elements of every row, and with them an archive, are what was done to it.
  void clearSpare(const Row& row) {
    std::fill_n(elements_.data() + row.start + row.count, std::size_t{row.spare}, T{});
  }

  PlainArray<T> elements_;
  std::vector<Row> rows_;
  std::size_t abandoned_ = 0;  ///< of elements_, that belong to no row; speed and memory only
};

}  // namespace restenosis
