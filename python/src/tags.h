#pragma once
/// Sharpness of a mesh as arrays of Python, in and out.

#include <pybind11/pybind11.h>

#include "limn/mesh/mesh.h"
#include "limn/mesh/sharpness/tags.h"

namespace limn::python {

namespace py = pybind11;

/// From a dict with any of: "creases" (n, 2) ends of edges, "crease_sharpness" one number or one
/// for each, "corners" (n), "corner_sharpness", "holes" (n) faces. None is as what is not there.
[[nodiscard]] SharpnessTags tags_of(const py::dict& dict);

/// The dict; only what there is in it.
[[nodiscard]] py::dict tags_dict(const SharpnessTags& tags);

/// What else says what is sharp.
struct SharpnessRules {
  double crease_angle = -1;  ///< degrees; below 0: none
  std::string boundary;      ///< of boundary_modes; empty: edgeOnly
  std::string method;        ///< of crease_methods; empty: uniform
};

/// Of a mesh at these points. Raises MeshError.
[[nodiscard]] Sharpness sharpness_of(const Mesh& mesh, const std::vector<Point3>& points,
                                     const SharpnessTags& tags, const SharpnessRules& rules);

}  // namespace limn::python
