#pragma once
/// The characteristic map on a cell or a part of it.

#include <array>
#include <vector>

#include "limn/number/ball.h"

namespace limn::certify {

/// Values of u and v as CellMatrices keeps them.
struct CellMap {
  struct Coordinate {
    number::Ball origin;                   ///< c(0)
    std::array<number::Ball, 2> gradient;  ///< g
    std::vector<number::Ball> residual;    ///< r over its sizes
  };
  Coordinate u, v;
};

}  // namespace limn::certify
