#include "limn/report/eigen/eigen_figures.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace limn::report {

figure::SurfacePanel characteristic_map_panel(const CharacteristicMap& map,
                                              const std::string& title) {
  figure::SurfacePanel panel;
  panel.title = title;
  panel.azimuth = -90;  // x to the right, y up
  panel.elevation = 90;
  panel.mesh_lines = true;
  const auto array = [](const Point3& p) { return std::array<double, 3>{p.x, p.y, p.z}; };
  for (const Point3& p : map.image.positions) panel.vertices.push_back(array(p));
  const Mesh& fine = map.image.mesh;
  for (Index f = 0; f < fine.face_count(); ++f) {
    std::vector<int> face;
    for (Index h = fine.face_begin(f); h < fine.face_begin(f + 1); ++h)
      face.push_back(fine.origin(h));
    panel.faces.push_back(std::move(face));
  }
  for (const Point3& p : map.net_points) panel.net_vertices.push_back(array(p));
  for (Index e = 0; e < map.net.edge_count(); ++e) {
    const Index h = map.net.halfedge_of_edge(e);
    panel.net_edges.push_back({map.net.origin(h), map.net.target(h)});
  }
  return panel;
}

figure::Figure characteristic_maps_figure(const std::string& scheme,
                                          const std::vector<CharacteristicMap>& maps) {
  constexpr int kColumns = 4;
  figure::Figure figure(std::clamp(static_cast<int>(maps.size()), 1, kColumns));
  figure.title(fmt::format("Characteristic maps of {}", scheme));
  for (const CharacteristicMap& map : maps)
    figure.add(characteristic_map_panel(map, fmt::format("/{{n}} = {}", map.valence)),
               fmt::format("λ = {:.6f}; {}", map.eigenvalue,
                           map.regular == Truth::yes  ? "no fold in samples"
                           : map.regular == Truth::no ? "folds"
                                                      : "undecided"));
  return figure;
}

figure::ChartPanel eigenvalue_panel(const DataTable& table, const std::string& title) {
  figure::ChartPanel panel;
  panel.title = title;
  panel.x_label = "valence /{n}";
  panel.y_low = 0;
  const std::vector<std::string> names{"tangent", "tangent²", "cup", "saddle", "largest other"};
  bool moduli = has_complex(table);
  for (std::size_t column = 1; column <= names.size(); ++column) {
    figure::ChartPanel::Series series{.name = names[column - 1], .markers = true};
    for (const std::vector<double>& row : table.rows) {
      moduli = moduli || row[column] < 0;
      series.x.push_back(row[0]);
      series.y.push_back(std::abs(row[column]));
    }
    panel.series.push_back(std::move(series));
  }
  panel.y_label = moduli ? "modulus of the eigenvalue" : "eigenvalue";
  return panel;
}

figure::Figure eigenvalue_figure(const std::string& scheme, const DataTable& table) {
  constexpr double kWidth = 300;
  figure::Figure figure(1, kWidth);
  figure.add(eigenvalue_panel(table, scheme));
  return figure;
}

}  // namespace limn::report
