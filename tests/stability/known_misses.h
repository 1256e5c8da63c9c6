#pragma once

#include <map>
#include <string>
#include <vector>

namespace rouleau::stability {

/// The scenes whose brief form breaks a bound, and which quantities may. A scene that is mended comes off
/// this list: the test fails until it does.
inline const std::map<std::string, std::vector<std::string>> known_misses{
    {"closed_80_cell", {"outcome", "area", "crossing_edges", "divergence", "wrong_side"}},
    {"apex", {"outcome", "area", "crossing_edges", "divergence", "wrong_side"}},
    {"nearly_touching", {"outcome", "area", "crossing_edges", "divergence", "wrong_side"}},
    {"touching_thrombus", {"outcome", "area", "crossing_edges", "divergence", "wrong_side"}},
    {"reynolds_100", {"outcome", "area", "crossing_edges", "divergence", "wrong_side"}},
    {"plug_inlet", {"divergence"}},
    {"inflow_x10", {"area", "crossing_edges", "divergence", "wrong_side"}},
    {"inflow_pulsating", {"area", "divergence"}},
    {"spacing_x2", {"divergence"}},
};

}  // namespace rouleau::stability
