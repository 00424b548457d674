#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "bridge/scene/Scene.h"
#include "bridge/scene/SchemaPrinter.h"

namespace restenosis {
namespace {

TEST(SchemaPrinter, ListsEverySectionWithUnitsBoundsAndSources) {
  const Units units;
  const std::string text = schemaText(units), markdown = schemaMarkdown(units);
  Scene scene;
  scene.forEachSection([&](auto& section, bool) {
    const std::string heading = fmt::format("[{}]", section.section);
    EXPECT_NE(text.find(heading), std::string::npos);
    EXPECT_NE(markdown.find(fmt::format("## {}", heading)), std::string::npos);
  });
  EXPECT_NE(
      markdown.find("| key | type | default | allowed | source | meaning |\n|---|---|---|---|---|---|\n"),
      std::string::npos);
  EXPECT_NE(markdown.find("| deploymentDepth | quantity | 110 um | at least 0 um, at most 1000 um | ISR3D |"),
            std::string::npos);
  EXPECT_NE(markdown.find("| length | quantity | required | larger than 0 mm, at most 1000 mm | T6 |"),
            std::string::npos);
  const auto says = [&](std::string_view summary, std::string_view presence) {
    return markdown.find(fmt::format("{} ({}).", summary, presence)) != std::string::npos;
  };
  EXPECT_TRUE(says(StentParameters::summary, "left out: not modelled"));
  EXPECT_TRUE(says(FoamSettings::summary, "may be left out: scene.fidelity then decides"));
  EXPECT_TRUE(says(LbmSettings::summary, "may be left out: scene.fidelity then decides"));
  EXPECT_NE(text.find("allowed: flowRate, pressureGradient"), std::string::npos);
}

}  // namespace
}  // namespace restenosis
