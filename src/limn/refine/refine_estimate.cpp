#include "limn/refine/refine_estimate.h"

#include <algorithm>

#include <fmt/core.h>

#include "limn/base/memory.h"

namespace limn::refine {
namespace {

constexpr double kLargestHalfedgeCount = 2147483647.0;

/// Counts of a mesh; what a split does to them is linear.
struct Counts {
  double vertices = 0, edges = 0, faces = 0, halfedges = 0;
  double triangles = 0;  // of the faces; counted for splits that are mixed
};

double triangles_of(const Mesh& mesh) {
  if (mesh.uniform_degree() > 0) return mesh.uniform_degree() == 3 ? mesh.face_count() : 0;
  Index count = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) count += mesh.degree(f) == 3 ? 1 : 0;
  return count;
}

/// After one step, an upper bound: exact but for the boundaries of dual splits, which lose faces,
/// and where a mesh at an odd step is not one that an even step has made.
Counts after_step(const Split& split, const Counts& c, int step) {
  Counts r;
  if (split.births.thirds) {
    r.vertices = c.vertices + 2 * c.edges + (split.births.faces ? c.faces : 0) +
                 (split.births.corners ? c.halfedges : 0);
    r.faces = 9 * c.faces;
    r.halfedges = 9 * c.halfedges;
    r.edges = 3 * (c.edges + c.halfedges);
    return r;
  }
  if (split.is_dual() && split.births.edges) {
    // even steps close each boundary vertex by a face, odd ones lose these and have up to three
    // boundary edges for one
    const double boundary = 2 * c.edges - c.halfedges;
    const bool closes = step % 2 == 0;
    r.vertices = c.edges;
    r.faces = c.vertices + c.faces;
    r.halfedges = 2 * c.halfedges + (closes ? boundary : 0);
    r.edges = c.halfedges + (closes ? 1 : 1.5) * boundary;
    return r;
  }
  if (split.births.corners) {
    r.vertices = c.halfedges;
    r.faces = c.vertices + c.edges + c.faces;
    r.halfedges = 4 * c.halfedges;
    r.edges = 2 * c.halfedges;
    return r;
  }
  r.vertices = c.vertices + (split.births.edges ? c.edges : 0) + (split.births.faces ? c.faces : 0);
  const double boundary = 2 * c.edges - c.halfedges;
  const double cut = split.boundary_rests() && step % 2 == 1 ? boundary : 0;
  if (split.odd_step_cut == 3) {
    r.vertices += cut;  // two new vertices on a cut edge, none in its face
    r.faces = c.halfedges;
    r.halfedges = 3 * c.halfedges;
    r.edges = c.edges + c.halfedges + cut;
  } else if (split.odd_step_cut == 2) {  // a cut edge has the vertex of its face, and makes no face
    r.faces = c.edges - cut;
    r.halfedges = 4 * (c.edges - boundary) + 3 * (boundary - cut);
    r.edges = c.halfedges + boundary - cut;
  } else if (split.any_polygons) {
    r.faces = c.halfedges;
    r.halfedges = 4 * c.halfedges;
    r.edges = 2 * c.edges + c.halfedges;
    if (split.mixed) {  // a triangle has four children and no vertex
      r.vertices -= c.triangles;
      r.faces += c.triangles;
      r.triangles = 4 * c.triangles;
    }
  } else {
    r.faces = 4 * c.faces;
    r.halfedges = 12 * c.faces;
    r.edges = 2 * c.edges + 3 * c.faces;
  }
  return r;
}

double bytes_of(const Counts& c, std::size_t bytes_per_value) {
  constexpr double kIndex = sizeof(Index);
  const double mesh = kIndex * (5 * c.halfedges + c.edges + c.vertices + c.faces);
  return mesh + static_cast<double>(bytes_per_value) * c.vertices;
}

std::string size_text(double vertices, double faces, int levels) {
  return fmt::format("{} levels would make about {:.3g} vertices and {:.3g} faces", levels,
                     vertices, faces);
}

struct Forecast {
  Counts last;
  double peak_bytes = 0;
};

Forecast forecast(const Split& split, const Mesh& mesh, int levels, std::size_t bytes_per_value) {
  Counts counts{static_cast<double>(mesh.vertex_count()), static_cast<double>(mesh.edge_count()),
                static_cast<double>(mesh.face_count()), static_cast<double>(mesh.halfedge_count()),
                split.mixed ? triangles_of(mesh) : 0};
  Forecast result{counts, bytes_of(counts, bytes_per_value)};
  for (int i = 0; i < levels; ++i) {
    const Counts next = after_step(split, counts, i);
    result.peak_bytes = std::max(
        result.peak_bytes, bytes_of(counts, bytes_per_value) + bytes_of(next, bytes_per_value));
    counts = next;
  }
  result.last = counts;
  return result;
}

}  // namespace

RefineEstimate estimate_refinement(const Split& split, const Mesh& mesh, int levels,
                                   std::size_t bytes_per_value) {
  const Forecast result = forecast(split, mesh, levels, bytes_per_value);
  return {result.last.vertices, result.last.faces, result.peak_bytes};
}

std::string text_of(const RefineEstimate& estimate, int levels) {
  return fmt::format(
      "{} level{} make about {:.3g} vertices and {:.3g} faces, in about {} of memory", levels,
      levels == 1 ? "" : "s", estimate.vertices, estimate.faces,
      base::bytes_text(estimate.peak_bytes));
}

Status check_memory(const RefineEstimate& estimate, int levels, double memory_limit) {
  if (estimate.peak_bytes <= memory_limit) return Done{};
  return Error{fmt::format("{} and need about {} of memory; {} are free",
                           size_text(estimate.vertices, estimate.faces, levels),
                           base::bytes_text(estimate.peak_bytes), base::bytes_text(memory_limit)),
               "use fewer levels"};
}

namespace {

/// That all faces are the lattice's where the split takes no others.
Status check_faces(const Scheme& scheme, const Mesh& mesh) {
  const bool triangles = scheme.split->lattice == Lattice::triangle;
  const Index corners = triangles ? 3 : 4;
  if (scheme.split->any_polygons || mesh.uniform_degree() == corners) return Done{};
  for (Index f = 0; f < mesh.face_count(); ++f)
    if (mesh.degree(f) != corners)
      return Error{
          fmt::format("scheme '{}' refines {}, but face {} has {} corners", scheme.name,
                      triangles ? "triangles" : "quads", f, mesh.degree(f)),
          triangles ? "--triangulate cuts polygons into triangles"
                    : "one step of catmull-clark (-n 1) makes a mesh of quads from any polygons"};
  return Done{};
}

}  // namespace

Status check_refinable(const Scheme& scheme, const Mesh& mesh, int levels,
                       std::size_t bytes_per_value, double memory_limit) {
  const Split& split = *scheme.split;
  if (levels < 0) return Error{fmt::format("{} is no number of levels", levels), "give 0 or more"};
  if (Status status = check_faces(scheme, mesh); !status) return status;
  const Forecast result = forecast(split, mesh, levels, bytes_per_value);
  if (result.last.halfedges > kLargestHalfedgeCount)
    return Error{
        size_text(result.last.vertices, result.last.faces, levels) + ", more than 2^31 half-edges",
        "use fewer levels"};
  return check_memory({result.last.vertices, result.last.faces, result.peak_bytes}, levels,
                      memory_limit);
}

}  // namespace limn::refine
