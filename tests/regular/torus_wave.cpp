#include "regular/torus_wave.h"

#include <cmath>

namespace limn::test {

TorusWave::TorusWave(const Scheme& scheme, Index n, Frequency f)
    : scheme_(scheme), lattice_(scheme.split->lattice), n_(n), mesh_(mesh::torus(lattice_, n, n)) {
  for (Index v = 0; v < n * n; ++v) {
    at_.push_back({1. * (v % n), 1. * (v / n)});
    values_.push_back(wave(f, plane(lattice_, at_.back())));
  }
}

Place TorusWave::difference(Index from, Index to) const {
  const Place a = at_[static_cast<std::size_t>(from)], b = at_[static_cast<std::size_t>(to)];
  return {std::remainder(b[0] - a[0], n_), std::remainder(b[1] - a[1], n_)};
}

/// The origin of a half-edge, moved by 1/parts of the ways to the next `count` corners.
Place TorusWave::between(Index halfedge, Index count, double parts) const {
  const Index origin = mesh_.origin(halfedge);
  Place place = at_[static_cast<std::size_t>(origin)];
  Index h = halfedge;
  for (Index i = 0; i < count; ++i) {
    h = mesh_.next(h);
    const Place way = difference(origin, mesh_.origin(h));
    place = {place[0] + way[0] / parts, place[1] + way[1] / parts};
  }
  return place;
}

void TorusWave::refine_once() {
  const SplitResult split = scheme_.split->apply(mesh_, step_++);
  std::vector<Place> fresh;
  for (Index v = 0; v < split.births.from_vertices; ++v)
    fresh.push_back(at_[static_cast<std::size_t>(v)]);
  for (Index i = 0; i < split.births.from_edges; ++i) {
    const EdgeChild child = edge_child(mesh_, split.births, i);
    const Index h = child.at_target ? mesh_.twin(child.halfedge) : child.halfedge;
    fresh.push_back(between(h, 1, child.third ? 3 : 2));
  }
  for (Index f = 0; f < split.births.from_faces; ++f)
    fresh.push_back(between(mesh_.face_begin(f), mesh_.degree(f) - 1, mesh_.degree(f)));
  for (Index h = 0; h < split.births.from_corners; ++h) {
    const Index degree = mesh_.degree(mesh_.face(h));
    fresh.push_back(between(h, degree - 1, (scheme_.split->is_dual() ? 2 : 1.5) * degree));
  }
  refine::Refined<Complex> refined = refine::refine<Complex>(scheme_, mesh_, values_, 1).value();
  mesh_ = std::move(refined.mesh);
  values_ = std::move(refined.values);
  at_ = std::move(fresh);
}

Complex TorusWave::component(Frequency g) const {
  Complex sum = 0;
  for (std::size_t v = 0; v < values_.size(); ++v) sum += values_[v] * std::conj(wave(g, place(v)));
  return sum / static_cast<double>(values_.size());
}

double TorusWave::power() const {
  double sum = 0;
  for (const Complex& value : values_) sum += std::norm(value);
  return sum / static_cast<double>(values_.size());
}

Complex TorusWave::value_near(Place x) const {
  double least = 1e9;
  Complex sum = 0;
  int count = 0;
  for (std::size_t v = 0; v < values_.size(); ++v) {
    const Place p = place(v);
    const double away = std::hypot(p[0] - x[0], p[1] - x[1]);
    if (away < least - 1e-9) {
      least = away;
      sum = 0;
      count = 0;
    }
    if (away > least + 1e-9) continue;
    sum += values_[v];
    ++count;
  }
  return sum / static_cast<double>(count);
}

std::vector<Frequency> closed_frequencies(Lattice lattice, Index n) {
  std::vector<Frequency> all;
  for (const auto& [p, q] : {std::pair{1, 0}, {1, 2}, {2, -1}, {-1, 1}, {0, 0}})
    all.push_back(frequency_along(lattice, 1. * p / n, 1. * q / n));
  return all;
}

}  // namespace limn::test
