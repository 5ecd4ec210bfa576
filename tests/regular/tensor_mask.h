#pragma once

#include <vector>

#include "limn/scheme/mask.h"

namespace limn::test {

/// A tensor product of one mask for curves, centred.
inline Mask tensor(const std::vector<int>& row, int over, int arity) {
  Mask mask{Lattice::quad, LatticeMatrix{{{{arity, 0}, {0, arity}}}}, {}};
  const int reach = static_cast<int>(row.size()) - 1;
  for (int i = 0; i <= reach; ++i)
    for (int j = 0; j <= reach; ++j) {
      const Rational value = Rational(row[static_cast<std::size_t>(i)], over) *
                             Rational(row[static_cast<std::size_t>(j)], over);
      if (value != 0) mask.coefficients[{2 * i - reach, 2 * j - reach}] = value;
    }
  return mask;
}

}  // namespace limn::test
