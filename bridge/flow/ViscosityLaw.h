#pragma once

namespace restenosis {

/// How the kinematic viscosity of blood that thins goes with its shear rate (docs/model/flow.md).
struct ViscosityLaw {
  enum class Kind { carreau, casson };
  Kind kind = Kind::carreau;
  double zeroShear = 5.6e-5;       ///< at no shear: of Carreau, and the most of Casson [m^2/s]
  double infiniteShear = 3.45e-6;  ///< at infinite shear: of Carreau; the plastic one of Casson [m^2/s]
  double time = 3.313;             ///< of Carreau [s]
  double index = 0.3568;           ///< of Carreau
  double yieldStress = 0;          ///< of Casson, over the density [m^2/s^2]

  /// At a shear rate [1/s], 0 or more [m^2/s].
  double operator()(double shearRate) const;
  /// The shear rate [1/s] at a stress over the density [m^2/s^2]: stress grows with it.
  double shearRateAt(double stress) const;

  /// The same law with a length [m] and a time [s] as units.
  ViscosityLaw in(double length, double unitTime) const;

  bool operator==(const ViscosityLaw&) const = default;
};

}  // namespace restenosis
