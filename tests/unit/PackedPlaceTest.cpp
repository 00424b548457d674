#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "tissue/agents/RandomStream.h"
#include "tissue/neighbours/PackedPlace.h"

namespace restenosis {
namespace {

static_assert(sizeof(PackedPlace) == 4);

TEST(PackedPlace, TellsDistancesToAThousandthOfACell) {
  RandomStream random(5, 0, 0, RandomPurpose::packing);
  const double cell = 0.1, thousandth = cell / CellLattice::InCell::most;
  const auto anywhere = [&] { return Vec3(random.uniform(), random.uniform(), random.uniform()); };
  const auto corner = [](std::size_t k) { return Vec3(Vec3::Constant(k % 2 == 0 ? 0 : 2)); };
  const CellLattice wide(100'000, corner, cell);
  int seen = 0;
  for (int n = 0; n < 300; ++n) {
    const Vec3 from = anywhere(), to = from + 0.15 * (2 * anywhere() - Vec3::Ones());
    wide.forEachRow(from, 0.3, [&](std::int64_t begin, std::int64_t end, const CellLattice::Offset& offset) {
      ASSERT_TRUE(offset.known);
      PackedPlace::From seenFrom(wide.inCell(from), offset);
      for (std::int64_t c = begin; c < end; ++c, seenFrom.nextCell()) {
        if (wide.cellOf(to) != static_cast<std::uint32_t>(c)) continue;
        const PackedPlace place(wide.inCell(to));
        ASSERT_TRUE(place.known());
        EXPECT_NEAR(std::sqrt(seenFrom.squaredDistance(place)) * thousandth, (to - from).norm(),
                    PackedPlace::error * thousandth);
        ++seen;
      }
    });
  }
  EXPECT_EQ(seen, 300);
}

TEST(PackedPlace, IsNotKnownWhereNumbersAreTooCoarse) {
  const CellLattice lattice(
      1, [](std::size_t) { return Vec3(0, 0, 0); }, 1e-5);
  EXPECT_FALSE(PackedPlace().known());
  EXPECT_TRUE(PackedPlace(lattice.inCell({1, -1, 1})).known());
  EXPECT_FALSE(PackedPlace(lattice.inCell({0, 1e200, 0})).known());
}

TEST(PackedPlace, CellsOfASmallBoxMayStandForSeveral) {
  const CellLattice lattice(
      1, [](std::size_t) { return Vec3(0, 0, 0); }, 1.0);
  bool known = true;
  const auto look = [&](std::int64_t, std::int64_t, const CellLattice::Offset& offset) {
    known = offset.known;
  };
  lattice.forEachRow({0, 0, 0}, 100, look);
  EXPECT_FALSE(known);
  lattice.forEachRow({0.5, 0.5, 0.5}, 0.1, look);
  EXPECT_TRUE(known);
}

}  // namespace
}  // namespace restenosis
