#include <gtest/gtest.h>

#include "tissue/parameters/NearestName.h"

namespace restenosis {
namespace {

const std::vector<std::string_view> allowedKeys = {"length", "lumenDiameter", "wallThickness", "seed"};

TEST(NearestName, FindsOneSlip) {
  EXPECT_EQ(nearestName("lengt", allowedKeys), "length") << "left out";
  EXPECT_EQ(nearestName("lenngth", allowedKeys), "length") << "put in";
  EXPECT_EQ(nearestName("lemgth", allowedKeys), "length") << "replaced";
  EXPECT_EQ(nearestName("lenght", allowedKeys), "length") << "swapped";
  EXPECT_EQ(nearestName("LENGTH", allowedKeys), "length") << "in capitals";
  EXPECT_EQ(nearestName("wallthickness", allowedKeys), "wallThickness");
}

TEST(NearestName, ASwapIsOneEdit) {
  EXPECT_EQ(nearestName("elntgh", allowedKeys), "length") << "two swaps; as replacements they would be four";
}

TEST(NearestName, AllowsTwoEditsOrAThirdOfTheName) {
  EXPECT_EQ(nearestName("lexxth", allowedKeys), "length");
  EXPECT_EQ(nearestName("xxxgth", allowedKeys), "");
  EXPECT_EQ(nearestName("wallXXXXkness", allowedKeys), "wallThickness") << "four of thirteen letters";
  EXPECT_EQ(nearestName("walXXXXXkness", allowedKeys), "") << "five of thirteen letters";
}

TEST(NearestName, NoLetterInCommonIsNotNear) {
  EXPECT_EQ(nearestName("ab", {"x", "yz"}), "");
  EXPECT_EQ(nearestName("", {"x", "yz"}), "");
  EXPECT_EQ(nearestName("length", {}), "");
}

TEST(NearestName, TheFirstOfEquallyNearOnesAndTheNearest) {
  EXPECT_EQ(nearestName("seeds", {"seedA", "seedB"}), "seedA");
  EXPECT_EQ(nearestName("seedB", {"seedA", "seedB"}), "seedB");
}

TEST(NearestName, ALongTextIsNoSlip) {
  const std::string word(150, 'a'), text(201, 'a');
  EXPECT_EQ(nearestName(word + 'b', {word}), word);
  EXPECT_EQ(nearestName(text, {text}), "");
}

TEST(NearestName, SuggestionListsAllAndAsksOnlyWhereOneIsNear) {
  EXPECT_EQ(suggestion("sead", {"seed", "step"}), "; did you mean 'seed'? Allowed: seed, step");
  EXPECT_EQ(suggestion("colour", {"seed", "step"}), ". Allowed: seed, step");
}

}  // namespace
}  // namespace restenosis
