#include "bridge/app/BenchCommand.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "bridge/app/ContactBench.h"
#include "bridge/app/ExitStatus.h"
#include "bridge/app/LatticeBench.h"

namespace restenosis {
namespace {

struct Bench {
  std::string name;
  void (*run)(std::ostream&);
};

const std::array<Bench, 2> benches{{{"contact", &benchContact}, {"lbm", &benchLattice}}};

}  // namespace

void addBenchCommand(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("bench", "throughput of the kernels beside this machine's limits");
  std::vector<std::string> names;
  std::ranges::transform(benches, std::back_inserter(names), &Bench::name);
  auto chosen = std::make_shared<std::string>();
  command->add_option("NAME", *chosen, "kernel (default: all)")->check(CLI::IsMember(names));
  command->callback([chosen, &status] {
    for (const Bench& bench : benches) {
      if (chosen->empty() || *chosen == bench.name) bench.run(std::cout);
    }
    status = ExitStatus::done;
  });
}

}  // namespace restenosis
