#include <gtest/gtest.h>

#include "tissue/biology/CellCycleParameters.h"
#include "tissue/parameters/IgnoringVisitor.h"
#include "tissue/stent/StentParameters.h"

namespace restenosis {
namespace {

TEST(IgnoringVisitor, LeavesEveryValue) {
  StentParameters stent;
  stent.design = "helix";
  stent.file = "struts.stl";
  stent.ringCount = 3;
  stent.helixTurns = 2.5;
  IgnoringVisitor visitor;
  stent.describe(visitor);
  EXPECT_EQ(stent.design, "helix");
  EXPECT_EQ(stent.file, "struts.stl");
  EXPECT_EQ(stent.ringCount, 3);
  EXPECT_EQ(stent.helixTurns, 2.5);
}

/// Doubles every quantity.
class Doubling : public IgnoringVisitor {
 public:
  void quantity(double& value, const ParameterInfo&) override { value *= 2; }
};

TEST(IgnoringVisitor, AVisitorBasedOnItReadsItsOwnKindOnly) {
  Doubling visitor;
  StentParameters stent;
  stent.describe(visitor);
  EXPECT_EQ(stent.helixTurns, 2 * StentParameters().helixTurns);
  EXPECT_EQ(stent.ringCount, StentParameters().ringCount);
  EXPECT_EQ(stent.design, StentParameters().design);
  CellCycleParameters cycle;
  cycle.describe(visitor);
  EXPECT_EQ(cycle.g1Mean, 2 * CellCycleParameters().g1Mean);
}

}  // namespace
}  // namespace restenosis
