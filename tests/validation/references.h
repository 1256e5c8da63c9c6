#pragma once

#include <array>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace rouleau::validation {

/// An entry of references.json, which says what each number is and where it is from.
/// @throws std::out_of_range if there is none of this name
const nlohmann::json& reference(std::string_view name);

/// Pairs of a place and a value there.
using Table = std::vector<std::array<double, 2>>;

/// Closed forms. Between walls y runs from 0 to 1; time is in H^2/nu.

/// Over the speed of the upper wall, which starts at time 0 with the fluid at rest.
double couette_start(double y, double time);

/// Over the greatest velocity of the steady flow, to which a body's acceleration from time 0 leads.
double poiseuille_start(double y, double time);

/// Steady flow of mean 1.
double poiseuille(double y);

/// Flow between walls whose mean velocity is sin(phase).
/// @param womersley  (H/2) sqrt(omega/nu)
double womersley(double y, double phase, double womersley);

/// Velocity of the vortices over their greatest one, without their decay; x and y over the box's side.
std::array<double, 2> taylor_green(double x, double y);
/// By which their velocity decays.
/// @param viscosity  over the box's side and the unit of velocity
double taylor_green_decay_rate(double viscosity);

/// The share of the flow that a branch takes of two in parallel, each of resistance 12 mu L/D^3.
double network_share(double length, double diameter, double other_length, double other_diameter);

}  // namespace rouleau::validation
