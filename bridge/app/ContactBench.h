#pragma once

#include <iosfwd>

namespace restenosis {

/// Packs a bonded wall of about 30,000 agents, as a run does, and measures the pair kernel and the neighbour
/// list on it for one thread and for all, beside what the machine can do at most. Prints a table.
void benchContact(std::ostream& out);

}  // namespace restenosis
