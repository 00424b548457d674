#include "tissue/biology/ExtracellularMatrixParameters.h"

namespace restenosis {

void ExtracellularMatrixParameters::describe(ParameterVisitor& p) {
  p.quantity(rate, {.key = "rate",
                    .unit = "1/d",
                    .minimum = 0,
                    .maximum = 10000,
                    .source = "assumed",
                    .description = "volume of matrix that a fully activated synthetic cell lays down in that "
                                   "time, over its volume at birth"});
  p.quantity(largestShare, {.key = "largestShare",
                            .minimum = 0,
                            .maximum = 0.95,
                            .source = "assumed",
                            .description = "largest share of a cell and its matrix that is matrix"});
}

}  // namespace restenosis
