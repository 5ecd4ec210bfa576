#include "limn/refine/big_rings.h"

#include <bit>
#include <cassert>
#include <complex>
#include <unordered_map>

#include <unsupported/Eigen/FFT>

namespace limn::refine {
namespace {

using Spectrum = std::vector<std::complex<double>>;

/// The correlation of all values (cyclic, written out twice) with weights of this spectrum.
void correlate_twice(Eigen::FFT<double>& fft, const Spectrum& weights, Spectrum& values) {
  Spectrum spectrum;
  fft.fwd(spectrum, values);
  for (std::size_t i = 0; i < spectrum.size(); ++i) spectrum[i] *= std::conj(weights[i]);
  fft.inv(values, spectrum);
}

}  // namespace

std::vector<Point3> correlate(const std::vector<double>& weights,
                              const std::vector<Point3>& values) {
  assert(weights.size() == values.size());
  const std::size_t n = values.size();
  // no sum m < n goes past place 2n - 2, so that a power of two, which is quick, may come after
  const std::size_t size = std::bit_ceil(2 * n);
  Eigen::FFT<double> fft;
  Spectrum row(size), weight_spectrum, first(size), second(size);
  for (std::size_t i = 0; i < n; ++i) {
    row[i] = weights[i];
    first[i] = first[i + n] = {values[i].x, values[i].y};  // real weights keep the two apart
    second[i] = second[i + n] = values[i].z;
  }
  fft.fwd(weight_spectrum, row);
  correlate_twice(fft, weight_spectrum, first);
  correlate_twice(fft, weight_spectrum, second);
  std::vector<Point3> sums(n);
  for (std::size_t i = 0; i < n; ++i)
    sums[i] = {first[i].real(), first[i].imag(), second[i].real()};
  return sums;
}

BigRing::BigRing(const Mesh& mesh, RuleKind kind, Index h, const Row<double>& row) {
  const Index first = h;
  do {
    anchors_.push_back(h);
    h = kind == RuleKind::corner ? mesh.next(h) : mesh.rotate(h);
  } while (h != first);
  auto program = std::make_shared<Program>();
  const double* weight = row.weights.data();
  for (const Step& step : *row.program) {
    if (!step.walk.repeated) {
      program->push_back(step);
      singles_.weights.push_back(*weight++);
      continue;
    }
    std::optional<Turn> found = turn(mesh, kind, step, anchors_);
    if (!found) {
      turns_.clear();
      return;
    }
    turns_.push_back(std::move(*found));
    turns_.back().weights.assign(weight, weight + anchors_.size());
    weight += anchors_.size();
  }
  singles_.program = std::move(program);
}

std::optional<BigRing::Turn> BigRing::turn(const Mesh& mesh, RuleKind kind, const Step& step,
                                           const std::vector<Index>& anchors) {
  const auto start = [&](Index anchor) {
    Flag flag = scheme::anchor_flags(kind, mesh, anchor).flags[step.flag];
    (void)apply(mesh, step.walk.before, flag);
    return flag;
  };
  const auto key = [](Flag flag) {
    return 2 * static_cast<std::size_t>(flag.halfedge) + flag.at_target;
  };
  Turn turn;
  std::unordered_map<std::size_t, std::size_t> places;
  const Flag first = start(anchors.front());
  Flag flag = first;
  do {
    Flag end = flag;
    (void)apply(mesh, step.walk.after, end);
    places.emplace(key(flag), turn.sources.size());
    turn.sources.push_back(step.walk.reads_face ? Source{mesh.face(end.halfedge), true}
                                                : Source{vertex_of(mesh, end), false});
    (void)apply(mesh, step.walk.step, flag);
  } while (!(flag == first));
  if (turn.sources.size() != anchors.size()) return std::nullopt;
  for (const Index anchor : anchors) {
    const auto found = places.find(key(start(anchor)));
    if (found == places.end()) return std::nullopt;
    turn.starts.push_back(found->second);
  }
  return turn;
}

}  // namespace limn::refine
