#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "bridge/scene/Units.h"
#include "tissue/biology/CellCycleParameters.h"
#include "tissue/biology/ContactInhibitionParameters.h"
#include "tissue/biology/EndotheliumParameters.h"
#include "tissue/parameters/ParameterVisitor.h"
#include "tissue/stent/InjuryParameters.h"
#include "tissue/stent/StentParameters.h"
#include "tissue/vessel/VesselParameters.h"

namespace restenosis {
namespace {

/// Checks each parameter's default against its own bounds.
class DefaultsCheck : public ParameterVisitor {
 public:
  void quantity(double& value, const ParameterInfo& info) override {
    expectWithin(units_.fromSi(value, info.unit), info);
  }
  void integer(std::int64_t& value, const ParameterInfo& info) override {
    expectWithin(static_cast<double>(value), info);
  }
  void boolean(bool&, const ParameterInfo& info) override { expectDescribed(info); }
  void choice(std::string& value, const std::vector<std::string_view>& allowed,
              const ParameterInfo& info) override {
    expectDescribed(info);
    EXPECT_EQ(std::ranges::count(allowed, value), 1) << info.key;
  }
  void text(std::string&, const ParameterInfo& info) override { expectDescribed(info); }
  void file(std::string& value, const ParameterInfo& info) override {
    expectDescribed(info);
    EXPECT_EQ(value, "") << info.key;
  }

 private:
  void expectDescribed(const ParameterInfo& info) {
    EXPECT_TRUE(keys_.emplace(info.key).second) << info.key << " is declared twice";
    EXPECT_FALSE(info.description.empty()) << info.key;
    EXPECT_FALSE(info.source.empty()) << info.key;
  }
  void expectWithin(double value, const ParameterInfo& info) {
    expectDescribed(info);
    const double rounding = 1e-12 * std::abs(value);
    EXPECT_GE(value, info.minimum - rounding) << info.key;
    EXPECT_LE(value, info.maximum + rounding) << info.key;
    EXPECT_TRUE(info.minimumAllowed || value > info.minimum) << info.key;
  }

  Units units_;
  std::set<std::string, std::less<>> keys_;
};

template <class Section>
void checkDefaults() {
  DefaultsCheck check;
  Section().describe(check);
}

TEST(ParameterVisitor, DefaultsAreWithinTheirBounds) {
  checkDefaults<VesselParameters>();
  checkDefaults<StentParameters>();
  checkDefaults<InjuryParameters>();
  checkDefaults<CellCycleParameters>();
  checkDefaults<ContactInhibitionParameters>();
  checkDefaults<EndotheliumParameters>();
}

}  // namespace
}  // namespace restenosis
