#pragma once
/// Waves on a torus, refined by limn's own engine, with the place in the plane of every vertex.

#include "limn/mesh/lattice.h"
#include "limn/refine/refine.h"
#include "regular/wave_oracle.h"

namespace limn::test {

class TorusWave {
 public:
  /// e^{2πi f·x} on the torus of n × n vertices; f must close up on it.
  TorusWave(const Scheme& scheme, Index n, Frequency f);

  /// One step of limn's refinement.
  void refine_once();

  [[nodiscard]] const std::vector<Complex>& values() const { return values_; }
  [[nodiscard]] Place place(std::size_t vertex) const { return plane(lattice_, at_[vertex]); }
  /// The component of frequency g: mean of value · e^{-2πi g·x}.
  [[nodiscard]] Complex component(Frequency g) const;
  /// Mean of |value|².
  [[nodiscard]] double power() const;
  /// The mean of the values at the vertices nearest to a place.
  [[nodiscard]] Complex value_near(Place x) const;

 private:
  [[nodiscard]] Place difference(Index from, Index to) const;
  [[nodiscard]] Place between(Index halfedge, Index count, double parts) const;

  const Scheme& scheme_;
  Lattice lattice_;
  double n_;
  int step_ = 0;
  Mesh mesh_;
  std::vector<Place> at_;  // in the control lattice's basis
  std::vector<Complex> values_;
};

/// Frequencies that close up on a torus of n × n vertices.
[[nodiscard]] std::vector<Frequency> closed_frequencies(Lattice lattice, Index n);

}  // namespace limn::test
