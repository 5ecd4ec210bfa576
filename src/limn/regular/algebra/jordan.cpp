#include "limn/regular/algebra/jordan.h"

#include <utility>

namespace limn::regular {

int largest_jordan_block(RationalMatrix a, const Rational& eigenvalue) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i][i] -= eigenvalue;
  Echelon<Rational> null = null_space(a);
  // the vectors that a maps into the null space of its power before; the chain ends where there
  // are no more of them
  int rows = 0;
  for (RationalMatrix power = a; null.dimension() > 0; ++rows) {
    power = product(power, a);
    Echelon<Rational> next = null_space(power);
    if (next.dimension() == null.dimension()) return rows + 1;
    null = std::move(next);
  }
  return rows;
}

}  // namespace limn::regular
