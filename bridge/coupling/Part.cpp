#include "bridge/coupling/Part.h"

#include <algorithm>

namespace restenosis {

bool Part::isPurpose(const Instant&) const { return false; }

bool Part::appliesAt(const Instant&) const { return true; }

Verdict Part::needs(Quantity, const Instant&) const { return Verdict::run(); }

Verdict Part::inputsChanged(const Instant&) const { return Verdict::run(); }

bool Part::hasNewInput() const {
  return std::ranges::any_of(reads_, [&](Quantity quantity) {
    return seen_[static_cast<std::size_t>(quantity)] != quantities_.changes(quantity) + 1;
  });
}

void Part::noteInputs() {
  for (const Quantity quantity : reads_)
    seen_[static_cast<std::size_t>(quantity)] = quantities_.changes(quantity) + 1;
}

}  // namespace restenosis
