#include <gtest/gtest.h>

#include "tissue/stent/InjuryParameters.h"

namespace restenosis {
namespace {

TEST(InjuryParameters, WordsSayWhichCellsAndWhetherTheEndothelium) {
  InjuryParameters injury;
  EXPECT_FALSE(injury.everyCellSynthetic());
  EXPECT_TRUE(injury.denuded());
  injury.synthetic = "all";
  injury.denudation = "none";
  EXPECT_TRUE(injury.everyCellSynthetic());
  EXPECT_FALSE(injury.denuded());
  injury.synthetic = injury.denudation = "some";
  EXPECT_THROW(injury.everyCellSynthetic(), std::invalid_argument);
  EXPECT_THROW(injury.denuded(), std::invalid_argument);
}

}  // namespace
}  // namespace restenosis
