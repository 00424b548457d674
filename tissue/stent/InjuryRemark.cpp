#include "tissue/stent/InjuryRemark.h"

#include <fmt/format.h>

namespace restenosis {
namespace {

std::string causeOf(const InjuryReport& injury, const InjuryParameters& parameters) {
  if (injury.iel == 0) return "no agent of the IEL may be injured (fixed ends, injury.endMargin)";
  if (injury.ielBonds == 0)
    return "the IEL has no bonds, from which its stretch is computed (vessel.bondRange)";
  if (injury.stretched == 0)
    return fmt::format(
        "the IEL is nowhere stretched by more than {:.3g} (injury.stretchedStrain; its most strained bond by "
        "{:.3g}), which is what a stent does{}",
        parameters.stretchedStrain, injury.largestStrain,
        parameters.ielBreaks && parameters.stressLimit > 0 ? ", nor is its stress past injury.stressLimit"
                                                           : "");
  return fmt::format(
      "of {} stretched agents of the IEL none was fenestrated (injury.fenestrationProbability = {:.3g})",
      injury.stretched, parameters.fenestrationProbability);
}

}  // namespace

std::string remarkOnInjury(const InjuryReport& injury, const InjuryParameters& parameters) {
  if (injury.synthetic > 0) return {};
  return fmt::format("[injury] made no cell synthetic, so none can cycle: {}", causeOf(injury, parameters));
}

}  // namespace restenosis
