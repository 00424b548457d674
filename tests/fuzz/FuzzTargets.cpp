#include "tests/fuzz/FuzzTargets.h"

#include <array>

namespace restenosis {

std::span<const FuzzTarget> fuzzTargets() {
  static constexpr std::array<FuzzTarget, 5> targets = {
      {{"scene", fuzzScene}, {"stl", fuzzStl}, {"table", fuzzTable}, {"log", fuzzLog}, {"mesh", fuzzMesh}}};
  return targets;
}

}  // namespace restenosis
