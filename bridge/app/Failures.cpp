#include "Failures.h"

#include <fmt/format.h>

#include <iostream>
#include <stdexcept>

#include "Checkpoint.h"
#include "ComparedLumen.h"
#include "ExitStatus.h"
#include "FlowBackend.h"
#include "ResultsFolder.h"
#include "Run.h"

namespace restenosis {

int exitStatusOf(const std::function<int()>& work, const Advice& advice) {
  try {
    return work();
  } catch (const FolderRefused& error) {
    std::cerr << error.what() << '\n';
    return ExitStatus::wrongInput;
  } catch (const LumenRefused& error) {
    std::cerr << error.what() << '\n';
    return ExitStatus::wrongInput;
  } catch (const CheckpointRefused& error) {
    std::cerr << error.what();
    if (error.reason == CheckpointRefused::Reason::foreign && advice.foreignCheckpoint)
      std::cerr << "; " << advice.foreignCheckpoint();
    std::cerr << '\n';
    return ExitStatus::wrongInput;
  } catch (const FlowFailed& error) {
    std::cerr << fmt::format("\nThe flow failed: {}\n", error.what());
    if (!error.log.empty()) std::cerr << fmt::format("Read {}. ", error.log.string());
    std::cerr << advice.flowFailed << '\n';
  } catch (const Interrupted&) {
    std::cerr << fmt::format("\n{}\n", advice.interrupted);
  } catch (const std::exception& error) {
    std::cerr << fmt::format("\n{}\n", error.what());
  }
  return ExitStatus::failed;
}

}  // namespace restenosis
