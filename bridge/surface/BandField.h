#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "LumenGrid.h"

namespace restenosis {

/// A field that is the same everywhere but in a band, as a distance that is clipped: trilinear between the
/// nodes of a grid, which are kept in blocks, and of a block where all are equal only that value is. Bit for
/// bit what the whole field would give, for a sixth of its memory where it is that of a vessel's lumen.
class BandField {
 public:
  explicit BandField(const GridField& field) : BandField(field, nullptr) {}
  /// Only in the blocks in which `where`, of the same grid, is not the same everywhere; what it is elsewhere
  /// is not known.
  BandField(const GridField& field, const BandField& where) : BandField(field, &where) {}

  const LumenGrid& grid() const { return grid_; }
  /// Value at a node.
  float operator()(int i, int j, int k) const;
  /// Copies the values at the nodes of a row along x, grid().nx of them.
  void copyRow(int j, int k, float* to) const;
  /// Trilinear value at a point; a point beyond the grid takes the value of the nearest point on it.
  double at(const Vec3& point) const;
  /// The same, with the gradient of the trilinear function.
  double at(const Vec3& point, Vec3& gradient) const;
  /// Bilinear value within the plane of nodes k.
  double inPlane(double x, double y, int k) const;
  /// Whether the field is the same everywhere in the block of a point.
  bool evenAround(const Vec3& point) const;
  /// How many values are kept.
  std::size_t kept() const { return values_.size(); }

 private:
  static constexpr int cells = 8;  ///< of a block, along each axis
  /// Nodes: blocks side by side share those between them, so that all corners of a cell are in one.
  static constexpr int side = cells + 1;
  static constexpr std::size_t plane = std::size_t{side} * side, volume = plane * side;
  static constexpr std::uint32_t even = UINT32_MAX;

  /// Where the grid ends within a block, its last nodes are repeated.
  struct Block {
    std::uint32_t number = even;  ///< among those whose values are kept
    float value = 0;              ///< of an even block
  };
  BandField(const GridField& field, const BandField* where);
  /// The node of a block where its values begin.
  struct Node {
    int i, j, k;
  };
  Node firstOf(std::size_t block) const;
  /// The block in which a node and the next ones are, or, of a last node, the ones before.
  std::size_t blockOf(int i, int j, int k) const;
  bool isEven(std::size_t block) const { return blocks_[block].number == even; }
  /// The values of a block that is not even, from this node of it on.
  const float* from(std::size_t block, int i, int j, int k) const;

  LumenGrid grid_;
  int blocksX_, blocksY_, blocksZ_;
  std::vector<Block> blocks_;
  std::vector<float> values_;
};

}  // namespace restenosis
