#include "Part.h"

namespace restenosis {

Verdict Part::needs(Quantity, const Instant&) const { return Verdict::run(); }

Verdict Part::inputsChanged(const Instant&) const { return Verdict::run(); }

}  // namespace restenosis
