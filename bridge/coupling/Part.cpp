#include "bridge/coupling/Part.h"

namespace restenosis {

bool Part::isPurpose(const Instant&) const { return false; }

bool Part::appliesAt(const Instant&) const { return true; }

Verdict Part::needs(Quantity, const Instant&) const { return Verdict::run(); }

Verdict Part::inputsChanged(const Instant&) const { return Verdict::run(); }

}  // namespace restenosis
