#include "limn/search/front.h"

#include <algorithm>
#include <cmath>

namespace limn::search {
namespace {

struct Candidate {
  std::size_t number;
  std::vector<double> worth;
};

/// Whether a is as good as b in everything; b comes later in the order of worth.
bool covers(const Candidate& a, const Candidate& b) {
  for (std::size_t i = 0; i < a.worth.size(); ++i)
    if (a.worth[i] > b.worth[i]) return false;
  return true;
}

}  // namespace

std::vector<std::size_t> best_points(const Study& study, const std::vector<Evaluated>& points) {
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].outcome.feasible) candidates.push_back({i, fitness(study, points[i].outcome)});
  // nobody is covered by one that comes later, but for equal ones, of which the first stays
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.worth < b.worth; });
  std::vector<const Candidate*> front;
  for (const Candidate& one : candidates) {
    // of two objectives the last of the front has the least second one
    const bool covered = one.worth.size() <= 2
                             ? !front.empty() && covers(*front.back(), one)
                             : std::any_of(front.begin(), front.end(), [&](const Candidate* other) {
                                 return covers(*other, one);
                               });
    if (!covered) front.push_back(&one);
  }
  std::vector<std::size_t> numbers;
  for (const Candidate* one : front) numbers.push_back(one->number);
  return numbers;
}

std::vector<std::size_t> spread(const Study& study, const std::vector<Evaluated>& points,
                                const std::vector<std::size_t>& front, std::size_t count) {
  if (front.size() <= count) return front;
  if (count <= 1) return {front.begin(), front.begin() + static_cast<std::ptrdiff_t>(count)};
  const std::size_t objectives = study.objectives.size();
  std::vector<double> low(objectives, INFINITY), high(objectives, -INFINITY);
  std::vector<std::vector<double>> worth;
  for (const std::size_t i : front) {
    worth.push_back(fitness(study, points[i].outcome));
    for (std::size_t j = 0; j < objectives; ++j) {
      low[j] = std::min(low[j], worth.back()[j]);
      high[j] = std::max(high[j], worth.back()[j]);
    }
  }
  std::vector<double> length(front.size(), 0);
  for (std::size_t i = 1; i < front.size(); ++i) {
    double square = 0;
    for (std::size_t j = 0; j < objectives; ++j)
      if (high[j] > low[j])
        square += std::pow((worth[i][j] - worth[i - 1][j]) / (high[j] - low[j]), 2);
    length[i] = length[i - 1] + std::sqrt(square);
  }
  std::vector<std::size_t> chosen;
  for (std::size_t k = 0; k < count; ++k) {
    const double target = length.back() * static_cast<double>(k) / static_cast<double>(count - 1);
    const auto at = std::lower_bound(length.begin(), length.end(), target * (1 - 1e-12));
    const std::size_t number = front[static_cast<std::size_t>(at - length.begin())];
    if (chosen.empty() || chosen.back() != number) chosen.push_back(number);
  }
  return chosen;
}

}  // namespace limn::search
