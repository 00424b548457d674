#include "bridge/app/Failures.h"

#include <fmt/format.h>

#include <iostream>
#include <new>
#include <stdexcept>

#include "bridge/app/ComparedLumen.h"
#include "bridge/app/ExitStatus.h"
#include "bridge/flow/FlowBackend.h"
#include "bridge/output/ResultsFolder.h"
#include "tissue/parameters/CsvLines.h"

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
  } catch (const TableError& error) {
    std::cerr << error.what() << '\n';
    return ExitStatus::wrongInput;
  } catch (const CheckpointRefused& error) {
    std::cerr << error.what();
    if (error.reason == CheckpointRefused::Reason::foreign && advice.foreignCheckpoint)
      std::cerr << "; " << advice.foreignCheckpoint(error);
    std::cerr << '\n';
    return ExitStatus::wrongInput;
  } catch (const FlowFailed& error) {
    std::cerr << fmt::format("\nThe flow failed: {}\n", error.what());
    if (!error.log.empty()) std::cerr << fmt::format("Read {}. ", error.log.string());
    std::cerr << advice.flowFailed << '\n';
  } catch (const Interrupted& error) {
    std::cerr << fmt::format("\n{}\n", advice.interrupted(error));
  } catch (const std::bad_alloc&) {
    std::cerr
        << "\nout of memory: a coarser coupling.surfaceResolution, mesh or lattice, or a smaller vessel "
           "needs less\n";
  } catch (const std::exception& error) {
    std::cerr << fmt::format("\n{}\n", error.what());
  }
  return ExitStatus::failed;
}

}  // namespace restenosis
