#include <gtest/gtest.h>

#include "bridge/surface/DistanceField.h"
#include "bridge/surface/StrutBand.h"

namespace restenosis {
namespace {

const std::vector<StrutSegment> oneStrut{
    {.a = {8, -4, 10}, .b = {8, 4, 10}, .radial = Vec3::UnitX(), .width = 3, .thickness = 2, .round = false}};

void expectSame(const BandField& a, const BandField& b) {
  for (int k = 0; k < a.grid().nz; ++k)
    for (int j = 0; j < a.grid().ny; ++j)
      for (int i = 0; i < a.grid().nx; ++i) ASSERT_EQ(a(i, j, k), b(i, j, k));
}

TEST(StrutBand, IsThatOfTheGridItIsAskedFor) {
  StrutBand band(oneStrut);
  const LumenGrid grid(20, 12, 1), wider(20, 14, 1);
  for (const LumenGrid& g : {grid, grid, wider, grid}) expectSame(*band.on(g, 3), strutBand(g, oneStrut, 3));
  expectSame(*band.on(grid, 2), strutBand(grid, oneStrut, 2));
  EXPECT_EQ(band.on(grid, 2), band.on(grid, 2)) << "kept";
}

TEST(StrutBand, IsNoneWithoutStruts) { EXPECT_EQ(StrutBand({}).on(LumenGrid(20, 12, 1), 3), nullptr); }

}  // namespace
}  // namespace restenosis
