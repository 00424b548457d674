#pragma once

#include <map>
#include <string>

namespace restenosis {

/// What the last bits of a state may depend on beside the scene, by name: version and compiler of this
/// program, the instructions it was compiled for, those of the processor that libraries choose their code by,
/// and the C library.
std::map<std::string, std::string> buildTraits();

/// Where `now` differs from `before`: "compiler 13.2.0 (before: 12.2.0)". Empty where it does not.
std::string traitsInPlace(const std::map<std::string, std::string>& before,
                          const std::map<std::string, std::string>& now);

}  // namespace restenosis
