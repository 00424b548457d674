// The entry of libFuzzer for the target FUZZ_TARGET, one of fuzzTargets().
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/FuzzTargets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto target =
      std::ranges::find(restenosis::fuzzTargets(), FUZZ_TARGET, &restenosis::FuzzTarget::name);
  target->run({reinterpret_cast<const char*>(data), size});
  return 0;
}
