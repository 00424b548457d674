#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace restenosis {

/// A value that is within its own bounds but does not fit the others.
struct ParameterProblem {
  std::string key;                            ///< with its section, as in "stent.length"
  std::string message;                        ///< what is wrong and what is allowed
  std::vector<std::string_view> others = {};  ///< keys that were looked at beside it
};

}  // namespace restenosis
