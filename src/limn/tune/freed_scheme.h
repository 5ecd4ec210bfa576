#pragma once
/// A scheme with one of its names freed: frequency blocks as functions of a number x that a
/// parameter or a let takes.
///
/// Where the name's definition depends on n and only rules at the star's centre use it (the vertex
/// and edge-end rules; corner rules of dual splits), it is a number for each valence: x is its
/// value at the valence analysed, and the regular neighbours keep the scheme's own definition.
/// Else, or on demand, it is one number everywhere. At a regular valence the neighbours have x in
/// either case.

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "limn/base/error.h"
#include "limn/scheme/expression.h"
#include "limn/scheme/mask.h"
#include "limn/scheme/scheme.h"
#include "limn/spectrum/frequency_blocks.h"

namespace limn {

// What is asked of a scheme at a vertex: an equation, an inequality or a verdict.

/// An equation, an inequality between left and right, or a verdict.
enum class Relation {
  equal,             ///< left = right
  above,             ///< left > right (or <, with the sides exchanged)
  at_least,          ///< left ≥ right (or ≤, with the sides exchanged)
  convergent,        ///< Verdict::convergent
  c1,                ///< Verdict::c1_necessary
  bounded_curvature  ///< Verdict::bounded_curvature
};

/// "cup = tangent^2", "saddle < tangent^2", "c1", … Sides are expressions (scheme/expression.h) in
/// the names of kComponents, n and the scheme's own names; where both have a name, the component
/// has it. `==` and `=` are the same.
struct Requirement {
  std::string text;                     ///< as it was given
  Relation relation = Relation::equal;  ///< what is asked
  std::optional<Expression> left;       ///< nothing for verdicts
  std::optional<Expression> right;      ///< left - right has the relation to 0
  std::vector<std::size_t> used;        ///< which of kComponents, in the order of first use

  /// Whether its truth holds on intervals rather than at single values.
  [[nodiscard]] bool has_range() const { return relation != Relation::equal; }

  /// Reads a requirement for that scheme. Fails with the fault and its column in the message:
  /// unknown names, syntax, no relation.
  [[nodiscard]] static Result<Requirement> parse(std::string_view text, const Scheme& scheme);
};

/// A closed interval of the real line, low ≤ high.
struct Interval {
  double low = 0;   ///< lower end
  double high = 0;  ///< upper end
};

/// Where a search looks, as expressions in n and the scheme's names.
struct SearchRange {
  Expression low;   ///< lower end
  Expression high;  ///< upper end
  /// "LOW,HIGH". Fails with the fault and its column in the message.
  [[nodiscard]] static Result<SearchRange> parse(std::string_view text);
};

/// Lets and parameters that the rules of interior vertices use, in the order of the file, and that
/// no guard and no index k depends on.
[[nodiscard]] std::vector<std::string> freeable_names(const Scheme& scheme);

/// Where the freed name takes the number x.
enum class Reach {
  automatic,  ///< at the valence analysed alone, if that can be told apart (see above)
  everywhere  ///< in every rule, one number for all valences
};

/// A scheme with a freed name. It keeps what it worked out: not for two threads at once.
class FreedScheme {
 public:
  /// `name`: one of freeable_names; else the error lists those. The scheme is copied, and may end
  /// before this.
  [[nodiscard]] static Result<FreedScheme> make(const Scheme& scheme, const std::string& name,
                                                Reach reach = Reach::automatic);
  ~FreedScheme();
  /// A move leaves `other` good for nothing but assignment and destruction.
  FreedScheme(FreedScheme&& other) noexcept;
  /// As the constructor.
  FreedScheme& operator=(FreedScheme&& other) noexcept;

  /// The freed let or parameter.
  [[nodiscard]] const std::string& name() const { return name_; }
  /// The scheme that was given, the name with its own value.
  [[nodiscard]] const Scheme& original() const { return *original_; }
  /// Whether x is one number everywhere, not one for each valence.
  [[nodiscard]] bool is_one_number() const { return everywhere_; }
  /// Whether the neighbours of a vertex (dual: face) of valence n have x as well. Each value of x
  /// then costs a refined star, else only the putting in of a number.
  [[nodiscard]] bool everywhere(int n) const { return everywhere_ || n == regular_; }

  /// The blocks at valence n ≥ 3 where the name is x. Fails as FrequencyAnalysis::blocks: where x
  /// has the weights sum to something else than 1, divides by zero, …
  [[nodiscard]] Result<FrequencyBlocks> blocks(int n, double x);
  /// Those of 0 and of these frequencies alone, as FrequencyAnalysis::blocks.
  [[nodiscard]] Result<FrequencyBlocks> blocks(int n, double x,
                                               const std::vector<int>& frequencies);

  /// What the regular lattice allows where the name is x, or the simple fraction that x is the
  /// double of (number/near_rational.h; regular/smoothness/regularity.h):
  /// the scheme's own where x changes no neighbour. Else, where the mask at x has sum rules of
  /// order 3 or more, found for each x; below, where curvature is unbounded unless shifts are
  /// dependent, that it is unbounded at one such x is taken to hold at all of that order.
  [[nodiscard]] RegularPart regular_part(int n, double x);

  /// An expression in n, the scheme's names (the freed one is x) and the given ones beside them.
  [[nodiscard]] Result<double> evaluate(
      const Expression& expression, int n, double x,
      const std::vector<std::pair<std::string_view, double>>& beside = {});

  /// Where to look at valence n: `stated`, or else the parameter's range, or else [-4, 4]; a
  /// missing end of the parameter's range is 8 from the other. Fails where that is empty.
  [[nodiscard]] Result<Interval> search_range(int n, const SearchRange* stated);

 private:
  struct Instance;  // a copy of the scheme with x in it, and its analysis

  FreedScheme(const Scheme& scheme, std::string name, bool everywhere);
  Result<std::unique_ptr<Instance>> build(int n) const;
  Result<Instance*> named_at(int n, double x);
  Result<Instance*> fixed_at(int n, double x);
  Result<FrequencyAnalysis*> analysis_at(int n, double x);

  std::unique_ptr<Scheme> original_;  // so that a move leaves pointers into it whole
  std::string name_;
  bool everywhere_;
  int regular_;
  /// By valence; x is put in at each use. Refined only where x changes no neighbour.
  std::map<int, std::unique_ptr<Instance>> named_;
  std::optional<RegularPart> own_regular_part_;
  std::map<int, RegularPart> low_order_parts_;  // by the order of the sum rules
  /// By x, which the neighbours have as well; the same for all valences.
  std::map<double, std::unique_ptr<Instance>> fixed_;
};

}  // namespace limn
