#include "limn/certify/ring/quick_cells.h"

namespace limn::certify {
namespace {

constexpr double kSharp = 1e-3;

Eigen::VectorXd vector_of(const std::vector<double>& numbers) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(),
                                           static_cast<Eigen::Index>(numbers.size()));
}

double sum_of_sizes(const Eigen::MatrixXd& rows, Eigen::Index row) {
  return regular::inflated(rows.row(row).cwiseAbs().sum());
}

QuickCells::Coordinate coordinate_of(const CellMap::Coordinate& map) {
  QuickCells::Coordinate result;
  result.origin = DoubleBall(map.origin);
  result.gradient = {DoubleBall(map.gradient[0]), DoubleBall(map.gradient[1])};
  result.residual.resize(static_cast<Eigen::Index>(map.residual.size()));
  for (std::size_t i = 0; i < map.residual.size(); ++i) {
    const DoubleBall entry(map.residual[i]);
    result.residual(static_cast<Eigen::Index>(i)) = entry.value;
    result.error = std::max(result.error, entry.error);
  }
  return result;
}

}  // namespace

QuickCells::QuickCells(const CellMatrices& cells, const Contraction& bounds)
    : dual_(cells.dual),
      inverse_scale_(Rational(Integer(1), Integer(cells.scale))),
      gradient_bounds_{vector_of(bounds.gradient[0]), vector_of(bounds.gradient[1])},
      value_bounds_(vector_of(bounds.value)) {
  const auto columns = static_cast<Eigen::Index>(cells.sizes.size());
  for (std::size_t d = 0; d < cells.residual.size(); ++d) {
    Digit& digit = digits_.emplace_back();
    digit.rows.resize(columns + 3, columns);
    const auto fill = [&](Eigen::Index row, const std::vector<Rational>& entries) {
      for (Eigen::Index j = 0; j < columns; ++j)
        digit.rows(row, j) = to_double(entries[static_cast<std::size_t>(j)]);
    };
    fill(0, cells.value[d]);
    fill(1, cells.gradient[d][0]);
    fill(2, cells.gradient[d][1]);
    for (Eigen::Index i = 0; i < columns; ++i)
      fill(i + 3, cells.residual[d][static_cast<std::size_t>(i)]);
    for (std::size_t i = 0; i < 3; ++i)
      digit.norms[i] = sum_of_sizes(digit.rows, static_cast<Eigen::Index>(i));
    digit.residual_norm = 0;
    for (Eigen::Index i = 3; i < columns + 3; ++i)
      digit.residual_norm = std::max(digit.residual_norm, sum_of_sizes(digit.rows, i));
    const int place = static_cast<int>(d);
    const auto along = [&](int x) {
      return DoubleBall(Rational(Integer(x), Integer(cells.scale)) + cells.shift);
    };
    digit.origin = {along(place % cells.scale), along(place / cells.scale)};
  }
}

QuickCells::Map QuickCells::map_of(const CellMap& map) const {
  return {coordinate_of(map.u), coordinate_of(map.v)};
}

QuickCells::Coordinate QuickCells::part(const Coordinate& map, const Digit& digit) const {
  const Eigen::VectorXd rows = digit.rows * map.residual;
  const double largest = map.residual.size() == 0 ? 0 : map.residual.cwiseAbs().maxCoeff();
  // an entry of a row is rounded, too: rounding_error allows for twice as many terms
  const double relative = map.error + regular::rounding_error(map.residual.size()) * largest;
  const auto entry = [&](std::size_t i) {
    return DoubleBall(rows(static_cast<Eigen::Index>(i)),
                      regular::inflated(digit.norms[i] * relative));
  };
  Coordinate result;
  result.origin =
      map.origin + digit.origin[0] * map.gradient[0] + digit.origin[1] * map.gradient[1] + entry(0);
  result.gradient = {map.gradient[0] * inverse_scale_ + entry(1),
                     map.gradient[1] * inverse_scale_ + entry(2)};
  result.residual = rows.tail(map.residual.size());
  result.error = regular::inflated(digit.residual_norm * relative);
  return result;
}

QuickCells::Map QuickCells::part(const Map& map, std::size_t digit) const {
  return {part(map.u, digits_[digit]), part(map.v, digits_[digit])};
}

DoubleBall QuickCells::wide(const DoubleBall& middle, const Eigen::VectorXd& bound,
                            const Coordinate& map) {
  const double more = bound.dot(map.residual.cwiseAbs()) + bound.sum() * map.error;
  return {middle.value, regular::inflated(middle.error + more)};
}

DoubleBall QuickCells::jacobian(const Map& map) const {
  const auto along = [&](const Coordinate& one, std::size_t i) {
    return wide(one.gradient[i], gradient_bounds_[i], one);
  };
  return along(map.u, 0) * along(map.v, 1) - along(map.u, 1) * along(map.v, 0);
}

QuickCells::Values QuickCells::values(const Map& map) const {
  // the cell is at 0 … 1 from its origin, or at -½ … ½ (dual)
  const DoubleBall along(dual_ ? 0 : 0.5, 0.5);
  const auto of = [&](const Coordinate& one) {
    return wide(one.origin + along * one.gradient[0] + along * one.gradient[1], value_bounds_, one);
  };
  return {of(map.u), of(map.v)};
}

bool QuickCells::is_sharp(const Map& map) const {
  const auto sharp = [&](const Coordinate& one) {
    bool result = true;
    for (std::size_t i = 0; i < 2; ++i) {
      const double rounding = one.gradient[i].error + gradient_bounds_[i].sum() * one.error;
      const double width = gradient_bounds_[i].dot(one.residual.cwiseAbs());
      result = result && rounding <= kSharp * width;
    }
    return result;
  };
  return sharp(map.u) && sharp(map.v);
}

}  // namespace limn::certify
