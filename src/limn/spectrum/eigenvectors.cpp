#include "limn/spectrum/eigencomponents.h"

#include <cmath>
#include <numbers>

#include "limn/spectrum/null_space.h"

namespace limn {
namespace {

/// Rows of the blocks' leading part that holds the rings up to `ring`.
Eigen::Index rows_within(const FrequencyBlocks& blocks, Eigen::Index shift, int ring) {
  Eigen::Index rows = shift;
  for (const Orbit& orbit : blocks.orbits) rows += orbit.ring <= ring ? 1 : 0;
  return rows;
}

/// Right and left null vectors of block - λ; the left ones within the leading `part` rows.
template <class Matrix>
void solve(const Matrix& block, typename Matrix::Scalar lambda, Eigen::Index part,
           Eigenvectors& vectors) {
  const Eigen::Index size = block.rows();
  vectors.right = spectrum::null_space<Matrix>(block - lambda * Matrix::Identity(size, size), 1)
                      .template cast<std::complex<double>>();
  const Matrix inner = block.topLeftCorner(part, part) - lambda * Matrix::Identity(part, part);
  const Matrix left = spectrum::null_space<Matrix>(inner.transpose(), 1);
  vectors.left = Eigen::MatrixXcd::Zero(left.cols(), size);
  vectors.left.leftCols(part) = left.transpose().template cast<std::complex<double>>();
}

/// For ω = n/2: what amplitudes are multiplied by so that those of real values are real.
Eigen::VectorXcd real_phases(const FrequencyBlocks& blocks) {
  Eigen::VectorXcd phases(static_cast<Eigen::Index>(blocks.orbits.size()));
  for (Eigen::Index i = 0; i < phases.size(); ++i)
    phases(i) =
        std::polar(1.0, std::numbers::pi * blocks.orbits[static_cast<std::size_t>(i)].angle);
  return phases;
}

/// Several columns in reduced echelon form: each is 1 on a row where the others vanish.
void reduce(Eigen::MatrixXcd& columns) {
  Eigen::Index done = 0;
  for (Eigen::Index row = 0; row < columns.rows() && done < columns.cols(); ++row) {
    Eigen::Index pivot = 0;
    columns.row(row).tail(columns.cols() - done).cwiseAbs().maxCoeff(&pivot);
    columns.col(done).swap(columns.col(done + pivot));
    if (std::abs(columns(row, done)) < 1e-9) continue;
    columns.col(done) /= std::complex<double>(columns(row, done));
    for (Eigen::Index other = 0; other < columns.cols(); ++other)
      if (other != done)
        columns.col(other) -= std::complex<double>(columns(row, other)) * columns.col(done);
    ++done;
  }
}

void normalise(Eigenvectors& vectors, Eigen::Index shift, bool has_center) {
  if (vectors.right.cols() > 1) return reduce(vectors.right);
  auto x = vectors.right.col(0);
  for (Eigen::Index i = shift; i < x.size(); ++i) {
    const std::complex<double> height = x(i) - (has_center && shift == 1 ? x(0) : 0.0);
    if (std::abs(height) < 1e-9 * x.cwiseAbs().maxCoeff()) continue;
    x /= height;
    return;
  }
  if (x(0) != 0.0) x /= x(0);  // the same everywhere: position
}

}  // namespace

Eigenvectors approx_eigenvectors(const FrequencyBlocks& blocks, const Eigenvalue& eigenvalue) {
  const int omega = eigenvalue.frequency;
  const Eigen::MatrixXcd& block = blocks.blocks[static_cast<std::size_t>(omega)];
  const Eigen::Index size = block.rows();
  const Eigen::Index shift = size - static_cast<Eigen::Index>(blocks.orbits.size());
  Eigenvectors vectors{omega, eigenvalue.value, {}, {}};
  // rings up to the eigenvalue's are invariant by themselves, so a left vector of their part is one
  // of the whole; a multiple eigenvalue may need all rings
  const Eigen::Index part =
      eigenvalue.multiplicity == 1 ? rows_within(blocks, shift, eigenvalue.ring) : size;
  Eigen::VectorXcd phases = Eigen::VectorXcd::Ones(size);
  if (2 * omega == blocks.valence) phases = real_phases(blocks);
  const Eigen::MatrixXcd turned = phases.asDiagonal() * block * phases.conjugate().asDiagonal();
  if (turned.imag().cwiseAbs().maxCoeff() < 1e-14 && eigenvalue.value.imag() == 0) {
    solve(Eigen::MatrixXd(turned.real()), eigenvalue.value.real(), part, vectors);
    normalise(vectors, shift, blocks.has_center);
    vectors.right = phases.conjugate().asDiagonal() * vectors.right;
    vectors.left = vectors.left * phases.asDiagonal();
  } else {
    solve(block, eigenvalue.value, part, vectors);
    normalise(vectors, shift, blocks.has_center);
  }
  if (eigenvalue.jordan == 1 && vectors.left.rows() == vectors.right.cols())
    vectors.left = (vectors.left * vectors.right).inverse() * vectors.left;
  return vectors;
}

std::vector<StarPlace> star_places(const FrequencyBlocks& blocks) {
  std::vector<StarPlace> places;
  const int shift = blocks.has_center ? 1 : 0;
  if (blocks.has_center) places.push_back({0, 0});
  std::size_t first = 0;
  while (first < blocks.orbits.size()) {
    std::size_t last = first;
    while (last < blocks.orbits.size() && blocks.orbits[last].ring == blocks.orbits[first].ring)
      ++last;
    for (int sector = 0; sector < blocks.valence; ++sector)
      for (std::size_t orbit = first; orbit < last; ++orbit)
        places.push_back({static_cast<int>(orbit) + shift, sector + blocks.orbits[orbit].angle});
    first = last;
  }
  return places;
}

namespace {

/// Re and Im of factor · X e^{±2πiω·angle/n} at each vertex of the star.
template <class Amplitudes>
std::array<std::vector<double>, 2> waves(const FrequencyBlocks& blocks, int frequency,
                                         const Amplitudes& amplitudes, double sign, double factor) {
  std::array<std::vector<double>, 2> result;
  const int lost = blocks.has_center && frequency > 0 ? 1 : 0;  // the centre's row
  for (const StarPlace& place : star_places(blocks)) {
    const int row = place.row - lost;
    const double angle = sign * 2 * std::numbers::pi * frequency * place.angle / blocks.valence;
    const std::complex<double> value =
        row < 0 ? 0.0 : factor * amplitudes(row) * std::polar(1.0, angle);
    result[0].push_back(value.real());
    result[1].push_back(value.imag());
  }
  return result;
}

}  // namespace

std::array<std::vector<double>, 2> spatial_vectors(const FrequencyBlocks& blocks, int frequency,
                                                   const Eigen::VectorXcd& amplitudes) {
  return waves(blocks, frequency, amplitudes, 1, 1);
}

std::array<std::vector<double>, 2> spatial_functionals(const FrequencyBlocks& blocks, int frequency,
                                                       const Eigen::RowVectorXcd& left) {
  // the amplitude of an orbit is the mean of value · e^{-iωθ}; of a real wave half of it is there
  const bool alone = frequency == 0 || 2 * frequency == blocks.valence;
  auto weights = waves(blocks, frequency, left, -1, (alone ? 1.0 : 2.0) / blocks.valence);
  if (frequency == 0 && blocks.has_center) weights[0].front() *= blocks.valence;  // it is alone
  return weights;
}

}  // namespace limn
