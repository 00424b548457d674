#include "bridge/flow/foam/MpiLauncher.h"

#include <cstdlib>
#include <sstream>

namespace restenosis {

std::vector<std::string> mpiLauncher() {
  const char* given = std::getenv(launcherVariable);
  std::istringstream text(given ? given : "");
  std::vector<std::string> words;
  for (std::string word; text >> word;) words.push_back(word);
  if (words.empty()) words.emplace_back("mpirun");
  return words;
}

}  // namespace restenosis
