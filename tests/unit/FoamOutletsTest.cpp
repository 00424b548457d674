#include <gtest/gtest.h>

#include "bridge/flow/foam/FoamOutlets.h"
#include "tests/support/ExpectSays.h"
#include "tests/support/FlowSupport.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

std::string ofTemplate() { return readText(RESTENOSIS_SOURCE_DIR "/foamCase/system/outlets"); }

TEST(FoamOutlets, OfOneOutletAreTheTemplates) {
  EXPECT_EQ(outletsText(ofTemplate(), support::vesselConditions()), ofTemplate());
}

TEST(FoamOutlets, BesideTheFirstHaveTheirFlow) {
  FlowConditions conditions = support::vesselConditions();
  conditions.flowRate = 1e-6;
  conditions.outlets = {
      {.name = "a", .share = 0.5}, {.name = "b", .share = 0.25}, {.name = "c", .share = 0.25}};
  const std::string text = outletsText(ofTemplate(), conditions);
  EXPECT_SAYS(text, "outlet3 { name outlet3; }");
  EXPECT_SAYS(text, "volumetricFlowRate constant 2.5e-07;");
  EXPECT_SAYS(text, "outlet2Pressure");
  EXPECT_EQ(text.find("outlet1"), std::string::npos);
  EXPECT_THROW(outletsText(text, conditions), std::invalid_argument);
}

}  // namespace
}  // namespace restenosis
