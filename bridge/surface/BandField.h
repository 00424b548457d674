#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "bridge/surface/LumenGrid.h"

namespace restenosis {

/// A field that is the same everywhere but in a band, as a distance that is clipped: trilinear between the
/// nodes of a grid, which are kept in blocks, and of a block where all are equal only that value is. Bit for
/// bit what the whole field would give. Of a stented vessel's lumen, struts and tissue around them a quarter
/// is kept.
class BandField {
 public:
  /// Sets the values at the nodes of plane k, row by row, each grid.nx long.
  using FillPlane = std::function<void(int k, float* values)>;

  /// The whole field is never in memory. `fill` is called from several threads, for some planes twice.
  BandField(const LumenGrid& grid, const FillPlane& fill);
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
  /// Distance from the axis below which `inPlane` of this plane is everywhere what it is on the axis [m].
  double evenRadius(int k) const;
  /// Whether the field is the same everywhere in the block of a point.
  bool evenAround(const Vec3& point) const;
  /// How many values are kept.
  std::size_t kept() const;

 private:
  static constexpr int cells = 8;  ///< of a block, along each axis
  /// Nodes: blocks side by side share those between them, so that all corners of a cell are in one.
  static constexpr int side = cells + 1;
  static constexpr std::size_t ofPlane = std::size_t{side} * side, ofBlock = ofPlane * side;  ///< values
  static constexpr std::uint32_t even = UINT32_MAX;

  /// Where the grid ends within a block, its last nodes are repeated.
  struct Block {
    std::uint32_t number = even;  ///< among those of its layer whose values are kept
    float value = 0;              ///< of an even block
  };
  /// The blocks between some planes of nodes, row by row.
  struct Layer {
    std::vector<Block> blocks;
    std::vector<float> values;
    bool isEven(std::size_t block) const { return blocks[block].number == even; }
  };
  /// A node in a block.
  struct Place {
    const Layer& layer;
    std::size_t block;
    std::size_t value;  ///< its number in the block
    bool isEven() const { return layer.isEven(block); }
    float evenValue() const { return layer.blocks[block].value; }
    /// The values of a block that is not even, from this node on.
    const float* values() const { return layer.values.data() + layer.blocks[block].number * ofBlock + value; }
  };
  /// Where the planes of a layer are.
  using Planes = std::array<const float*, side>;

  explicit BandField(const LumenGrid& grid);
  BandField(const GridField& field, const BandField* where);
  /// The plane of nodes that is the n-th of a layer.
  int nodeOf(std::size_t layer, int n) const;
  void setLayer(std::size_t number, const Planes& planes, const Layer* where);
  /// The node where a block of a layer begins.
  struct Node {
    int i, j;
  };
  Node firstOf(std::size_t block) const;
  /// A node in the block in which the next ones are, or, of a last node, the ones before.
  Place placeOf(int i, int j, int k) const;

  LumenGrid grid_;
  int blocksX_, blocksY_;
  std::vector<Layer> layers_;
};

}  // namespace restenosis
