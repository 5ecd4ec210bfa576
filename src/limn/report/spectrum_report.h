#pragma once
/// Natural frequencies of a mesh, and how much of a surface lies at each of them [KS §3.1].

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "limn/fairness/spectrum.h"
#include "limn/figure/figure.h"
#include "limn/limit/limit_points.h"
#include "limn/scheme/scheme.h"

namespace limn::report {

/// The `count` ≥ 1 smallest and largest eigenvalues of the Laplacian of a mesh.
struct SpectrumEnds {
  std::vector<double> smallest, largest;  ///< both rising
};
[[nodiscard]] Result<SpectrumEnds> approx_spectrum_ends(const Mesh& mesh, int count);
/// {"smallest": […], "largest": […]}
[[nodiscard]] nlohmann::ordered_json spectrum_json(const SpectrumEnds& ends);
[[nodiscard]] std::string spectrum_text(const std::string& mesh, const SpectrumEnds& ends);

/// Values at the vertices of one mesh: the mesh itself, or where a scheme takes its vertices.
struct NamedPoints {
  std::string name;
  std::vector<Point3> points;
};

/// The limits of the control vertices; those that have none stay where they are
/// (LimitOptions::partial) and are told in `refused`. Fails as `approx_limit_points` does.
[[nodiscard]] Result<NamedPoints> limits_of_vertices(const std::string& label, const Scheme& scheme,
                                                     const Mesh& control,
                                                     const std::vector<Point3>& points,
                                                     std::vector<LimitPoints::Refused>& refused);

/// All natural frequencies of the mesh in order; and, for each of the points, the part of their
/// squared amplitude (the constant apart) at frequencies above l, against l. A scheme whose curve
/// lies higher passes more of the high frequencies. Fails as `approx_all_modes` does.
[[nodiscard]] Result<figure::Figure> spectrum_figure(const std::string& name, const Mesh& mesh,
                                                     const std::vector<NamedPoints>& points);

}  // namespace limn::report
