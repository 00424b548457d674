#include "bridge/flow/foam/AttemptLogs.h"

#include "bridge/flow/foam/FoamBeats.h"
#include "bridge/flow/foam/FoamLog.h"

namespace restenosis {

namespace fs = std::filesystem;

std::map<fs::path, std::string> attemptLogs(const fs::path& caseFolder, std::string_view into) {
  std::map<fs::path, std::string> logs;
  const auto take = [&](const fs::path& folder, std::string_view place) {
    if (!fs::is_directory(folder)) return;
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().filename().string().starts_with("log."))
        logs[fs::path(place) / entry.path().filename()] = foamLog::read(entry.path());
  };
  for (const std::string_view kept : {movedMeshLogs, oGridLogs, firstAttemptLogs, secondAttemptLogs})
    take(caseFolder / kept, kept);
  take(caseFolder, into);
  take(caseFolder / beatsFolder, into);
  return logs;
}

}  // namespace restenosis
