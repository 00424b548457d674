#include "bridge/flow/foam/FoamSteps.h"

#include <fmt/format.h>

#include <csignal>

#include "bridge/flow/foam/FoamLog.h"
#include "bridge/flow/foam/FoamRequirements.h"
#include "bridge/system/AtomicFile.h"

namespace restenosis {

namespace fs = std::filesystem;

FoamStepFailed::FoamStepFailed(std::string what, fs::path logFile)
    : FlowFailed(fmt::format("{} (see {})", what, logFile.string()), logFile), problem(std::move(what)) {}

std::string FoamStepFailed::withLogIn(const fs::path& folder) const {
  return fmt::format("{} (see {})", problem, (folder / log.filename()).string());
}

void FoamSteps::fail(const std::string& program, const std::string& reason) const {
  requireRoomAfter(program);
  throw FoamStepFailed(fmt::format("{}: {}", program, reason), log(program));
}

void FoamSteps::requireRoomAfter(const std::string& program) const {
  try {
    requireRoom(folder_);
  } catch (const WriteFailed& full) {
    throw WriteFailed(fmt::format("{} failed: {}", program, full.what()));
  }
}

double FoamSteps::run(const std::string& program, const std::vector<std::string>& arguments, On on) const {
  ProgramExit exit;
  try {
    const auto start = on == On::allRanks ? runFoamOnRanks : runFoam;
    exit = start(program, arguments, execution_, folder_, log(program));
  } catch (const ProgramMissing& missing) {
    throw FlowFailed(missingProgramText(missing.program), {});
  } catch (const std::runtime_error& error) {
    requireRoomAfter(program);
    throw FlowFailed(fmt::format("{}: {}", program, error.what()), {});  // not started: there is no log
  }
  if (exit.interrupted())
    throw FlowFailed(fmt::format("{} was interrupted: {}", program, exit.describe()), log(program));
  if (exit.silent)
    throw FlowFailed(fmt::format("{} hangs: its log has not grown for {:.4g} min (foam.silenceLimit), so it "
                                 "was ended",
                                 program, execution_.silenceLimit->count() / 60),
                     log(program));
  if (exit.signal == SIGKILL) {
    requireRoomAfter(program);
    throw FlowFailed(fmt::format("{} was killed from outside, or by the system because memory ran out: {}",
                                 program, exit.describe()),
                     log(program));
  }
  if (exit.succeeded()) return exit.seconds;
  const auto reason = foamLog::fatalError(foamLog::read(log(program)));
  fail(program, reason ? fmt::format("{}: {}", exit.describe(), *reason) : exit.describe());
}

std::vector<fs::path> FoamSteps::parts() const {
  if (!execution_.parallel()) return {folder_};
  std::vector<fs::path> folders;
  for (int rank = 0; rank < execution_.ranks; ++rank)
    folders.push_back(folder_ / fmt::format("processor{}", rank));
  return folders;
}

}  // namespace restenosis
