#pragma once

#include <string>

#include "bridge/scene/Units.h"

namespace restenosis {

/// Every key a scene may have, by section: kind, unit, default, what is allowed, source of the default,
/// meaning. As aligned text for a terminal.
std::string schemaText(const Units& units);

/// The same as Markdown: a heading and a table for each section.
std::string schemaMarkdown(const Units& units);

}  // namespace restenosis
