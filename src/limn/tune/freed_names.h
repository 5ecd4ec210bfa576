#pragma once
/// A scheme with several of its names freed at once: frequency blocks with their derivatives by the
/// numbers that the names take. Each is freed as by FreedScheme: a number for the valence analysed
/// alone where it can be told apart, else one number everywhere.

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "limn/spectrum/block_slopes.h"
#include "limn/tune/freed_scheme.h"

namespace limn::tune {

/// It keeps what it worked out: not for two threads at once. Points x have a number for each name.
class FreedNames {
 public:
  /// Fails as FreedScheme::make, and where a name comes twice or none is given.
  [[nodiscard]] static Result<FreedNames> make(const Scheme& scheme,
                                               const std::vector<std::string>& names,
                                               Reach reach = Reach::automatic);
  ~FreedNames();
  FreedNames(FreedNames&& other) noexcept;
  FreedNames& operator=(FreedNames&& other) noexcept;

  [[nodiscard]] std::size_t size() const { return each_.size(); }
  [[nodiscard]] const FreedScheme& one(std::size_t j) const { return each_[j]; }
  /// The scheme that was given.
  [[nodiscard]] const Scheme& original() const { return each_.front().original(); }
  /// FreedScheme::search_range of name j.
  [[nodiscard]] Result<Interval> search_range(std::size_t j, int n, const SearchRange* stated) {
    return each_[j].search_range(n, stated);
  }
  /// The scheme's own number of name j at valence n.
  [[nodiscard]] Result<double> own_value(std::size_t j, int n) const;

  /// SlopeAnalysis::blocks at x.
  [[nodiscard]] Result<spectrum::BlockSlopes> slopes(int n, const std::vector<double>& x,
                                                     const std::vector<int>& frequencies);
  /// All blocks at x, as FrequencyAnalysis has them.
  [[nodiscard]] Result<FrequencyBlocks> blocks(int n, const std::vector<double>& x);
  /// What the regular lattice allows at x.
  [[nodiscard]] RegularPart regular_part(int n, const std::vector<double>& x);
  /// An expression in n, the scheme's names (the freed ones are x) and the given ones beside them.
  [[nodiscard]] Result<number::Jet> evaluate(
      const Expression& expression, int n, const std::vector<double>& x,
      const std::vector<std::pair<std::string_view, number::Jet>>& beside);

 private:
  struct Instance;  // a copy of the scheme with variables in place of the names

  explicit FreedNames(std::vector<FreedScheme> each);
  Result<Instance*> at(int n);
  Result<Scheme> with_numbers(int n, const std::vector<double>& x);

  std::vector<FreedScheme> each_;
  std::map<int, std::unique_ptr<Instance>> instances_;
};

}  // namespace limn::tune
