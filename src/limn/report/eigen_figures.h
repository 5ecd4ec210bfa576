#pragma once
/// Characteristic maps drawn: `limn eigen --map`.

#include <string>
#include <vector>

#include "limn/extraordinary/characteristic_map.h"
#include "limn/report/figure/figure.h"

namespace limn {

/// The image of the faces round the vertex as a fine net, and the control net over it in black.
[[nodiscard]] SurfacePanel characteristic_map_panel(const CharacteristicMap& map,
                                                    const std::string& title);

/// A page of them, four to a row, each under its valence.
[[nodiscard]] Figure characteristic_maps_figure(const std::string& scheme,
                                                const std::vector<CharacteristicMap>& maps);

}  // namespace limn
