#pragma once

#include <string>

namespace restenosis {

/// What a part of a run says of itself for a scene.
struct PlannedPart {
  std::string name;
  bool runs;
  std::string explanation;  ///< when it runs, or why it does not
};

}  // namespace restenosis
