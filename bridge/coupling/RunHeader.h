#pragma once

#include <filesystem>
#include <string>

#include "bridge/scene/Scene.h"

namespace restenosis {

/// What a run is told beside its scene, for its header.
struct RunPlace {
  int threads = 1;
  int ranks = 1;  ///< processes of the flow solver
  std::filesystem::path results;
};

/// What is about to run, in three lines: version; scene and title; flow, threads and folder.
std::string runHeader(const Scene& scene, const RunPlace& place);

}  // namespace restenosis
