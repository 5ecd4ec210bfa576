#include "limn/regular/smoothness/exact_polytope.h"

#include <algorithm>
#include <set>
#include <utility>

#include "limn/base/parallel.h"
#include "limn/regular/smoothness/rounding.h"
#include "limn/regular/smoothness/symmetric_hull.h"

namespace limn::regular {
namespace {

using Vector = FieldVector<Rational>;

constexpr double kNearFace = 1e-7;  // combinations within this of 1 are solved exactly
constexpr std::ptrdiff_t kGrain = 8;
constexpr std::size_t kBatch = 256;  // images between two reports of progress

Eigen::VectorXd approx(const Vector& v) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(v.size()));
  for (std::size_t i = 0; i < v.size(); ++i) result(static_cast<Eigen::Index>(i)) = to_double(v[i]);
  return result;
}

/// v or -v, whichever has its first entry other than 0 positive.
Vector signed_alike(Vector v) {
  const auto first = std::find_if(v.begin(), v.end(), [](const Rational& q) { return q != 0; });
  if (first != v.end() && *first < 0)
    for (Rational& entry : v) entry = -entry;
  return v;
}

bool is_zero(const Vector& v) {
  return std::all_of(v.begin(), v.end(), [](const Rational& q) { return q == 0; });
}

/// The hull of exact vectors and their negatives. Each double of `approx_` is off by a unit in the
/// last place at most: the bounds of SymmetricHull, which are twice what rounded sums need, cover
/// that.
class ExactHull {
 public:
  explicit ExactHull(std::size_t size) : approx_(static_cast<Eigen::Index>(size)) {}

  void add(const Vector& v) {
    if (!known_.insert(signed_alike(v)).second) return;
    vertices_.push_back(v);
    approx_.add(approx(v));
  }
  [[nodiscard]] bool spans() const { return approx_.spans(); }
  [[nodiscard]] bool leaves_span(const Vector& v) const { return approx_.leaves_span(approx(v)); }
  [[nodiscard]] bool is_vertex(const Vector& v) const { return known_.contains(signed_alike(v)); }
  [[nodiscard]] const std::vector<Vector>& vertices() const { return vertices_; }
  [[nodiscard]] double size() const { return approx_.points().colwise().norm().maxCoeff(); }

  /// To be called once the hull spans. False where its first basis is too bad to work with.
  bool prepare() {
    axis_norms_ = approx_.axis_norms();
    start_ = approx_.start_at(approx_.first_basis());
    return axis_norms_.allFinite();
  }
  void begin_at(const SymmetricHull::Basis& basis) { start_ = approx_.start_at(basis); }

  struct Place {
    bool within = false;         ///< proved
    double norm = 1;             ///< approximately, or more
    SymmetricHull::Basis basis;  ///< where the search ended, if there was one
  };
  [[nodiscard]] Place place_of(const Vector& u) const {
    if (is_zero(u) || is_vertex(u)) return {true, 1, {}};
    const Eigen::VectorXd v = approx(u);
    SymmetricHull::Combination found =
        approx_.least_combination(v, start_, 1 - kNearFace, 1 + kNearFace);
    Place place{false, found.norm, std::move(found.points)};
    if (found.outside || found.norm > 1 + kNearFace) return place;
    found.points = place.basis;
    const Eigen::VectorXd slack = v.cwiseAbs() * rounding_error(2);
    const Eigen::VectorXd rest = approx_.residual_bound(v, slack, found);
    place.within = inflated(found.norm + rest.dot(axis_norms_)) <= 1 || on_face(u, place.basis);
    return place;
  }

 private:
  [[nodiscard]] bool on_face(const Vector& u, const SymmetricHull::Basis& basis) const {
    std::vector<Vector> points;
    for (const Eigen::Index point : basis)
      points.push_back(vertices_[static_cast<std::size_t>(point)]);
    const std::optional<Vector> c = Coordinates(points).of(u);
    if (!c) return false;
    Rational sum = 0;
    for (const Rational& entry : *c) sum += abs(entry);
    return sum <= 1;
  }

  SymmetricHull approx_;
  std::vector<Vector> vertices_;
  std::set<Vector> known_;  // the vertices, signed alike
  Eigen::VectorXd axis_norms_;
  SymmetricHull::Start start_;
};

std::vector<RationalMatrix> normalised(std::vector<RationalMatrix> matrices,
                                       const Rational& level) {
  for (RationalMatrix& matrix : matrices)
    for (Vector& row : matrix)
      for (Rational& entry : row)
        if (entry != 0) entry /= level;
  return matrices;
}

/// The places of vectors, found in parallel.
std::vector<ExactHull::Place> places_of(const ExactHull& hull, const std::vector<Vector>& vectors,
                                        const Stop& stop) {
  std::vector<ExactHull::Place> places(vectors.size());
  base::parallel_for(
      std::size_t{0}, vectors.size(),
      [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last && !asked(stop); ++i)
          places[i] = hull.place_of(vectors[i]);
      },
      kGrain);
  return places;
}

class ExactGrowth {
 public:
  ExactGrowth(const std::vector<RationalMatrix>& matrices, const Rational& level,
              const ExactPolytopeLimits& limits)
      : matrices_(normalised(matrices, level)), limits_(limits), hull_(matrices.front().size()) {}

  std::optional<std::vector<Vector>> run(const std::vector<Vector>& start) {
    for (const Vector& v : start)
      if (!is_zero(v)) hull_.add(v);
    if (!span()) return std::nullopt;
    while (next_ < hull_.vertices().size() || !waiting_.empty()) {
      for (; next_ < hull_.vertices().size(); ++next_)
        for (Vector& image : images_of(next_)) waiting_.push_back(std::move(image));
      take_in(std::exchange(waiting_, {}));
      if (must_end()) return std::nullopt;
    }
    return hull_.vertices();
  }

 private:
  [[nodiscard]] bool must_end() const {
    return static_cast<int>(hull_.vertices().size()) > limits_.most_vertices || asked(limits_.stop);
  }

  [[nodiscard]] std::vector<Vector> images_of(std::size_t vertex) const {
    std::vector<Vector> images;
    images.reserve(matrices_.size());
    for (const RationalMatrix& matrix : matrices_)
      images.push_back(product(matrix, hull_.vertices()[vertex]));
    return images;
  }

  /// Adds images, and at last multiples of the axes, until the hull spans.
  bool span() {
    if (hull_.vertices().empty()) return false;
    while (!hull_.spans() && next_ < hull_.vertices().size())
      for (Vector& image : images_of(next_++)) {
        if (!hull_.spans() && !is_zero(image) && hull_.leaves_span(image))
          hull_.add(image);
        else
          waiting_.push_back(std::move(image));
      }
    Rational size = 1;
    while (to_double(size) > hull_.size() / 64) size /= 2;
    const std::size_t rows = matrices_.front().size();
    for (std::size_t i = 0; i < rows && !hull_.spans(); ++i) {
      Vector axis(rows, Rational(0));
      axis[i] = size;
      if (hull_.leaves_span(axis)) hull_.add(axis);
    }
    return hull_.spans() && hull_.prepare();
  }

  /// One generation. What lies farthest outside is added first, so that less of the rest does.
  void take_in(std::vector<Vector> images) {
    std::vector<std::pair<Vector, ExactHull::Place>> outside;
    for (std::size_t begin = 0; begin < images.size() && !asked(limits_.stop); begin += kBatch) {
      if (limits_.progress) limits_.progress(static_cast<int>(hull_.vertices().size()));
      const std::size_t end = std::min(begin + kBatch, images.size());
      const std::vector<Vector> batch(std::make_move_iterator(images.begin() + as_offset(begin)),
                                      std::make_move_iterator(images.begin() + as_offset(end)));
      std::vector<ExactHull::Place> places = places_of(hull_, batch, limits_.stop);
      for (std::size_t i = 0; i < batch.size(); ++i)
        if (!places[i].within) outside.emplace_back(batch[i], std::move(places[i]));
    }
    std::stable_sort(outside.begin(), outside.end(),
                     [](const auto& a, const auto& b) { return a.second.norm > b.second.norm; });
    bool first = true;
    for (auto& [image, place] : outside) {
      if (must_end()) return;
      if (!first && hull_.place_of(image).within) continue;
      if (first && !place.basis.empty()) hull_.begin_at(place.basis);
      first = false;
      hull_.add(image);
    }
  }

  static std::ptrdiff_t as_offset(std::size_t i) { return static_cast<std::ptrdiff_t>(i); }

  std::vector<RationalMatrix> matrices_;
  const ExactPolytopeLimits& limits_;
  ExactHull hull_;
  std::size_t next_ = 0;         // the vertex whose images come next
  std::vector<Vector> waiting_;  // images that are not looked at yet
};

}  // namespace

bool certify_invariant_polytope(const std::vector<RationalMatrix>& matrices, const Rational& level,
                                const std::vector<FieldVector<Rational>>& vertices,
                                const Stop& stop) {
  ExactHull hull(matrices.front().size());
  for (const Vector& v : vertices)
    if (!is_zero(v)) hull.add(v);
  if (!hull.spans() || !hull.prepare()) return false;
  for (const RationalMatrix& matrix : normalised(matrices, level)) {
    std::vector<Vector> images;
    for (const Vector& v : hull.vertices()) images.push_back(product(matrix, v));
    for (const ExactHull::Place& place : places_of(hull, images, stop))
      if (!place.within) return false;
  }
  return true;
}

std::optional<std::vector<FieldVector<Rational>>> find_invariant_polytope(
    const std::vector<RationalMatrix>& matrices, const Rational& level,
    const std::vector<FieldVector<Rational>>& start, const ExactPolytopeLimits& limits) {
  return ExactGrowth(matrices, level, limits).run(start);
}

}  // namespace limn::regular
