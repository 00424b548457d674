#pragma once

#include <span>
#include <string>

namespace restenosis {

/// Arguments as a user types them into a shell: those with characters that it reads for itself in quotes.
std::string shellCommand(std::span<const std::string> arguments);

}  // namespace restenosis
