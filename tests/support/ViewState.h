#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/Process.h"

namespace restenosis {

/// Whether what the pictures need is installed.
inline bool picturesPackagesPresent() {
  return std::system("/usr/bin/python3 -c 'import matplotlib, vtkmodules' >/dev/null 2>&1") == 0;
}

/// Has the state written for the results in `folder`, and checks it; the further arguments are
/// checkView.py's.
inline void checkView(const std::filesystem::path& folder, std::vector<std::string> arguments = {}) {
  const std::string figures = RESTENOSIS_SOURCE_DIR "/bridge/output/figures";
  const ProcessEnd written =
      Process({"/usr/bin/python3", "-I", "-B", figures, folder.string(), "view.pvsm"}, folder)
          .wait(std::chrono::seconds(60));
  ASSERT_EQ(written.status, 0) << toString(written);
  const std::string script = RESTENOSIS_SOURCE_DIR "/tests/regression/checkView.py";
  std::vector<std::string> command{"/usr/bin/python3", "-B", script, folder.string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  const ProcessEnd end = Process(command, folder).wait(std::chrono::seconds(300));
  EXPECT_EQ(end.status, 0) << toString(end);
}

}  // namespace restenosis
