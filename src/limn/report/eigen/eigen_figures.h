#pragma once
/// Characteristic maps and eigenvalues drawn: `limn eigen --map` and `--chart`.

#include <string>
#include <vector>

#include "limn/figure/figure.h"
#include "limn/limit/characteristic_map.h"
#include "limn/report/eigen/eigen_table.h"

namespace limn::report {

/// The image of the faces round the vertex as a fine net, and the control net over it in black.
[[nodiscard]] figure::SurfacePanel characteristic_map_panel(const CharacteristicMap& map,
                                                            const std::string& title);

/// A page of them, four to a row, each under its valence.
[[nodiscard]] figure::Figure characteristic_maps_figure(const std::string& scheme,
                                                        const std::vector<CharacteristicMap>& maps);

/// The moduli of eigenvalue_table's columns over the valence; the axis says that they are moduli
/// where some eigenvalue is complex or negative.
[[nodiscard]] figure::ChartPanel eigenvalue_panel(const DataTable& table, const std::string& title);

/// A page of that panel alone.
[[nodiscard]] figure::Figure eigenvalue_figure(const std::string& scheme, const DataTable& table);

}  // namespace limn::report
