#pragma once
/// A step of the plain engine (step_stencils.h, crease_stencils.h), written down once and made
/// often: for each new vertex a sparse row, of what it weighs and how much. Rows of equal weights
/// share them, so that a row is the number of its list of weights and the numbers of its sources:
/// some 12 of 4 bytes for a butterfly's edge.

#include <optional>
#include <vector>

#include "limn/fast/plain/weight_lists.h"
#include "limn/refine/crease_stencils.h"
#include "limn/refine/step_stencils.h"

namespace limn::fast {

class PlainRows {
 public:
  /// The rows of one step, for which `stencils` has prepared all. New vertex i gets the number
  /// places[i], or i where `places` is empty. Nothing where they would take more than `limit` bytes
  /// (`places` not counted). Cost: about that of refining points once, on all threads.
  [[nodiscard]] static std::optional<PlainRows> record(const refine::StepStencils<double>& stencils,
                                                       std::vector<Index> places,
                                                       std::size_t limit) {
    return record_any(stencils, std::move(places), limit);
  }
  /// The same of a mesh with sharpness.
  [[nodiscard]] static std::optional<PlainRows> record(
      const refine::CreaseStencils<double>& stencils, std::vector<Index> places,
      std::size_t limit) {
    return record_any(stencils, std::move(places), limit);
  }

  /// x, y, z of the old vertices, and a number more → those of the new ones. Sums are made in
  /// `Real`, float or double, each by one thread in a fixed order.
  template <class Real>
  void evaluate(const Real* old, Real* fresh) const;

  [[nodiscard]] Index vertex_count() const { return vertex_count_; }  ///< of the new ones
  [[nodiscard]] std::size_t bytes() const;

  /// The rows of new vertices first, first + 1, …: their lists, and their sources, row by row; a
  /// source that is a face's new vertex by the number that it gets.
  struct Chunk {
    Index first = 0;
    std::vector<Index> lists, sources;
  };

 private:
  PlainRows() = default;
  template <class Stencils>
  static std::optional<PlainRows> record_any(const Stencils& stencils, std::vector<Index> places,
                                             std::size_t limit);
  template <class Real>
  void make(const Chunk& chunk, const std::vector<Real>& weights, const Real* old,
            Real* fresh) const;

  Index vertex_count_ = 0;
  std::vector<Index> places_;
  WeightLists lists_;
  std::vector<Chunk> chunks_;  ///< first those of faces, whose points others may weigh
  std::size_t of_faces_ = 0;
};

extern template std::optional<PlainRows> PlainRows::record_any(const refine::StepStencils<double>&,
                                                               std::vector<Index>, std::size_t);
extern template std::optional<PlainRows> PlainRows::record_any(
    const refine::CreaseStencils<double>&, std::vector<Index>, std::size_t);
extern template void PlainRows::evaluate<float>(const float*, float*) const;
extern template void PlainRows::evaluate<double>(const double*, double*) const;

}  // namespace limn::fast
