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

#include "tissue/agents/Capacity.h"
#include "tissue/agents/PlainArray.h"

namespace restenosis {

/// Short lists of many lengths in one array. A list that outgrows its capacity moves to the end of the array,
/// and what it leaves is unused until the lists are moved together.
template <class T>
class JaggedArray {
 public:
  static constexpr std::uint32_t mostSpare = 255;  ///< largest capacity of a list beyond its length

  std::size_t size() const { return lists_.size(); }
  bool empty() const { return lists_.empty(); }
  std::span<const T> operator[](std::size_t list) const {
    return {elements_.data() + lists_[list].start, lists_[list].count};
  }
  std::span<T> operator[](std::size_t list) {
    return {elements_.data() + lists_[list].start, lists_[list].count};
  }
  /// Elements of all lists together.
  std::size_t elementCount() const {
    std::size_t elements = 0;
    for (const List& list : lists_) elements += list.count;
    return elements;
  }

  /// Appends empty lists, or drops the last, until there are so many.
  void resize(std::size_t lists) {
    growCapacity(lists_, lists);
    lists_.resize(lists);
  }
  /// Makes it so many lists, the k-th of countOf(k) elements that are yet to be set, each with capacity for
  /// `spare` more if it has any. Throws std::length_error for more elements than lists can address.
  template <class CountOf>
  void layOut(std::size_t lists, const CountOf& countOf, std::uint32_t spare = 0) {
    layOut(lists, countOf, [&](std::size_t k) { return countOf(k) > 0 ? spare : 0U; });
  }
  /// The same with capacity for spareOf(k) more elements, at most mostSpare.
  template <class CountOf, class SpareOf>
  requires std::invocable<SpareOf, std::size_t>
  void layOut(std::size_t lists, const CountOf& countOf, const SpareOf& spareOf) {
    lists_.clear();
    resize(lists);
    unused_ = 0;
    std::size_t end = 0;
    for (std::size_t k = 0; k < lists; ++k) {
      lists_[k] = listAt(end, countOf(k), spareOf(k));
      end += lists_[k].capacity();
    }
    elements_ = {};  // what it holds need not be copied
    growCapacity(elements_, end);
    elements_.resize(end);
    for (const List& list : lists_) clearSpare(list);
  }
  /// Reserves memory for so many lists, which have so many elements together.
  void reserve(std::size_t lists, std::size_t elements) {
    lists_.reserve(lists);
    elements_.reserve(elements);
  }
  /// Appends a list of these elements, without capacity for more. Throws as layOut() does.
  void addList(std::span<const T> elements) {
    resize(size() + 1);
    move(size() - 1, elements.size(), 0);
    std::ranges::copy(elements, (*this)[size() - 1].begin());
  }
  /// Moves the lists together, each with capacity for `spare` more elements if it has any.
  void compact(std::uint32_t spare = 0) {
    spread([&](std::size_t k) { return lists_[k].count > 0 ? spare : 0U; });
  }
  /// Moves the lists, giving the k-th capacity for moreOf(k) more elements, at most mostSpare.
  template <class MoreOf>
  void spread(const MoreOf& moreOf) {
    JaggedArray moved;
    moved.layOut(
        size(), [this](std::size_t k) { return lists_[k].count; }, moreOf);
    for (std::size_t k = 0; k < size(); ++k) std::ranges::copy(std::as_const(*this)[k], moved[k].begin());
    *this = std::move(moved);
  }
  /// Whether much of the array is unused, so that moving the lists together pays.
  bool wasteful() const { return 4 * unused_ > elements_.size(); }

  /// Replaces a list by elements that are not in the array; beyond its capacity it gets capacity for `spare`
  /// more. Throws as layOut() does.
  void set(std::size_t list, std::span<const T> elements, std::uint32_t spare) {
    if (elements.size() > lists_[list].capacity()) {
      move(list, elements.size(), spare);
    } else {
      resizeInPlace(lists_[list], elements.size());
    }
    std::ranges::copy(elements, (*this)[list].begin());
  }
  /// Inserts an element at a position of a list, which gets capacity for `spare` more where it has none left.
  /// Throws as layOut() does.
  void insert(std::size_t list, std::size_t position, T element, std::uint32_t spare) {
    const List before = lists_[list];
    if (before.spare > 0) {
      resizeInPlace(lists_[list], before.count + 1);
    } else {
      move(list, before.count + 1, spare);
      std::copy_n(elements_.begin() + before.start, before.count, elements_.begin() + lists_[list].start);
    }
    const std::span<T> elements = (*this)[list];
    std::copy_backward(elements.begin() + static_cast<std::ptrdiff_t>(position), elements.end() - 1,
                       elements.end());
    elements[position] = element;
  }
  void append(std::size_t list, T element, std::uint32_t spare) {
    insert(list, lists_[list].count, element, spare);
  }
  void erase(std::size_t list, std::size_t position) {
    const std::span<T> elements = (*this)[list];
    assert(position < elements.size());
    std::copy(elements.begin() + static_cast<std::ptrdiff_t>(position) + 1, elements.end(),
              elements.begin() + static_cast<std::ptrdiff_t>(position));
    resizeInPlace(lists_[list], elements.size() - 1);
  }

  template <class Archive>
  void archive(Archive& a) {
    a(elements_, lists_);
  }

 private:
  /// Where the elements of a list are, and how many more it has capacity for.
  struct List {
    std::uint32_t start = 0;
    std::uint32_t count : 24 = 0, spare : 8 = 0;
    std::uint32_t capacity() const { return count + spare; }
  };
  static constexpr std::size_t mostElements = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::size_t longest = (1U << 24) - 1;

  static List listAt(std::size_t start, std::size_t count, std::uint32_t spare) {
    if (count > longest || start > mostElements - count - spare)
      throw std::length_error("lists of more than four thousand million elements, or one of 16 million");
    List list;
    list.start = static_cast<std::uint32_t>(start);
    list.count = static_cast<std::uint32_t>(count);
    list.spare = std::min(spare, mostSpare);
    return list;
  }
  void resizeInPlace(List& list, std::size_t count) {
    const std::uint32_t capacity = list.capacity();
    list.count = static_cast<std::uint32_t>(count);
    list.spare = std::min(capacity - list.count, mostSpare);
    unused_ += capacity - list.capacity();
  }
  /// Gives a list other elements, at the end, which are yet to be set.
  void move(std::size_t list, std::size_t count, std::uint32_t spare) {
    const List moved = listAt(elements_.size(), count, spare);
    growCapacity(elements_, elements_.size() + moved.capacity());
    elements_.resize(elements_.size() + moved.capacity());
    clearSpare(moved);
    unused_ += lists_[list].capacity();
    lists_[list] = moved;
  }
  /// So that the elements of every list, and with them an archive, follow from what was done to it.
  void clearSpare(const List& list) {
    std::fill_n(elements_.data() + list.start + list.count, std::size_t{list.spare}, T{});
  }

  PlainArray<T> elements_;
  std::vector<List> lists_;
  std::size_t unused_ = 0;  ///< elements that belong to no list
};

}  // namespace restenosis
