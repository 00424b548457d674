#include <stdexcept>
#include <string>

#include "bridge/flow/foam/DictionaryText.h"
#include "bridge/flow/foam/FoamLog.h"
#include "tests/fuzz/FuzzTargets.h"

namespace restenosis {

void fuzzLog(std::string_view input) {
  const std::string log(input);
  foamLog::meshingProblem(log);
  foamLog::meshReport(log);
  foamLog::convergedAfter(log);
  foamLog::fatalError(log);
  foamLog::patchFaces(log);
  foamLog::lastValue(log);
  try {
    DictionaryText dictionary(log);
    dictionary.set("ranks", 2);
    if (dictionary.get("ranks") != "2") throw std::logic_error("an entry is not what it was set to");
  } catch (const std::invalid_argument&) {
    // No such entry
  }
}

}  // namespace restenosis
