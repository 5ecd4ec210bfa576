#pragma once
/// Stencils: what a new point takes from old ones, on the lattice or from a list.

#include <span>
#include <vector>

#include "limn/refine/linear_form.h"

namespace limn::fast {

/// A vertex of the lattice, or the offset between two.
struct Offset {
  Index a = 0, b = 0;
  friend bool operator==(const Offset&, const Offset&) = default;
  friend auto operator<=>(const Offset&, const Offset&) = default;
};

/// What a fine point takes from the old vertex at `place`, an offset from its anchor.
struct Tap {
  Offset place;
  double weight = 0;
};
using Stencil = std::vector<Tap>;  ///< sorted by place

/// Some new points as sums over some old ones, by their numbers in two lists.
struct RowTable {
  /// Target i has the terms row_begin[i] … row_begin[i+1]-1: weight times source number `source`.
  struct Term {
    int source = 0;
    double weight = 0;
  };
  int sources = 0;  ///< how many old points are read
  std::vector<int> row_begin{0};
  std::vector<Term> terms;

  [[nodiscard]] int targets() const { return static_cast<int>(row_begin.size()) - 1; }
};

/// One target over the taps' places in their order.
[[nodiscard]] RowTable to_rows(const Stencil& stencil);

/// A target for each form, over the vertices that the forms weigh, ascending.
struct FormRows {
  RowTable rows;
  std::vector<Index> vertices;
};
[[nodiscard]] FormRows to_rows(std::span<const refine::LinearForm<double>> forms);

}  // namespace limn::fast
