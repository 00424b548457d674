#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tissue/forces/PairSource.h"

namespace restenosis {

/// The pairs of up to `capacity` agents in the format of the pair kernel, sliced ELLPACK: a slice is `width`
/// agents side by side, and its n-th entry holds the n-th pair of each. A slice is as long as the longest
/// list of its agents, so agents are sorted by the length of theirs. The order of an agent's pairs is kept.
class PairList {
 public:
  static constexpr std::size_t capacity = 256;
  static constexpr std::size_t width = 16;

  struct alignas(64) Entry {
    std::array<Index, width> partner;     ///< beyond the end of an agent's list: none
    std::array<float, width> restLength;  ///< as Pair::restLength
  };
  /// What the pairs of a slice have: what none of them has need not be computed.
  struct Attractions {
    bool bonds = false, cohesion = false;
    void add(float restLength);
  };

  /// `none`: an index that no agent has, that of a sphere that touches nothing.
  void build(const PairSource& source, std::span<const Index> agents, Index none);
  /// Lists the pairs of the k-th agent again, which is agent i. Returns false where there is no space for
  /// them: the list is then to be built.
  bool replace(const PairSource& source, std::size_t k, Index i);

  std::size_t size() const { return size_; }
  std::size_t slices() const { return (size_ + width - 1) / width; }
  std::span<const Entry> entries(std::size_t slice) const {
    return std::span(entries_).subspan(slices_[slice].start, slices_[slice].length);
  }
  Attractions attractions(std::size_t slice) const { return slices_[slice].attractions; }
  /// The place among the agents of the n-th in the order of the slices.
  std::size_t operator[](std::size_t n) const { return order_[n]; }
  std::size_t bytes() const { return entries_.size() * sizeof(Entry); }

 private:
  struct Slice {
    std::uint32_t start = 0, length = 0, capacity = 0;  ///< entries
    Attractions attractions;
  };

  std::vector<Entry> entries_;
  std::array<Slice, capacity / width> slices_;
  std::array<std::uint8_t, capacity> order_{};
  std::size_t size_ = 0;
  Index none_ = 0;
};

}  // namespace restenosis
