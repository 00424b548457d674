#pragma once

#include <filesystem>
#include <vector>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// A lumen that a run has recorded.
struct RecordedLumen {
  double day;
  std::filesystem::path file;
};

/// The lumens that `lumen.pvd` in a results folder names, in the order of time. Throws std::runtime_error
/// where it is missing or names none.
std::vector<RecordedLumen> recordedLumens(const std::filesystem::path& results);

/// The recorded lumen nearest to a day. `lumens` must not be empty.
const RecordedLumen& lumenOfDay(const std::vector<RecordedLumen>& lumens, double day);

/// Reads a lumen that writeLumen has written, the open tube of wall and struts, and closes its ends with
/// planar caps: inlet and outlet where the file says they are; of a file of a former version, which does not,
/// the inlet is the end at the lower z. Throws std::runtime_error where the file cannot be read or its rims
/// are not the ends of a tube.
TriSurface readLumen(const std::filesystem::path& file);

}  // namespace restenosis
