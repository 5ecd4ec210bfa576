#include "limn/refine/subdivision_matrix.h"

#include <fmt/core.h>

#include "limn/number/arithmetic.h"
#include "limn/refine/refine_values.h"
#include "limn/refine/star_step.h"
#include "limn/scheme/lattice_schemes.h"

namespace limn::refine {
namespace {

Error not_invariant(const Scheme& scheme, int n, int rings) {
  return {fmt::format("the {}-ring neighbourhood at valence {} is not invariant under scheme '{}'",
                      rings, n, scheme.name),
          "take more rings"};
}

}  // namespace

template <class Number>
Result<SubdivisionMatrix<Number>> subdivision_matrix(const Scheme& scheme, int n, int rings) {
  if (Status status = scheme::check_one_lattice(scheme); !status) return status.error();
  const Split& split = *scheme.split;
  if (n < scheme::kSmallestValence)
    return Error{fmt::format("valence {} is below {}", n, scheme::kSmallestValence)};
  if (rings < 1) return Error{"a neighbourhood needs at least one ring"};
  if (rings < least_star_rings(split)) return not_invariant(scheme, n, rings);
  const StarStep step = star_step(split, n, rings);
  RuleTables<Number> tables(scheme, Boundary::left_out);
  if (Status status = tables.prepare(step.coarse, step.fine.births); !status) return status.error();
  const std::vector<LinearForm<Number>> forms =
      refine_values(scheme, step.coarse, step.fine.births, tables,
                    unit_forms<Number>(step.coarse.vertex_count()));

  SubdivisionMatrix<Number> matrix;
  matrix.size = step.size;
  matrix.center = split.is_dual() ? 0 : 1;
  matrix.entries.assign(static_cast<std::size_t>(step.size) * static_cast<std::size_t>(step.size),
                        Number(0));
  for (Index i = 0; i < step.size; ++i)
    for (const auto& [vertex, value] : forms[step.images[i]].terms) {
      if (vertex < step.size) {
        matrix.entries[static_cast<std::size_t>(i) * static_cast<std::size_t>(step.size) +
                       static_cast<std::size_t>(vertex)] = value;
      } else if (number::Arithmetic<Number>::approx(value) != 0) {
        return not_invariant(scheme, n, rings);
      }
    }
  return matrix;
}

Result<int> invariant_rings(const Scheme& scheme, int n, int largest) {
  Error last;
  for (int rings = 1; rings <= largest; ++rings) {
    const Result<SubdivisionMatrix<double>> matrix = subdivision_matrix<double>(scheme, n, rings);
    if (matrix) return rings;
    last = matrix.error();
  }
  return last;
}

template Result<SubdivisionMatrix<double>> subdivision_matrix<double>(const Scheme&, int, int);
template Result<SubdivisionMatrix<number::Exact>> subdivision_matrix<number::Exact>(const Scheme&,
                                                                                    int, int);

}  // namespace limn::refine
