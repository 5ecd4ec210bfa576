#pragma once
/// How a study's space is searched. A method is asked for the next generation of points and told
/// what they are worth: a deterministic function of its choice and of what it was told, so that
/// whoever keeps the answers can begin anew and come to where it stopped.
///
///     while (const std::vector<UnitPoint> batch = method->next(); !batch.empty())
///       method->tell(worth_of(batch));

#include <memory>
#include <optional>
#include <vector>

#include "limn/search/point.h"

namespace limn::search {

/// What a method searches.
struct SearchSpace {
  std::size_t dimension = 1;   ///< coordinates
  std::size_t objectives = 1;  ///< to be minimised
  UnitPoint start;             ///< one for each coordinate: where methods that begin somewhere do
  std::vector<int> steps;      ///< of grids, one for each coordinate
};

class Method {
 public:
  Method() = default;
  Method(const Method&) = delete;
  Method& operator=(const Method&) = delete;
  virtual ~Method() = default;

  /// The next generation; empty: there is none. Twice the same point is possible.
  [[nodiscard]] virtual std::vector<UnitPoint> next() = 0;
  /// The fitness (point.h) of each point of the last generation, in order.
  virtual void tell(const std::vector<std::vector<double>>& worth) = 0;
};

/// Fails where limn was built without the library that the method needs.
[[nodiscard]] Result<std::unique_ptr<Method>> make_method(const MethodChoice& choice,
                                                          const SearchSpace& space);

// One for each kind of search; use make_method.
[[nodiscard]] std::unique_ptr<Method> make_grid(const MethodChoice& choice,
                                                const SearchSpace& space);
[[nodiscard]] std::unique_ptr<Method> make_random(const MethodChoice& choice,
                                                  const SearchSpace& space);
[[nodiscard]] Result<std::unique_ptr<Method>> make_sobol(const MethodChoice& choice,
                                                         const SearchSpace& space);
/// NLopt's Sbplx [Rowan1990] from `batch` starts at once, the first of them the space's.
[[nodiscard]] Result<std::unique_ptr<Method>> make_local(const MethodChoice& choice,
                                                         const SearchSpace& space);
/// pagmo's CMA-ES [Hansen2006] (one objective) or NSGA-II [Deb2002].
[[nodiscard]] Result<std::unique_ptr<Method>> make_evolution(const MethodChoice& choice,
                                                             const SearchSpace& space);
/// The first `count` points of a Sobol sequence [JoeKuo2008] after the corner and the centre, where
/// searches often begin. Precondition:
/// dimension ≤ 200.
[[nodiscard]] std::vector<UnitPoint> sobol_points(std::size_t dimension, std::size_t count);

}  // namespace limn::search
