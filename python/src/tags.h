#pragma once
/// Sharpness of a mesh as arrays of Python, in and out.

#include <pybind11/pybind11.h>

#include <optional>
#include <vector>

#include "limn/mesh/mesh.h"
#include "limn/mesh/sharpness/sharpness.h"
#include "limn/scheme/scheme.h"

namespace limn::python {

namespace py = pybind11;

/// From a dict with any of: "creases" (n, 2) ends of edges, "crease_sharpness" one number or one
/// for each, "corners" (n), "corner_sharpness", "holes" (n) faces; and the words "boundary",
/// "crease_method" and "triangles". None is as what is not there. Raises MeshError.
[[nodiscard]] SharpnessTags tags_of(const py::dict& dict);

/// The dict; only what there is in it.
[[nodiscard]] py::dict tags_dict(const SharpnessTags& tags);

/// Edges whose faces' normals differ by more than this, with the mesh at these points.
struct CreaseAngle {
  double degrees = 0;
  const std::vector<Point3>& points;
};

/// What the tags mean for a mesh. Raises MeshError.
[[nodiscard]] Sharpness sharpness_of(const Mesh& mesh, const SharpnessTags& tags,
                                     const std::optional<CreaseAngle>& angle = {});

/// The scheme with its rule for smooth triangles, where the tags ask for these; else nothing.
/// Raises SchemeError where it has none.
[[nodiscard]] std::optional<Scheme> smoothed(const Scheme& scheme, const SharpnessTags& tags);

}  // namespace limn::python
