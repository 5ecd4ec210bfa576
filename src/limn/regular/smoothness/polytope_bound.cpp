#include "limn/regular/smoothness/polytope_bound.h"

#include <algorithm>
#include <limits>
#include <set>

#include "limn/base/parallel.h"

#include "limn/regular/smoothness/rounding.h"
#include "limn/regular/smoothness/symmetric_hull.h"

namespace limn::regular {
namespace {

constexpr double kInside = 3e-9;  // images may leave the polytope by this part
constexpr double kProved = 1e-7;  // with all that rounding may have added
constexpr std::ptrdiff_t kBoundGrain = 8;
constexpr int kBoundBatch = 256;  // images between two reports of progress
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class Growth {
 public:
  Growth(const std::vector<Eigen::MatrixXd>& matrices, double level, const PolytopeLimits& limits)
      : matrices_(matrices), level_(level), limits_(limits), hull_(matrices.front().rows()) {}

  PolytopeBound run(const std::vector<Eigen::VectorXd>& start) {
    for (const Eigen::VectorXd& v : start) hull_.add(v);
    span();
    if (!axis_norms_.allFinite()) return {kInfinity, made()};
    std::vector<Image> images = std::move(waiting_);
    for (Eigen::Index done = next_; !images.empty() || done < hull_.count();) {
      for (; done < hull_.count(); ++done)
        for (Image& image : images_of(done)) images.push_back(std::move(image));
      take_in(images);
      if (must_end()) return {kInfinity, made()};
      images.clear();
    }
    return {inflated(level_ * greatest_), made()};
  }

 private:
  struct Image {
    Eigen::VectorXd value;
    Eigen::VectorXd slack;  // bound of its rounding error
    SymmetricHull::Combination found;
    double norm = kInfinity;  // proved bound
    [[nodiscard]] bool inside() const { return norm <= 1 + kProved; }
  };

  [[nodiscard]] int made() const { return static_cast<int>(hull_.count()); }
  [[nodiscard]] bool must_end() const {
    return made() > limits_.most_vertices || asked(limits_.stop);
  }
  void tell() const {
    if (limits_.progress) limits_.progress(made());
  }

  std::vector<Image> images_of(Eigen::Index vertex) const {
    const Eigen::VectorXd v = hull_.points().col(vertex);
    std::vector<Image> images;
    for (const Eigen::MatrixXd& matrix : matrices_) {
      Eigen::VectorXd slack = matrix.cwiseAbs() * v.cwiseAbs() / level_;
      slack *= rounding_error(matrix.rows() + 4);
      images.push_back({matrix * v / level_, std::move(slack), {}, kInfinity});
    }
    return images;
  }

  /// Adds images, and at last multiples of the axes, until the hull spans.
  void span() {
    while (!hull_.spans() && next_ < hull_.count())
      for (Image& image : images_of(next_++)) {
        if (!hull_.spans() && image.value.norm() > 0 && hull_.leaves_span(image.value)) {
          hull_.add(image.value);
          exact_.push_back(image);
        } else {
          waiting_.push_back(std::move(image));
        }
      }
    const double size = hull_.points().colwise().norm().maxCoeff() / 100;
    for (Eigen::Index i = 0; !hull_.spans(); ++i) {
      const Eigen::VectorXd axis = size * Eigen::VectorXd::Unit(matrices_.front().rows(), i);
      if (hull_.leaves_span(axis)) hull_.add(axis);
    }
    axis_norms_ = hull_.axis_norms();
    for (const Image& image : exact_) count_vertex(image);
    start_ = hull_.start_at(hull_.first_basis());
  }

  void count_vertex(const Image& image) {
    greatest_ = std::max(greatest_, inflated(1 + image.slack.dot(axis_norms_)));
  }

  void measure(Image& image, const SymmetricHull::Start& begin, double too_much) const {
    image.found = hull_.least_combination(image.value, begin, 1 + kInside / 2, too_much);
    image.norm = kInfinity;
    if (image.found.outside || image.found.norm > 1 + kInside) return;
    const Eigen::VectorXd rest = hull_.residual_bound(image.value, image.slack, image.found);
    image.norm = inflated(image.found.norm + rest.dot(axis_norms_));
  }

  /// One generation. What lies farthest outside is added first, so that less of the rest does.
  void take_in(std::vector<Image>& images) {
    for (std::size_t begin = 0; begin < images.size() && !asked(limits_.stop);
         begin += kBoundBatch) {
      tell();
      base::parallel_for(
          begin, std::min(begin + kBoundBatch, images.size()),
          [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last && !asked(limits_.stop); ++i)
              measure(images[i], start_, 1 + kInside);
          },
          kBoundGrain);
    }
    if (must_end()) return;
    std::stable_sort(images.begin(), images.end(),
                     [](const Image& a, const Image& b) { return a.found.norm > b.found.norm; });
    std::set<Eigen::Index> used;
    for (const Image& image : images)
      used.insert(image.found.points.begin(), image.found.points.end());
    hull_.prefer({used.begin(), used.end()});
    for (Image& image : images) {
      if (!image.inside()) measure(image, hull_.start_at(image.found.points), 1 + kInside);
      if (image.inside()) {
        greatest_ = std::max(greatest_, image.norm);
        continue;
      }
      count_vertex(image);
      hull_.add(image.value);
      if (must_end()) return;
      if (made() % kBoundBatch == 0) tell();
    }
    start_ = hull_.start_at(images.front().found.points);
  }

  const std::vector<Eigen::MatrixXd>& matrices_;
  double level_;
  const PolytopeLimits& limits_;
  SymmetricHull hull_;
  Eigen::Index next_ = 0;       // the vertex whose images come next
  std::vector<Image> waiting_;  // images within the span of a hull that was still flat
  std::vector<Image> exact_;    // images that were made vertices meanwhile
  Eigen::VectorXd axis_norms_;
  SymmetricHull::Start start_;  // where searches begin
  double greatest_ = 1;         // norm of an image
};

}  // namespace

PolytopeBound polytope_bound(const std::vector<Eigen::MatrixXd>& matrices, double level,
                             const std::vector<Eigen::VectorXd>& start,
                             const PolytopeLimits& limits) {
  return Growth(matrices, level, limits).run(start);
}

}  // namespace limn::regular
