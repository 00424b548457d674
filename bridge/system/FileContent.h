#pragma once

#include <filesystem>
#include <string>

namespace restenosis {

/// All bytes of a file. Throws std::runtime_error, naming it, where it cannot be read to its end.
std::string contentOf(const std::filesystem::path& file);

}  // namespace restenosis
