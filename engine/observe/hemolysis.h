#pragma once

#include "engine/observe/observer.h"

namespace rouleau::observe {

/// The power law of hemolysis, index = factor stress^alpha time^beta, along a path on which the stress
/// changes: with the dose D = integral of stress^(alpha/beta) dt the index is factor D^beta, which for a
/// constant stress is the law and never falls (Goubergrits and Affeld, Artif. Organs 28, 499 (2004); Garon
/// and Farinas, Comput. Methods Biomech. Biomed. Eng. 7, 291 (2004)). The index is a fraction of the
/// hemoglobin, stress in Pa, time in s.
struct HemolysisLaw {
  double factor;
  double stress_exponent;
  double time_exponent;

  double dose(double stress, double time) const;
  double index(double dose) const;
};

/// The constants that the case gives, else those of Giersiepen et al., Int. J. Artif. Organs 13, 300 (1990).
HemolysisLaw hemolysis_law(const Case& scene);

/// Hemolysis index of each cell along its path, by the scalar shear stress of the plasma around it.
extern const ObserverKind hemolysis;

}  // namespace rouleau::observe
