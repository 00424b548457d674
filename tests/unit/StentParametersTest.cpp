#include <gtest/gtest.h>

#include "tissue/stent/StentParameters.h"

namespace restenosis {
namespace {

TEST(StentParameters, TheOuterLaminaIsFreeOrFixed) {
  StentParameters stent;
  EXPECT_FALSE(stent.fixesOuterLamina());
  stent.outerLamina = "fixed";
  EXPECT_TRUE(stent.fixesOuterLamina());
  stent.outerLamina = "stiff";
  EXPECT_THROW(stent.fixesOuterLamina(), std::invalid_argument);
}

}  // namespace
}  // namespace restenosis
