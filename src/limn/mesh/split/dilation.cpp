#include "limn/mesh/split/split.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

/// True where `difference` lies in the lattice that the columns of the matrix span.
bool in_lattice(const LatticeMatrix& matrix, LatticeVector difference) {
  return matrix.divide(difference).has_value();
}

/// One member of each class modulo the column lattice, by trying vectors in lexicographic order.
std::vector<LatticeVector> classes(const LatticeMatrix& matrix) {
  const int count = matrix.growth();
  std::vector<LatticeVector> members;
  for (int a = 0; a < count; ++a)
    for (int b = 0; b < count; ++b) {
      const bool known = std::any_of(members.begin(), members.end(), [&](LatticeVector member) {
        return in_lattice(matrix, {a - member[0], b - member[1]});
      });
      if (!known) members.push_back({a, b});
      if (static_cast<int>(members.size()) == count) return members;
    }
  return members;
}

}  // namespace

std::optional<LatticeVector> LatticeMatrix::divide(LatticeVector k) const {
  const int det = determinant();
  const LatticeVector scaled = apply_adjugate(k);
  if (scaled[0] % det != 0 || scaled[1] % det != 0) return std::nullopt;
  return LatticeVector{scaled[0] / det, scaled[1] / det};
}

int coset_of(const LatticeMatrix& dilation, LatticeVector k) {
  const std::vector<LatticeVector> members = cosets(dilation);
  const auto same = [&](LatticeVector member) {
    return in_lattice(dilation, {k[0] - member[0], k[1] - member[1]});
  };
  return static_cast<int>(std::find_if(members.begin(), members.end(), same) - members.begin());
}

std::vector<LatticeVector> cosets(const LatticeMatrix& dilation) { return classes(dilation); }

std::vector<LatticeVector> dual_cosets(const LatticeMatrix& dilation) {
  const auto& [first, second] = dilation.rows;
  return classes(LatticeMatrix{{{{first[0], second[0]}, {first[1], second[1]}}}});
}

int arity(const LatticeMatrix& dilation) {
  int p = 1;
  while (!in_lattice(dilation, {p, 0}) || !in_lattice(dilation, {0, p})) ++p;
  return p;
}

std::vector<LatticeVector> edge_directions(Lattice lattice) {
  if (lattice == Lattice::triangle) return {{1, 0}, {0, 1}, {1, 1}};
  return {{1, 0}, {0, 1}};
}

std::vector<LatticeMatrix> isometries(Lattice lattice) {
  std::vector<LatticeMatrix> matrices;
  const auto unit = [&](LatticeVector k) { return squared_length(lattice, k) == 1; };
  for (int code = 0; code < 81; ++code) {  // images of e1 and e2, entries -1, 0, 1
    const LatticeVector first{code % 3 - 1, code / 3 % 3 - 1};
    const LatticeVector second{code / 9 % 3 - 1, code / 27 - 1};
    const LatticeVector sum{first[0] + second[0], first[1] + second[1]};
    // the angle between e1 and e2 is kept if the length of e1 + e2 is
    if (unit(first) && unit(second) &&
        squared_length(lattice, sum) == squared_length(lattice, {1, 1}))
      matrices.push_back(LatticeMatrix{{{{first[0], second[0]}, {first[1], second[1]}}}});
  }
  return matrices;
}

}  // namespace limn
