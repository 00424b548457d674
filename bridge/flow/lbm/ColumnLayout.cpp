#include "bridge/flow/lbm/ColumnLayout.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace restenosis {
namespace {

/// Offset of columns that have no places: beyond all places, with any z.
constexpr std::int64_t unstored = 0xfff00000;

struct Extent {
  int low = std::numeric_limits<int>::max(), high = std::numeric_limits<int>::min();
  bool empty() const { return low > high; }
  void include(const Extent& o) {
    low = std::min(low, o.low);
    high = std::max(high, o.high);
  }
};

int alignedDown(int z) {
  constexpr int a = ColumnLayout::alignment;
  return (z >= 0 ? z / a : -((-z + a - 1) / a)) * a;
}

}  // namespace

ColumnLayout::ColumnLayout(const d3q19::Step& size, const std::function<bool(int, int, int)>& fluid)
    : size_(size) {
  const std::size_t columns = static_cast<std::size_t>(size[0] + 2) * static_cast<std::size_t>(size[1] + 2);
  std::vector<Extent> fluidExtent(columns);
  for (int x = 0; x < size[0]; ++x)
    for (int y = 0; y < size[1]; ++y)
      for (int z = 0; z < size[2]; ++z) {
        if (!fluid(x, y, z)) continue;
        fluidExtent[column(x, y)].include({z, z});
        ++fluidNodes_;
        if (!runs_.empty()) {
          NodeRun& last = runs_.back();
          if (last.x == x && last.y == y && last.z + static_cast<int>(last.count) == z) {
            ++last.count;
            continue;
          }
        }
        runs_.push_back({x, y, z, 0, 1});
      }

  offsets_.assign(columns, unstored);
  std::int64_t next = 0;
  for (int x = -1; x <= size[0]; ++x)
    for (int y = -1; y <= size[1]; ++y) {
      Extent extent;
      for (int i = std::max(x - 1, -1); i <= std::min(x + 1, size[0]); ++i)
        for (int j = std::max(y - 1, -1); j <= std::min(y + 1, size[1]); ++j)
          extent.include(fluidExtent[column(i, j)]);
      if (extent.empty()) continue;
      const int begin = alignedDown(extent.low - 1), end = alignedDown(extent.high + 1 + alignment);
      offsets_[column(x, y)] = next - begin;
      next += end - begin;
    }
  if (next * d3q19::directions > std::numeric_limits<std::uint32_t>::max())
    throw std::length_error("the lattice has too many nodes for 32-bit places");
  places_ = static_cast<std::uint32_t>(next);
  for (NodeRun& run : runs_) run.first = place(run.x, run.y, run.z);
}

}  // namespace restenosis
