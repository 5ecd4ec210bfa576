#include "support/corner_reference.h"

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace limn::test {
namespace {

constexpr double kPi = std::numbers::pi;
using Complex = std::complex<double>;

class Reference {
 public:
  Reference(const Mesh& mesh, const Births& births, const std::vector<double>& old)
      : mesh_(mesh), births_(births), old_(old) {}

  std::vector<double> kobbelt(double w) {
    w_ = w;
    for (Index v = 0; v < births_.from_vertices; ++v) push(at(v));
    for (Index e = 0; e < births_.from_edges; ++e) push(kobbelt_edge(mesh_.halfedge_of_edge(e)));
    for (Index f = 0; f < births_.from_faces; ++f) push(kobbelt_face(f));
    return std::move(fresh_);
  }

  std::vector<double> labsik_greiner() {
    for (Index v = 0; v < births_.from_vertices; ++v) push(at(v));
    for (const Index end : births_.edge_ends) {  // the cubic through four points, at 1/3
      const Index h = end / 2;
      const bool back = end % 2 != 0;
      const double near = at(back ? mesh_.target(h) : mesh_.origin(h));
      const double far = at(back ? mesh_.origin(h) : mesh_.target(h));
      push((-5 * at(beyond(h, back)) + 60 * near + 30 * far - 4 * at(beyond(h, !back))) / 81);
    }
    for (Index i = 0; i < births_.from_faces; ++i)
      push(labsik_greiner_face(births_.faces.empty() ? i : births_.faces[i]));
    return std::move(fresh_);
  }

  std::vector<double> bounded() {
    for (Index v = 0; v < births_.from_vertices; ++v) push(bounded_vertex(v));
    for (Index e = 0; e < births_.from_edges; ++e) push(bounded_edge(mesh_.halfedge_of_edge(e)));
    for (Index f = 0; f < births_.from_faces; ++f) push(bounded_face(f));
    return std::move(fresh_);
  }

 private:
  void push(double value) { fresh_.push_back(value); }
  [[nodiscard]] double at(Index v) const { return old_[static_cast<std::size_t>(v)]; }
  [[nodiscard]] double from(Index h) const { return at(mesh_.origin(h)); }
  [[nodiscard]] double to(Index h) const { return at(mesh_.target(h)); }
  [[nodiscard]] Index next(Index h) const { return mesh_.next(h); }
  [[nodiscard]] Index prev(Index h) const { return mesh_.prev(h); }
  [[nodiscard]] Index twin(Index h) const { return mesh_.twin(h); }

  [[nodiscard]] double mean(Index f) const {
    double sum = 0;
    for (Index h = mesh_.face_begin(f); h < mesh_.face_begin(f + 1); ++h) sum += from(h);
    return sum / mesh_.degree(f);
  }

  /// The other boundary edge's far end, where boundary half-edge h meets its origin or target.
  [[nodiscard]] Index beyond(Index h, bool at_target) const {
    if (at_target) {
      Index out = next(h);
      while (twin(out) != kNone) out = next(twin(out));
      return mesh_.target(out);
    }
    Index in = prev(h);
    while (twin(in) != kNone) in = prev(twin(in));
    return mesh_.origin(in);
  }

  [[nodiscard]] bool is_special(Index v, int regular) const {
    return !mesh_.is_boundary_vertex(v) && mesh_.valence(v) != regular;
  }

  /// The mean of `seen(h)` over the half-edges of a face out of special corners; nothing where none
  /// is special.
  template <class Seen>
  [[nodiscard]] std::optional<double> mean_of_corners(Index f, int regular,
                                                      const Seen& seen) const {
    double sum = 0;
    int count = 0;
    for (Index h = mesh_.face_begin(f); h < mesh_.face_begin(f + 1); ++h)
      if (is_special(mesh_.origin(h), regular)) {
        sum += seen(h);
        ++count;
      }
    if (count == 0) return std::nullopt;
    return sum / count;
  }

  /// Round the origin of h: neighbours counterclockwise from h's target, and what is opposite in
  /// the faces, from that of h; in a polygon the mean of the two next but one.
  struct Ring {
    std::vector<double> neighbour, opposite;
    [[nodiscard]] double l(int j) const { return neighbour[index(j)]; }
    [[nodiscard]] double k(int j) const { return opposite[index(j)]; }
    [[nodiscard]] std::size_t index(int j) const {
      const int n = static_cast<int>(neighbour.size());
      return static_cast<std::size_t>(((j % n) + n) % n);
    }
  };
  [[nodiscard]] Ring ring(Index h) const {
    Ring ring;
    Index spoke = h;
    do {
      ring.neighbour.push_back(to(spoke));
      ring.opposite.push_back((to(next(spoke)) + from(prev(prev(spoke)))) / 2);
      spoke = mesh_.rotate(spoke);
    } while (spoke != h);
    return ring;
  }

  // --- Kobbelt's quads ------------------------------------------------------------------------

  [[nodiscard]] double four_point(double a, double b, double c, double d) const {
    return (1 / 2. + w_) * (b + c) - w_ * (a + d);
  }

  /// His virtual point beyond the origin of h, in the line of h.
  [[nodiscard]] double virtual_point(const Ring& r) const {
    const double ratio = -w_ / (1 / 2. + w_);
    double constant = 0;
    const int n = static_cast<int>(r.neighbour.size());
    for (int j = 0; j < n; ++j) constant += 4. / n * (r.l(j) + ratio * r.k(j));
    return constant - r.l(-1) - r.l(0) - r.l(1) - ratio * (r.k(-2) + r.k(-1) + r.k(0) + r.k(1));
  }

  /// Straight beyond the target of h, going round it on h's left; the line prolonged where the mesh
  /// ends.
  [[nodiscard]] double straight_left(Index h) const {
    const Index t = twin(next(h));
    return t == kNone ? 2 * to(h) - from(h) : to(next(t));
  }
  /// The same beyond the origin of r, on r's left.
  [[nodiscard]] double straight_back(Index r) const {
    const Index t = twin(prev(r));
    return t == kNone ? 2 * from(r) - to(r) : from(prev(t));
  }
  /// Beyond the target, from both sides of an interior edge.
  [[nodiscard]] double straight(Index h) const {
    return (straight_left(h) + straight_back(twin(h))) / 2;
  }

  [[nodiscard]] double kobbelt_end(Index h) const {
    return four_point(virtual_point(ring(h)), from(h), to(h), straight(h));
  }

  [[nodiscard]] double kobbelt_edge(Index h) const {
    const Index t = twin(h);
    if (t == kNone) return four_point(at(beyond(h, false)), from(h), to(h), at(beyond(h, true)));
    const bool first = is_special(mesh_.origin(h), 4), second = is_special(mesh_.target(h), 4);
    if (first && second) return (kobbelt_end(h) + kobbelt_end(t)) / 2;
    if (first) return kobbelt_end(h);
    if (second) return kobbelt_end(t);
    return four_point(straight(t), from(h), to(h), straight(h));
  }

  /// The four-point rule over four lines, seen from the corner at the origin of h: the lines run
  /// along h.
  [[nodiscard]] double kobbelt_corner(Index h) const {
    const Ring r = ring(h);
    const Index back = prev(h);  // along the other edge
    const double p = from(h), l = to(h), m = from(back), k = to(next(h));
    const auto or_else = [](Index t, double value, double otherwise) {
      return t == kNone ? otherwise : value;
    };
    const Index right = twin(next(h));     // across the edge from l to k
    const Index upper = twin(prev(back));  // across the edge from m to k
    const Index below = twin(prev(twin(h))), left = twin(next(twin(back)));
    const double beside_l = or_else(below, below == kNone ? 0 : to(next(below)), 2 * l - m);
    const double beside_m = or_else(left, left == kNone ? 0 : from(prev(left)), 2 * m - l);
    const double far_l = right == kNone ? 2 * l + m - 2 * p : from(prev(right));
    const double far_m = upper == kNone ? 2 * m + l - 2 * p : to(next(upper));
    const double corner = 2 * l + 2 * m - 3 * p;
    const Index u = right == kNone ? kNone : twin(prev(right));
    const Index v = upper == kNone ? kNone : twin(next(upper));
    const double outer =
        ((u == kNone ? corner : to(next(u))) + (v == kNone ? corner : from(prev(v)))) / 2;
    return four_point(four_point(r.k(-2), r.l(-1), r.k(-1), beside_l),
                      four_point(virtual_point(r), p, l, straight_left(h)),
                      four_point(r.k(1), m, k, far_l),
                      four_point(beside_m, straight_back(back), far_m, outer));
  }

  /// Of a face with regular corners: from each, what is beyond its edges and across it.
  [[nodiscard]] double kobbelt_regular(Index f) const {
    const double h2 = std::pow(1 / 2. + w_, 2), hw = (1 / 2. + w_) * w_;
    double sum = 0;
    for (Index h = mesh_.face_begin(f); h < mesh_.face_begin(f + 1); ++h) {
      const Index back = prev(h);
      const double c = from(h), d = to(h), w = from(back);
      const Index one = twin(h), two = twin(back);
      const double beyond_one = one == kNone ? 2 * c - w : to(next(one));
      const double beyond_two = two == kNone ? 2 * c - d : from(prev(two));
      const Index third = one == kNone ? kNone : twin(next(one));
      const Index fourth = two == kNone ? kNone : twin(prev(two));
      const double corner = 3 * c - d - w;
      const double across = ((third == kNone ? corner : from(prev(third))) +
                             (fourth == kNone ? corner : to(next(fourth)))) /
                            2;
      sum += h2 * c - hw * (beyond_one + beyond_two) + w_ * w_ * across;
    }
    return sum;
  }

  [[nodiscard]] double kobbelt_face(Index f) const {
    if (mesh_.degree(f) != 4) return mean(f);
    const auto seen = mean_of_corners(f, 4, [&](Index h) { return kobbelt_corner(h); });
    return seen ? *seen : kobbelt_regular(f);
  }

  // --- Labsik and Greiner's triangles ---------------------------------------------------------

  [[nodiscard]] double labsik_greiner_corner(Index h) const {
    const std::vector<double> l = ring(h).neighbour;
    const int n = static_cast<int>(l.size());
    const double tangent = 2 / 3. * std::cos(kPi / n), cup = tangent * tangent;
    double sum = (1 - cup) * from(h);
    for (int j = 0; j < n; ++j) {  // angles from the middle of the face, which is left of h
      const double angle = 2 * kPi * (j - 1 / 2.) / n;
      double weight = cup + 2 * tangent * std::cos(angle);
      if (n > 3) weight += 2 * cup * std::cos(2 * angle);
      sum += weight / n * l[static_cast<std::size_t>(j)];
    }
    return sum;
  }

  [[nodiscard]] double labsik_greiner_face(Index f) const {
    if (const auto seen = mean_of_corners(f, 6, [&](Index h) { return labsik_greiner_corner(h); }))
      return *seen;
    double sum = 0;
    for (Index h = mesh_.face_begin(f); h < mesh_.face_begin(f + 1); ++h) {
      const Index t = twin(h), back = prev(h), s = twin(back);
      const double c = from(h), d = to(h), w = from(back);
      sum += 32 * c - (t == kNone ? c + d - w : to(next(t)));
      const Index one = t == kNone ? kNone : twin(next(t));
      const Index two = s == kNone ? kNone : twin(prev(s));
      sum -= 2 * (one == kNone ? 2 * c - w : to(next(one)));
      sum -= 2 * (two == kNone ? 2 * c - d : from(prev(two)));
    }
    return sum / 81;
  }

  // --- Catmull and Clark's, bounded -------------------------------------------------------------

  /// By amplitudes: frequency 0 is Catmull and Clark's. That of frequency 1 maps neighbours at
  /// distance 1 and opposites at distance 1/cos(π/n), where faces are kites, to their halves;
  /// frequency 2 does so with the squares of these, to a quarter; and the rest is 0. At a new edge
  /// point on h, or the new face point on its left.
  [[nodiscard]] double bounded_from(Index h, bool of_face) const {
    const Ring r = ring(h);
    const int n = static_cast<int>(r.neighbour.size());
    const double half = std::cos(kPi / n);
    double sum = of_face ? from(h) / 4 : 3 * from(h) / 8;
    for (int omega = 0; omega <= (n == 3 ? 1 : 2); ++omega) {
      Complex l, k;
      for (int j = 0; j < n; ++j) {
        l += r.l(j) * std::polar(1. / n, -2 * kPi * omega * j / n);
        k += r.k(j) * std::polar(1. / n, -2 * kPi * omega * (j + 1 / 2.) / n);
      }
      if (omega == 0) {
        sum += of_face ? (l / 2. + k / 4.).real() : (l / 2. + k / 8.).real();
        continue;
      }
      // new = stay·old + what the other kind of point must give for the ratio of distances
      const double ratio = std::pow(half, -omega), shrink = std::pow(0.5, omega);
      const double edge_stays = shrink * (1 + half * half) / 2;
      const double face_stays = shrink * (1 - half * half);
      const Complex edge = edge_stays * l + (shrink - edge_stays) / ratio * k;
      const Complex face = face_stays * k + (shrink - face_stays) * ratio * l;
      sum += 2 * (of_face ? face * std::polar(1., kPi * omega / n) : edge).real();
    }
    return sum;
  }

  [[nodiscard]] double bounded_face(Index f) const {
    if (mesh_.degree(f) != 4) return mean(f);
    return mean_of_corners(f, 4, [&](Index h) { return bounded_from(h, true); }).value_or(mean(f));
  }

  [[nodiscard]] double bounded_edge(Index h) const {
    const Index t = twin(h);
    if (t == kNone) return (from(h) + to(h)) / 2;
    const bool first = is_special(mesh_.origin(h), 4), second = is_special(mesh_.target(h), 4);
    if (first && second) return (bounded_from(h, false) + bounded_from(t, false)) / 2;
    if (first) return bounded_from(h, false);
    if (second) return bounded_from(t, false);
    double wings = 0;
    for (const Index side : {h, t}) wings += from(prev(side)) + to(next(side));
    return (6 * (from(h) + to(h)) + wings) / 16;
  }

  [[nodiscard]] double bounded_vertex(Index v) const {
    if (mesh_.is_isolated(v)) return at(v);
    const Index first = mesh_.halfedge_of_vertex(v);
    if (mesh_.is_boundary_vertex(v)) return (6 * at(v) + to(first) + at(beyond(first, false))) / 8;
    const int n = mesh_.valence(v);
    double neighbours = 0, opposites = 0;
    Index h = first;
    do {
      neighbours += to(h) / n;
      opposites += (to(next(h)) + from(prev(prev(h)))) / (2 * n);
      h = mesh_.rotate(h);
    } while (h != first);
    return (9 * at(v) + 6 * neighbours + opposites) / 16;
  }

  const Mesh& mesh_;
  const Births& births_;
  const std::vector<double>& old_;
  double w_ = 0;
  std::vector<double> fresh_;
};

}  // namespace

bool has_corner_reference(const std::string& scheme) {
  return scheme == "kobbelt-quad" || scheme == "sqrt3-interpolating" ||
         scheme == "catmull-clark-bounded";
}

std::vector<double> corner_reference_step(const std::string& scheme,
                                          std::optional<double> parameter, const Mesh& mesh,
                                          const Births& births, const std::vector<double>& old) {
  Reference reference(mesh, births, old);
  if (scheme == "kobbelt-quad") return reference.kobbelt(parameter.value_or(1 / 16.));
  if (scheme == "sqrt3-interpolating") return reference.labsik_greiner();
  return reference.bounded();
}

}  // namespace limn::test
