#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "tissue/biology/ContactInhibitionParameters.h"
#include "tissue/neighbours/ContactNeighbour.h"

namespace restenosis {

/// What a law reads of a cell.
struct Surroundings {
  double radius;  ///< of the cell itself [m]
  bool exposed;   ///< by the exposure measure, with the scene's threshold
  std::span<const ContactNeighbour>
      neighbours;     ///< at least all within range() times R1 + R2, in no stated order
  double stress = 0;  ///< AgentStore::stress of the cell [Pa]; given to a law that readsStress() only
};

/// Whether a cell's surroundings keep it from cycling (model 6). Laws are stateless; the order of the
/// neighbours must not change an answer, not even by rounding.
class ContactInhibitionLaw {
 public:
  virtual ~ContactInhibitionLaw() = default;
  /// Neighbours farther than this times R1 + R2 matter through Surroundings::exposed only.
  virtual double range() const = 0;
  /// Whether the cell's stress decides, and its neighbours do not: it is then asked in every evaluation.
  virtual bool readsStress() const { return false; }
  virtual bool inhibits(const Surroundings& surroundings) const = 0;
};

/// All laws. To add one, write its file and an entry of the table in ContactInhibitionLaw.cpp.
std::vector<std::string_view> contactInhibitionLawNames();
/// The law called `parameters.law`. Throws std::invalid_argument, with the known names, for an unknown one.
std::unique_ptr<const ContactInhibitionLaw> makeContactInhibitionLaw(
    const ContactInhibitionParameters& parameters);

}  // namespace restenosis
