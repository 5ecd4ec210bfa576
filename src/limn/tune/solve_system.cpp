#include "limn/tune/solve_system.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <fmt/core.h>

#include "limn/number/near_rational.h"
#include "limn/tune/margin.h"

namespace limn::tune {
namespace {

constexpr int kStarts = 48;     // beside the scheme's own numbers
constexpr int kMostSteps = 60;  // of Newton's method
constexpr int kMostHalvings = 12;
constexpr double kConverged = 1e-15;  // a residual below which no step can do better
constexpr double kSame = 1e-8;        // solutions closer than this part of the ranges are one
constexpr double kAccuracy = 1e-12;   // of a solution
constexpr double kSingular = 1e-9;    // of the Jacobian's largest pivot

using Values = std::vector<double>;

/// Residuals of the equations and their Jacobian.
struct Linearised {
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;

  [[nodiscard]] double size() const { return residuals.lpNorm<Eigen::Infinity>(); }
};

/// Numbers spread evenly over the unit cube: multiples of powers of the root of x^(d+1) = x + 1,
/// less their whole parts.
std::vector<Values> spread_starts(std::size_t dimension, int count) {
  double root = 2;
  for (int i = 0; i < 60; ++i) root = std::pow(1 + root, 1.0 / static_cast<double>(dimension + 1));
  std::vector<Values> points;
  for (int i = 0; i < count; ++i) {
    Values point;
    for (std::size_t j = 0; j < dimension; ++j) {
      const double place = 0.5 + i * std::pow(1 / root, static_cast<double>(j + 1));
      point.push_back(place - std::floor(place));
    }
    points.push_back(std::move(point));
  }
  return points;
}

/// At valence 3 nothing is asked of a saddle: there is none.
bool is_asked_at(const Requirement& one, int n) {
  return std::all_of(one.used.begin(), one.used.end(),
                     [&](std::size_t i) { return kComponents[i].exists_at(n); });
}

class System {
 public:
  System(FreedNames& names, const std::vector<Requirement>& requirements, int n,
         std::vector<Interval> box)
      : names_(names), n_(n), box_(std::move(box)) {
    std::set<int> frequencies{0};
    for (const Requirement& one : requirements) {
      if (!is_asked_at(one, n)) continue;
      (one.has_range() ? conditions_ : equations_).push_back(&one);
      for (const std::size_t i : one.used) frequencies.insert(kComponents[i].frequency);
    }
    frequencies_.assign(frequencies.begin(), frequencies.end());
  }

  [[nodiscard]] std::size_t equations() const { return equations_.size(); }

  Result<Linearised> at(const Values& x) {
    const Result<spectrum::BlockSlopes> slopes = names_.slopes(n_, x, frequencies_);
    if (!slopes) return slopes.error();
    std::array<std::optional<Result<number::Jet>>, kComponents.size()> components;
    Linearised result{Eigen::VectorXd(equations_.size()),
                      Eigen::MatrixXd(equations_.size(), names_.size())};
    for (std::size_t i = 0; i < equations_.size(); ++i) {
      std::vector<std::pair<std::string_view, number::Jet>> beside;
      for (const std::size_t used : equations_[i]->used) {
        if (!components[used]) components[used] = component(*slopes, kComponents[used]);
        if (!*components[used]) return components[used]->error();
        beside.emplace_back(kComponents[used].name, **components[used]);
      }
      const Result<number::Jet> left = names_.evaluate(*equations_[i]->left, n_, x, beside);
      const Result<number::Jet> right = names_.evaluate(*equations_[i]->right, n_, x, beside);
      if (!left || !right) return (left ? right : left).error();
      const number::Jet difference = *left - *right;
      const auto row = static_cast<Eigen::Index>(i);
      result.residuals(row) = difference.value;
      for (std::size_t j = 0; j < names_.size(); ++j)
        result.jacobian(row, static_cast<Eigen::Index>(j)) = difference.slope(j);
    }
    return result;
  }

  /// Where Newton's method ends from x: nothing where that is no solution.
  std::optional<Values> solved_from(Values x, std::string& trouble) {
    Result<Linearised> here = at(x);
    for (int step = 0; here && here->size() > kConverged && step < kMostSteps; ++step) {
      const std::optional<Values> next = next_point(x, *here);
      if (!next) break;
      x = *next;
    }
    if (!here) trouble = here.error().message;
    if (!here || here->size() > kSolved) return std::nullopt;
    return x;
  }

  /// Whether the requirements hold at a solution, and its fractions.
  std::optional<SystemSolution> judged(Values x) {
    SystemSolution solution;
    round_to_fractions(x, solution);
    solution.values = x;
    const Result<Linearised> here = at(x);
    const Result<FrequencyBlocks> blocks = names_.blocks(n_, x);
    if (!here || !blocks) return std::nullopt;
    solution.residual = here->size();
    solution.found = approx_eigencomponents(*blocks, names_.regular_part(n_, x));
    judge(solution);
    return solution;
  }

 private:
  Result<number::Jet> component(const spectrum::BlockSlopes& slopes,
                                const Component& wanted) const {
    const BlockSpectrum spectrum = approx_spectrum(slopes.blocks, wanted.frequency);
    if (!labelled(wanted, spectrum))
      return Error{fmt::format("frequency {} is led by no real eigenvalue", wanted.frequency)};
    return spectrum::eigenvalue_jet(slopes, spectrum.eigenvalues[wanted.index]);
  }

  /// A point with smaller residuals along Newton's direction, within the ranges; `here` is then
  /// what is known there.
  std::optional<Values> next_point(const Values& x, Linearised& here) {
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
    solver.setThreshold(kSingular);
    // in units of the ranges, so that the least step is the same whatever the names are called in
    Eigen::MatrixXd scaled = here.jacobian;
    for (Eigen::Index j = 0; j < scaled.cols(); ++j) scaled.col(j) *= width(j);
    const Eigen::VectorXd step = solver.compute(scaled).solve(-here.residuals);
    double part = 1;
    for (int halving = 0; halving < kMostHalvings; ++halving, part /= 2) {
      Values next = x;
      for (std::size_t j = 0; j < x.size(); ++j) {
        const auto index = static_cast<Eigen::Index>(j);
        next[j] = std::clamp(x[j] + part * step(index) * width(index), box_[j].low, box_[j].high);
      }
      if (next == x) return std::nullopt;
      Result<Linearised> there = at(next);
      if (!there || !(there->size() < here.size())) continue;
      here = *std::move(there);
      return next;
    }
    return std::nullopt;
  }

  [[nodiscard]] double width(Eigen::Index j) const {
    const Interval& one = box_[static_cast<std::size_t>(j)];
    return one.high - one.low;
  }

  /// Puts fractions in the place of numbers next to them, where all equations then hold as well.
  void round_to_fractions(Values& x, SystemSolution& solution) {
    solution.rationals.assign(x.size(), std::nullopt);
    Values rounded = x;
    for (std::size_t j = 0; j < x.size(); ++j)
      if ((solution.rationals[j] = number::near_rational(x[j], kAccuracy)))
        rounded[j] = to_double(*solution.rationals[j]);
    const Result<Linearised> before = at(x);
    const Result<Linearised> after = at(rounded);
    if (before && after && after->size() <= std::max(before->size(), 1e-14))
      x = rounded;
    else
      solution.rationals.assign(x.size(), std::nullopt);
  }

  void judge(SystemSolution& solution) const {
    solution.holds = Truth::yes;
    if (solution.residual > kSolved) {
      solution.holds = Truth::undecided;
      solution.reason = fmt::format("rounding hides it: the residual is {:.1e}", solution.residual);
    }
    for (const Requirement* one : conditions_) {
      const auto [truth, why] = asked_of(*one, solution);
      if (truth == Truth::yes) continue;
      if (solution.reason.empty()) solution.reason = why;
      solution.holds = solution.holds && truth;
    }
  }

  /// A requirement that has a range.
  [[nodiscard]] std::pair<Truth, std::string> asked_of(const Requirement& one,
                                                       const SystemSolution& solution) const {
    const Verdict& verdict = solution.found.verdict;
    const auto said = [&](Truth truth) {
      return std::pair(truth, fmt::format("{}: {}", one.text,
                                          verdict.reasons.empty() ? std::string(to_string(truth))
                                                                  : verdict.reasons.front()));
    };
    if (one.relation == Relation::convergent) return said(verdict.convergent);
    if (one.relation == Relation::c1) return said(verdict.c1_necessary);
    if (one.relation == Relation::bounded_curvature) return said(verdict.bounded_curvature);
    const Result<double> above = excess(one, solution);
    if (!above) return {Truth::no, above.error().text()};
    const bool holds = is_closed(one.relation) ? *above >= -kEqualBelow : *above > kEqualBelow;
    return {holds ? Truth::yes : Truth::no,
            fmt::format("'{}' is missed by {:.3g}", one.text, std::abs(*above))};
  }

  [[nodiscard]] Result<double> excess(const Requirement& one,
                                      const SystemSolution& solution) const {
    const ComponentValues values = component_values(solution.found);
    std::vector<std::pair<std::string_view, number::Jet>> beside;
    for (const std::size_t i : one.used) {
      if (!values[i])
        return Error{fmt::format("there is no {} at valence {}", kComponents[i].name, n_)};
      beside.emplace_back(kComponents[i].name, number::Jet(*values[i]));
    }
    const Result<number::Jet> left = names_.evaluate(*one.left, n_, solution.values, beside);
    const Result<number::Jet> right = names_.evaluate(*one.right, n_, solution.values, beside);
    if (!left || !right) return (left ? right : left).error();
    return left->value - right->value;
  }

  FreedNames& names_;
  int n_;
  std::vector<Interval> box_;
  std::vector<const Requirement*> equations_, conditions_;
  std::vector<int> frequencies_;
};

/// The scheme's own numbers, if they are in the ranges.
std::optional<Values> own_numbers(const FreedNames& names, int n,
                                  const std::vector<Interval>& box) {
  Values own;
  for (std::size_t j = 0; j < names.size(); ++j) {
    const Result<double> value = names.own_value(j, n);
    if (!value || *value < box[j].low || *value > box[j].high) return std::nullopt;
    own.push_back(*value);
  }
  return own;
}

double distance(const Values& a, const Values& b, const std::vector<Interval>& box) {
  double square = 0;
  for (std::size_t j = 0; j < a.size(); ++j)
    square += std::pow((a[j] - b[j]) / (box[j].high - box[j].low), 2);
  return std::sqrt(square);
}

Status check_count(const std::vector<Requirement>& requirements, std::size_t names) {
  const auto equations = static_cast<std::size_t>(
      std::count_if(requirements.begin(), requirements.end(),
                    [](const Requirement& one) { return !one.has_range(); }));
  if (equations == 0)
    return Error{"no requirement is an equation", "one at least is solved, the others are asked"};
  if (equations <= names) return Done{};
  return Error{fmt::format("{} equations are more than {} free names", equations, names),
               "free more names, or leave out equations"};
}

}  // namespace

Result<SystemSolutions> solve_system_at(FreedNames& names,
                                        const std::vector<Requirement>& requirements, int n,
                                        const std::vector<const SearchRange*>& ranges,
                                        const Stop& stop) {
  if (Status status = check_count(requirements, names.size()); !status) return status.error();
  SystemSolutions result;
  result.valence = n;
  for (std::size_t j = 0; j < names.size(); ++j) {
    const Result<Interval> range = names.search_range(j, n, ranges[j]);
    if (!range) return range.error();
    result.searched.push_back(*range);
  }
  System system(names, requirements, n, result.searched);
  if (system.equations() == 0) {
    result.reason = "no equation has a value at this valence";
    return result;
  }
  const std::optional<Values> own = own_numbers(names, n, result.searched);
  std::vector<Values> starts;
  if (own) starts.push_back(*own);
  for (Values& place : spread_starts(names.size(), kStarts)) {
    for (std::size_t j = 0; j < place.size(); ++j)
      place[j] =
          result.searched[j].low + place[j] * (result.searched[j].high - result.searched[j].low);
    starts.push_back(std::move(place));
  }
  const bool many = system.equations() < names.size();
  std::string trouble;
  for (const Values& start : starts) {
    if ((result.time_ended = asked(stop))) return result;
    if (many && !result.solutions.empty()) break;
    ++result.starts;
    const std::optional<Values> x = system.solved_from(start, trouble);
    if (!x) continue;
    const bool known = std::any_of(result.solutions.begin(), result.solutions.end(),
                                   [&](const SystemSolution& one) {
                                     return distance(one.values, *x, result.searched) < kSame;
                                   });
    if (known) continue;
    if (std::optional<SystemSolution> one = system.judged(*x))
      result.solutions.push_back(*std::move(one));
  }
  std::sort(result.solutions.begin(), result.solutions.end(),
            [&](const SystemSolution& a, const SystemSolution& b) {
              if (!own) return a.values < b.values;
              return distance(a.values, *own, result.searched) <
                     distance(b.values, *own, result.searched);
            });
  if (result.solutions.empty())
    result.reason = fmt::format("none found from {} starts", result.starts) +
                    (trouble.empty() ? "" : "; " + trouble);
  return result;
}

}  // namespace limn::tune
