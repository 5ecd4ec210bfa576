#include "limn/fast/layout/kites.h"

#include <algorithm>
#include <cstring>
#include <numeric>

#include "limn/base/parallel.h"

namespace limn::fast {
namespace {

constexpr Index kQuadGrain = 8192;  // refined quads that one call of a parallel loop writes

}  // namespace

Kites::Kites(const Mesh& control) : mesh_(&control) {
  place_patches();
  list_inner_elements();
}

void Kites::place_patches() {
  place_.resize(at(mesh_->halfedge_count()));
  std::vector<char> open(at(mesh_->vertex_count()));
  for (Index v = 0; v < mesh_->vertex_count(); ++v) {
    open[at(v)] = mesh_->is_boundary_vertex(v) ? 1 : 0;
    if (mesh_->is_isolated(v)) isolated_.push_back(v);
  }
  wholes_.reserve(place_.size());
  for (Index h = 0; h < mesh_->halfedge_count(); ++h) {
    if (open[at(mesh_->origin(h))] == 0) {
      place_[at(h)] = static_cast<Index>(wholes_.size());
      wholes_.push_back(h);
      continue;
    }
    place_[at(h)] = ~rim_count();
    if (has_y_arm(h)) lines_.push_back(h);
    arms_before_.push_back(arms_before_.back() + (has_x_arm(h) ? 1 : 0) + (has_y_arm(h) ? 1 : 0));
  }
  if (!has_rims()) place_ = {};
}

void Kites::list_inner_elements() {
  for (Index e = 0; e < mesh_->edge_count(); ++e)
    if (!mesh_->is_boundary_edge(e)) inner_edges_.push_back(e);
  std::vector<Index> corners(at(mesh_->vertex_count()), 0);
  for (const Index h : wholes_) ++corners[at(mesh_->origin(h))];
  vertex_begin_.push_back(0);
  for (Index v = 0; v < mesh_->vertex_count(); ++v) {
    if (corners[at(v)] == 0) continue;
    inner_vertices_.push_back(v);
    vertex_begin_.push_back(vertex_begin_.back() + corners[at(v)]);
  }
}

bool Kites::is_regular() const {
  if (mesh_->uniform_degree() != 4) return false;
  for (Index i = 0; i < std::ssize(inner_vertices_); ++i)
    if (vertex_begin(i + 1) - vertex_begin(i) != 4) return false;
  return true;
}

KiteLayout::KiteLayout(const Kites& kites, Index n)
    : kites_(&kites),
      n_(n),
      rims_at_(count(kites.wholes()) * n * n),
      isolated_at_(rims_at_ + kites.rim_count() + kites.arms_before(kites.rim_count()) * (n - 1)),
      arm_quads_at_(count(kites.wholes()) * (n * n - 1)),
      edge_quads_at_(arm_quads_at_ + count(kites.lines()) * (n - 1)),
      quads_(edge_quads_at_ + count(kites.inner_edges())) {}

std::vector<Index> KiteLayout::isolated() const {
  std::vector<Index> numbers(kites_->isolated().size());
  std::iota(numbers.begin(), numbers.end(), isolated_at_);
  return numbers;
}

Index KiteLayout::line_point(Index h, Index t, Index u) const {
  if (t < n_) return u >= 0 ? point(h, u, t) : point(control().next(h), t, -1 - u);
  const Index twin = control().twin(h), back = 2 * n_ - 1 - t;
  return u >= 0 ? point(control().next(twin), back, u) : point(twin, -1 - u, back);
}

void KiteLayout::write_patch(Index h, Index* out) const {
  typedef Index Four __attribute__((vector_size(16)));
  const auto add = [&out](const Four& corners) {
    std::memcpy(out, &corners, sizeof corners);
    out += 4;
  };
  const Index before = control().next(h), after = control().rotate(h);
  const Index left = point(before, 0, 0);  // from which the points of its row or arm follow
  const Index right = point(after, 0, n_ - 1);
  Index low = point(h, 0, 0), side = left;
  for (Index y = 0; y + 1 < n_; ++y, low += n_, side = left + y) {
    const Index high = low + n_;
    add(Four{side, low, high, left + y + 1});
    Four quad{low, low + 1, high + 1, high};
    for (Index x = 0; x + 1 < n_; ++x, quad += 1) add(quad);
    add(Four{high - 1, right + y, right + y + 1, high + n_ - 1});
  }
}

void KiteLayout::write_across(Index h, Index t, Index* out) const {
  out[0] = line_point(h, t, -1);
  out[1] = line_point(h, t, 0);
  out[2] = line_point(h, t + 1, 0);
  out[3] = line_point(h, t + 1, -1);
}

void KiteLayout::write_vertex(Index v, Index* out) const {
  const Index first = control().halfedge_of_vertex(v);
  Index h = first;
  do {
    *out++ = point(h, n_ - 1, n_ - 1);
    h = control().rotate(h);
  } while (h != first);
}

void KiteLayout::write_faces(Index* out) const {
  const Index patch = n_ * n_ - 1, arm = n_ - 1;
  // by so many quads, or a face, for each element of a list
  const auto each = [](const std::vector<Index>& list, Index quads, const auto& write) {
    base::parallel_for(
        Index{0}, count(list),
        [&](Index first, Index last) {
          for (Index i = first; i < last; ++i) write(list[static_cast<std::size_t>(i)], i);
        },
        std::max<Index>(1, kQuadGrain / std::max<Index>(1, quads)));
  };
  base::parallel_for_each(control().halfedge_count(), [&](Index h) { out[h] = point(h, 0, 0); });
  out += control().halfedge_count();
  each(kites_->inner_vertices(), 1,
       [&](Index v, Index i) { write_vertex(v, out + kites_->vertex_begin(i)); });
  out += kites_->vertex_begin(inner_count());
  each(kites_->wholes(), patch,
       [&](Index h, std::ptrdiff_t i) { write_patch(h, out + 4 * i * patch); });
  out += std::ptrdiff_t{4} * arm_quads_at_;
  each(kites_->lines(), arm, [&](Index h, std::ptrdiff_t i) {
    for (Index t = 0; t < arm; ++t) write_across(h, t, out + 4 * (i * arm + t));
  });
  out += std::ptrdiff_t{4} * (edge_quads_at_ - arm_quads_at_);
  each(kites_->inner_edges(), 1, [&](Index e, std::ptrdiff_t i) {
    write_across(control().halfedge_of_edge(e), arm, out + 4 * i);
  });
}

void KiteLayout::write_face_begin(Index* out) const {
  base::parallel_for_each(control().face_count(),
                          [&](Index f) { out[f] = control().face_begin(f); });
  out += control().face_count();
  const Index vertices_at = control().halfedge_count();
  base::parallel_for_each(inner_count(),
                          [&](Index i) { out[i] = vertices_at + kites_->vertex_begin(i); });
  out += inner_count();
  const Index quads_at = vertices_at + kites_->vertex_begin(inner_count());
  base::parallel_for_each(quads_ + 1, [&](Index f) { out[f] = quads_at + 4 * f; });
}

}  // namespace limn::fast
