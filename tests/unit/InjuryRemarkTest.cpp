#include <gtest/gtest.h>

#include "tissue/stent/InjuryRemark.h"

namespace restenosis {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(InjuryRemark, SaysWhatAnInjuryWithoutEffectLacked) {
  const InjuryParameters parameters;
  InjuryReport injury;
  EXPECT_TRUE(contains(remarkOnInjury(injury, parameters), "made no cell synthetic"));
  EXPECT_TRUE(contains(remarkOnInjury(injury, parameters), "injury.endMargin"));
  injury.iel = 100;
  EXPECT_TRUE(contains(remarkOnInjury(injury, parameters), "vessel.bondRange"));
  injury.ielBonds = 300;
  injury.largestStrain = 0.01;
  EXPECT_TRUE(contains(remarkOnInjury(injury, parameters), "nowhere stretched by more than 0.045"));
  EXPECT_TRUE(contains(remarkOnInjury(injury, parameters), "by 0.01)"));
  InjuryParameters byStress;
  byStress.ielBreaks = true, byStress.stressLimit = 2e3;
  EXPECT_FALSE(contains(remarkOnInjury(injury, parameters), "injury.stressLimit"));
  EXPECT_TRUE(contains(remarkOnInjury(injury, byStress), "nor is its stress past injury.stressLimit"));
  injury.stretched = 3;
  EXPECT_TRUE(
      contains(remarkOnInjury(injury, parameters), "of 3 stretched agents of the IEL none was fenestrated"));
  injury.synthetic = 1;
  EXPECT_EQ(remarkOnInjury(injury, parameters), "");
}

}  // namespace
}  // namespace restenosis
