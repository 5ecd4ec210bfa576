#pragma once
/// The fast engine: refinement of a control mesh by a fixed number of steps, many times as fast
/// as the plain engine (refine/refine.h), whose results it gives to rounding, for every scheme of
/// a split that has a family (families/family.h).
///
/// The finer the mesh, the more of it is regular: it falls into patches, whose insides need a few
/// stencils and whose connectivity is arithmetic. Nothing is typed in for a scheme: all stencils
/// are read by refining linear forms with the plain engine (stencil_tables.h), which also makes the
/// first steps where rules look farther than a control edge: their sums are then written down
/// (plain_rows.h). Topology is worked out once; positions may be evaluated often.
///
/// Numbers of the refined mesh: see grid_layout.h, grid_family.h and kites.h. Where a split
/// keeps the old vertices, control vertices keep their numbers, so vertex v < V is the image of
/// control vertex v; the vertices of the levels in between do not come first. The order is another
/// than the plain engine's.

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "limn/mesh/sharpness/sharpness.h"
#include "limn/scheme/scheme.h"

namespace limn {
namespace fast {
class FastPieces;   // fast_pieces.h
class LimitReader;  // limit/limit_forms.h
}  // namespace fast

/// Whether there is a fast engine for the scheme. Not where its step is a sequence of averagings
/// (Scheme::stages): how far a place must lie from what is irregular is read from rules' walks.
[[nodiscard]] bool has_fast_layout(const Scheme& scheme);

/// Why the fast engine does not take a mesh with this sharpness, though the scheme can
/// (check_takes_sharpness, refine/crease_step.h): "its split … ". Nothing where it does. Cost
/// O(control mesh), and sometimes 1 ms.
[[nodiscard]] std::optional<std::string> why_no_fast_sharpness(const Scheme& scheme,
                                                               const Mesh& control,
                                                               const Sharpness& sharpness);

/// A control mesh's topology, worked out for a scheme and a number of steps.
class FastRefiner {
 public:
  /// Precondition: has_fast_layout(scheme); `scheme` must outlive the refiner. Fails as
  /// `refine` (refine.h) does, with the same errors but for the memory that it says is needed, and
  /// where there is a reason why_no_fast_sharpness. Faces that are holes are refined as others.
  /// Cost: reading the tables, some 0.1 ms for each valence that is in the mesh and for each kind
  /// of place where something is sharp, the plain steps, and for each further level some 0.1 µs a
  /// control vertex.
  [[nodiscard]] static Result<FastRefiner> make(const Scheme& scheme, Mesh control, int levels,
                                                Sharpness sharpness = {});

  FastRefiner(FastRefiner&&) noexcept;             ///< the other may then only be destroyed
  FastRefiner& operator=(FastRefiner&&) noexcept;  ///< as the constructor
  ~FastRefiner();

  [[nodiscard]] Index vertex_count() const;      ///< of the refined mesh
  [[nodiscard]] Index face_count() const;        ///< of the refined mesh
  [[nodiscard]] Index corner_count() const;      ///< of all faces together
  [[nodiscard]] Index corners_per_face() const;  ///< or 0 where faces differ
  /// How many of the steps the plain engine makes: as a rule 0 or 1; all of them, where
  /// the rules look too far, or a vertex has fewer than 3 (of quads: 2) or more than 1000 faces
  /// round it. Of other polygons than quads, a split that takes them leaves the first to it.
  [[nodiscard]] int plain_steps() const;

  /// Memory for intermediate levels, kept from one evaluation to the next: a quarter of the
  /// result's. One is for one thread at a time.
  template <class Real>
  class Scratch {
   public:
    /// Without memory yet. Moved from, it may only be assigned or destroyed.
    Scratch();
    /// The refined points that evaluate_limit made last on the way to their limits, x, y, z of
    /// each; longer by what another refiner needed.
    [[nodiscard]] std::span<const Real> refined() const;

   private:
    friend class FastRefiner;
    struct Arrays;
    struct Free {
      void operator()(Arrays* arrays) const noexcept;
    };
    std::unique_ptr<Arrays, Free> arrays_;
  };

  /// Positions of the refined vertices from those of the control vertices: x, y, z of each, one
  /// after the other; `fine` holds 3 · vertex_count() numbers and does not overlap `control`. Sums
  /// are made in `Real`, float or double, each by one thread in a fixed order, so one thread and
  /// many give the same bits. Not-a-numbers pass through.
  template <class Real>
  void evaluate(std::span<const Real> control, std::span<Real> fine, Scratch<Real>& scratch) const;
  /// The same with memory of its own, for one evaluation.
  template <class Real>
  void evaluate(std::span<const Real> control, std::span<Real> fine) const {
    Scratch<Real> scratch;
    evaluate(control, fine, scratch);
  }

  /// The limit surface at the refined vertices; built once, evaluated often.
  class Limit {
   public:
    Limit(Limit&&) noexcept;             ///< the other may then only be destroyed
    Limit& operator=(Limit&&) noexcept;  ///< as the constructor
    ~Limit();
    [[nodiscard]] std::size_t bytes() const;  ///< what it holds

   private:
    friend class FastRefiner;
    friend class fast::FastPieces;
    struct Plan;
    explicit Limit(std::unique_ptr<const Plan> plan);
    std::unique_ptr<const Plan> plan_;
  };
  /// `reader` knows the limit surface (fast/limit/limit_forms.h). Nothing where it looks too far
  /// for so few levels (sums over two rings need control edges cut into 4 or 8), a normal at a
  /// regular vertex is not that of two sums, or something is still sharp. Fails as `reader`.
  [[nodiscard]] Result<std::optional<Limit>> limit(fast::LimitReader& reader) const;

  /// Limit positions and unit normals at the refined vertices from the positions of the control
  /// vertices; arrays as for `evaluate`. A normal is zero where the tangents are parallel. The
  /// tangents are differences of neighbours, so that floats lose half a digit a level.
  template <class Real>
  void evaluate_limit(const Limit& limit, std::span<const Real> control, std::span<Real> positions,
                      std::span<Real> normals, Scratch<Real>& scratch) const;

  /// The refined faces' vertices, face by face: corner_count() of them.
  void write_faces(std::span<Index> corners) const;
  /// Where each face's corners begin, and where the last one's end: face_count() + 1 numbers.
  void write_face_begin(std::span<Index> begin) const;

  /// The control face that each refined face lies in: face_count() of them. Precondition: the split
  /// refines the boundary in every step and is no dual one.
  void write_parents(std::span<Index> faces) const;

  /// What of the refined mesh is still sharp, as tags_of (mesh/sharpness/sharpness.h) has it.
  [[nodiscard]] SharpnessTags sharp_tags() const;

  /// What the refiner itself holds, in bytes.
  [[nodiscard]] std::size_t bytes() const;

 private:
  friend class fast::FastPieces;
  struct State;
  explicit FastRefiner(std::unique_ptr<State> state);
  std::unique_ptr<const State> state_;
};

/// The refined faces, with these positions (one per vertex).
[[nodiscard]] Polygons refined_polygons(const FastRefiner& refiner, std::vector<Point3> positions);

/// The refined mesh as polygons. Fails as FastRefiner::make.
[[nodiscard]] Result<Polygons> fast_refine(const Scheme& scheme, Mesh control,
                                           const std::vector<Point3>& positions, int levels);

// Limit positions and normals.

/// The limit of a refiner of this scheme, for FastRefiner::evaluate_limit, from
/// approx_limit_stencil and approx_boundary_limit_stencil: the points of approx_limit_points
/// (limit_points.h), much faster. Nothing where the refiner takes none (FastRefiner::limit); ask
/// approx_limit_points then. Fails as the stencils. Cost: a stencil for each valence in the mesh.
[[nodiscard]] Result<std::optional<FastRefiner::Limit>> approx_fast_limit(
    const Scheme& scheme, const FastRefiner& refiner);

/// A refined mesh with limit positions and unit normals at its vertices.
struct FastLimitMesh {
  Polygons refined;             ///< with the points where refinement puts them
  std::vector<Point3> limit;    ///< one for each vertex
  std::vector<Point3> normals;  ///< of length 1, or zero; one for each vertex
};
/// All of it, from the positions of the control vertices. Nothing and failure as approx_fast_limit.
[[nodiscard]] Result<std::optional<FastLimitMesh>> approx_fast_limit_mesh(
    const Scheme& scheme, const FastRefiner& refiner, const std::vector<Point3>& positions);

}  // namespace limn
