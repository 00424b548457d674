#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace restenosis {

/// What no input file may exceed [bytes], assumed: a table of the most agents that a wall may have.
constexpr std::uintmax_t largestFile = std::uintmax_t{2} << 30;

/// What keeps a path from being read as a file, as the rest of a sentence that begins with it: that it is not
/// there, is a folder, a pipe, a device or a socket, which may never end, or holds more than `most` bytes.
/// Empty where nothing is known to.
std::string fileObstacle(const std::filesystem::path& file, std::uintmax_t most = largestFile);

/// All bytes of a file. Throws std::runtime_error, which begins with its name, where something of
/// `fileObstacle` keeps it from being read, or it cannot be read to its end. Never waits for what a pipe or a
/// device may bring.
std::string contentOf(const std::filesystem::path& file, std::uintmax_t most = largestFile);

}  // namespace restenosis
