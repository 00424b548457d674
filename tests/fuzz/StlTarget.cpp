#include <stdexcept>

#include "bridge/surface/LoadedLumen.h"
#include "bridge/surface/LoadedStruts.h"
#include "bridge/surface/StlFile.h"
#include "tests/fuzz/FuzzTargets.h"
#include "tests/fuzz/MemoryFile.h"

namespace restenosis {

void fuzzStl(std::string_view input) {
  static const MemoryFile memory;
  const auto file = memory.holding(input);
  const auto attempt = [](auto read) {
    try {
      read();
    } catch (const std::runtime_error&) {
      // Refused, as all of these readers say
    }
  };
  attempt([&] { readStl(file, 1e-3); });
  attempt([&] { loadLumen(file, 1e-3); });
  attempt([&] { loadStruts(file, 1e-3); });
}

}  // namespace restenosis
