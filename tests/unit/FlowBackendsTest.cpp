#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "bridge/flow/FlowBackendNames.h"
#include "bridge/flow/backends/FlowBackends.h"

namespace restenosis {
namespace {

TEST(FlowBackends, everyNameASceneMayWriteIsInTheTable) {
  std::size_t found = 0;
  for (const auto name : flowBackendNames::all()) {
    const auto backend = makeFlowBackend(name, {});
    if (name == flowBackendNames::none) {
      EXPECT_EQ(backend, nullptr);
      continue;
    }
    ASSERT_NE(backend, nullptr);
    EXPECT_EQ(backend->name(), name);
    ++found;
  }
  EXPECT_EQ(found, flowBackends().size());
}

TEST(FlowBackends, unknownNamesListTheValidOnes) {
  try {
    makeFlowBackend("openfoam", {});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("foam, lbm, analytic, none"), std::string::npos);
  }
  EXPECT_THROW(makeFlowBackend("foam", {.fidelity = "fine"}), std::invalid_argument);
}

}  // namespace
}  // namespace restenosis
