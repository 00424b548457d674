#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "tissue/biology/ContactInhibitionLaw.h"

namespace restenosis {
namespace {

TEST(ContactInhibitionLaw, IsMadeByName) {
  for (const auto name : contactInhibitionLawNames()) {
    ContactInhibitionParameters parameters;
    parameters.law = name;
    EXPECT_NE(makeContactInhibitionLaw(parameters), nullptr) << name;
  }
}

TEST(ContactInhibitionLaw, NamesTheLawsThereAre) {
  ContactInhibitionParameters parameters;
  parameters.law = "exposition";
  try {
    makeContactInhibitionLaw(parameters);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("exposure, neighbourCount"), std::string::npos) << error.what();
  }
}

TEST(ExposureLaw, InhibitsWhatIsNotExposed) {
  const auto law = makeContactInhibitionLaw({});
  EXPECT_TRUE(law->inhibits({1, false, {}}));
  EXPECT_FALSE(law->inhibits({1, true, {}}));
  EXPECT_EQ(law->range(), 0);  // looks at no neighbour itself
}

TEST(NeighbourCountLaw, WeighsAndCountsWithinItsRange) {
  ContactInhibitionParameters parameters;
  parameters.law = "neighbourCount";
  parameters.countRange = 1.5;
  parameters.countThreshold = 3.1;
  parameters.eelWeight = 2;
  const auto law = makeContactInhibitionLaw(parameters);
  const auto inhibited = [&](std::vector<AgentKind> kinds, double distance) {
    std::vector<ContactNeighbour> neighbours;
    for (const auto kind : kinds) neighbours.push_back({Vec3(distance, 0, 0), distance, 1.0, kind});
    return law->inhibits({1, true, neighbours});
  };
  using enum AgentKind;
  EXPECT_FALSE(inhibited({smc, smc, iel}, 2));
  EXPECT_FALSE(inhibited({smc, strut, iel, smc}, 2));
  EXPECT_TRUE(inhibited({smc, strut, strut, iel, smc}, 2));
  EXPECT_TRUE(inhibited({eel, smc, smc}, 2.99));
  EXPECT_FALSE(inhibited({eel, smc, smc}, 3.01));
}

TEST(StressLaw, InhibitsAboveItsThresholdWhateverTheNeighbours) {
  ContactInhibitionParameters parameters;
  parameters.law = "stress";
  for (const double threshold : {0.0, 5000.0, 1e9}) {
    parameters.stressThreshold = threshold;
    const auto law = makeContactInhibitionLaw(parameters);
    EXPECT_TRUE(law->readsStress());
    for (const bool isExposed : {false, true}) {
      EXPECT_FALSE(law->inhibits({1, isExposed, {}, -50000}));
      EXPECT_FALSE(law->inhibits({1, isExposed, {}, threshold}));
      EXPECT_TRUE(law->inhibits({1, isExposed, {}, threshold + 1}));
    }
  }
}

}  // namespace
}  // namespace restenosis
