#pragma once

#include <filesystem>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// Writes the closed surface of the struts (StrutSurface.h) [m], without arrays; they stand still, so that
/// one file is enough for all days. Throws WriteFailed.
void writeStruts(const std::filesystem::path& file, const TriSurface& struts);

}  // namespace restenosis
