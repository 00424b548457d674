#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "bridge/scene/JsonSchema.h"
#include "bridge/scene/Scene.h"

namespace restenosis {
namespace {

struct JsonSchemaTest : testing::Test {
  const nlohmann::json schema = nlohmann::json::parse(jsonSchema(Units()));
  const nlohmann::json& key(const char* section, const char* name) const {
    return schema["properties"][section]["properties"][name];
  }
};

TEST_F(JsonSchemaTest, HasEverySectionAndNoOtherKeys) {
  EXPECT_EQ(schema["required"], nlohmann::json({"scene", "vessel"}));
  EXPECT_EQ(schema["additionalProperties"], false);
  Scene scene;
  scene.forEachSection([&](auto& section, bool) {
    const auto& found = schema["properties"][std::string(section.section)];
    EXPECT_EQ(found["description"], section.summary);
    EXPECT_EQ(found["additionalProperties"], false);
    EXPECT_FALSE(found["properties"].empty());
  });
}

TEST_F(JsonSchemaTest, SaysWhatIsAllowedAndWhatHoldsWithoutAKey) {
  EXPECT_EQ(key("stent", "deploymentDepth")["default"], "110 um");
  EXPECT_EQ(key("stent", "deploymentSteps")["type"], "integer");
  EXPECT_EQ(key("stent", "deploymentSteps")["minimum"], 1);
  EXPECT_EQ(key("flow", "drive")["enum"], nlohmann::json({"flowRate", "pressureGradient", "resistance"}));
  EXPECT_EQ(key("injury", "removeIel")["type"], "boolean");
  EXPECT_EQ(key("injury", "fenestrationProbability")["maximum"], 1);
  EXPECT_FALSE(key("vessel", "length").contains("default"));
  EXPECT_EQ(schema["properties"]["scene"]["required"], nlohmann::json({"duration"}));
}

TEST_F(JsonSchemaTest, AFileStandsForTheKeysThatItMakesNeedless) {
  const auto& alternatives = schema["properties"]["vessel"]["anyOf"];
  ASSERT_EQ(alternatives.size(), 3U);
  EXPECT_EQ(alternatives[0]["required"], nlohmann::json({"length", "lumenDiameter"}));
  EXPECT_EQ(alternatives[1]["required"], nlohmann::json({"lumenSurface"}));
  EXPECT_EQ(alternatives[2]["required"], nlohmann::json({"centreline"}));
}

TEST_F(JsonSchemaTest, AQuantityIsANumberWithAUnit) {
  const std::regex pattern(key("stent", "deploymentDepth")["pattern"].get<std::string>());
  for (const char* right : {"110 um", "0.09 mm", "1e-4 m", "7.2 1/d", "-5um", ".5 mm", "2.7e-6 m^2/s"})
    EXPECT_TRUE(std::regex_match(right, pattern)) << right;
  for (const char* wrong : {"110", "um", "", "1 2", "1e5", "mm 3"})
    EXPECT_FALSE(std::regex_match(wrong, pattern)) << wrong;
}

}  // namespace
}  // namespace restenosis
