#pragma once

#include <string>

#include "bridge/scene/Units.h"

namespace restenosis {

/// A JSON Schema (draft-07) of scenes, by which editors complete and check TOML: sections and keys with
/// meaning, source and default, and what is allowed as far as such a schema can say it. Of a quantity it
/// knows that it is a number with some unit in quotes: dimension and bounds are for `check`.
std::string jsonSchema(const Units& units);

}  // namespace restenosis
