#include "limn/regular/polytope_bound.h"

#include <deque>
#include <limits>

#include "limn/regular/rounding.h"
#include "limn/regular/symmetric_hull.h"

namespace limn {
namespace {

constexpr double kInside = 1e-10;  // images may leave the polytope by this part
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class Growth {
 public:
  Growth(const std::vector<Eigen::MatrixXd>& matrices, double level, int most_vertices)
      : matrices_(matrices),
        level_(level),
        most_vertices_(most_vertices),
        hull_(matrices.front().rows()) {}

  PolytopeBound run(const std::vector<Eigen::VectorXd>& start) {
    for (const Eigen::VectorXd& v : start) add(v);
    span();
    // what was put off until the hull spans, then images of images
    const std::vector<Image> waiting = std::move(waiting_);
    for (const Image& image : waiting)
      if (!accept(image)) return {kInfinity, made()};
    while (next_ < hull_.count())
      for (const Image& image : images_of(next_++))
        if (!accept(image)) return {kInfinity, made()};
    return {inflated(level_ * greatest_), made()};
  }

 private:
  struct Image {
    Eigen::VectorXd value;
    Eigen::VectorXd slack;  // bound of its rounding error
  };

  [[nodiscard]] int made() const { return static_cast<int>(hull_.count()); }
  void add(const Eigen::VectorXd& v) { hull_.add(v); }

  std::vector<Image> images_of(Eigen::Index vertex) const {
    const Eigen::VectorXd v = hull_.points().col(vertex);
    std::vector<Image> images;
    for (const Eigen::MatrixXd& matrix : matrices_) {
      Eigen::VectorXd slack = matrix.cwiseAbs() * v.cwiseAbs() / level_;
      slack *= rounding_error(matrix.rows() + 4);
      images.push_back({matrix * v / level_, std::move(slack)});
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
    for (const Image& image : exact_) count(1, image.slack);
  }

  void count(double norm, const Eigen::VectorXd& residual) {
    greatest_ = std::max(greatest_, inflated(norm + residual.dot(axis_norms_)));
  }

  /// False where there are too many vertices.
  bool accept(const Image& image) {
    const SymmetricHull::Combination found =
        hull_.least_combination(image.value, 1 + kInside / 2, 1 + kInside);
    if (!found.outside && found.norm <= 1 + kInside) {
      const Eigen::VectorXd rest = hull_.residual_bound(image.value, image.slack, found);
      count(found.norm, rest);
      return true;
    }
    hull_.add(image.value);
    count(1, image.slack);
    return made() <= most_vertices_;
  }

  const std::vector<Eigen::MatrixXd>& matrices_;
  double level_;
  int most_vertices_;
  SymmetricHull hull_;
  Eigen::Index next_ = 0;          // the vertex whose images come next
  std::vector<Image> waiting_;     // images within the span of a hull that was still flat
  std::vector<Image> exact_;       // images that were made vertices meanwhile
  Eigen::VectorXd axis_norms_;
  double greatest_ = 1;            // norm of an image
};

}  // namespace

PolytopeBound polytope_bound(const std::vector<Eigen::MatrixXd>& matrices, double level,
                             const std::vector<Eigen::VectorXd>& start, int most_vertices) {
  return Growth(matrices, level, most_vertices).run(start);
}

}  // namespace limn
