#pragma once
/// A scheme: the content of one scheme file. The rules exist here once; every reading of them
/// (refined positions, subdivision matrices, symbols, …) goes through `refine/` or `mask.h`.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "limn/base/error.h"
#include "limn/mesh/split/split.h"
#include "limn/scheme/expression.h"
#include "limn/scheme/role.h"

namespace limn {

/// Where something stands in a scheme file, for errors; line 0: nowhere (a default, an option).
struct Place {
  std::string file;  ///< path as the user gave it
  int line = 0;      ///< from 1
  int column = 0;    ///< from 1, in bytes; 0: unknown
};

/// An expression and where its text begins.
struct Formula {
  Expression expression;  ///< in n, k, the parameters and the lets
  Place place;            ///< of its text
};

/// One weight of a rule.
struct Weight {
  std::string role;  ///< as the file names it
  Walk walk;         ///< what that name means for the rule's anchor
  Formula value;     ///< of one position of the role
};

/// One alternative of a rule; the first whose guard holds is taken.
struct RuleCase {
  std::optional<Formula> when;  ///< the guard, not 0 where it holds; nothing: always
  std::vector<Weight> weights;  ///< times their numbers of positions they sum to 1
  Place place;                  ///< where the alternative begins
};
/// A rule: its alternatives in the order of the file.
using Rule = std::vector<RuleCase>;

/// A number that a user of the scheme may choose.
struct Parameter {
  std::string name;             ///< as expressions use it
  std::string meaning;          ///< one line, for listings
  Formula value;                ///< the default, or what `set_parameter` put in its place
  std::optional<Formula> low;   ///< least value; both ends are stated or none
  std::optional<Formula> high;  ///< greatest value
};

/// What the literature states of the scheme; the tests hold it true for every shipped file.
/// Known keys: tangent, cup, saddle (eigenvalues, in n), at the valences first … last.
struct Fact {
  /// Of vertices of triangles, or of quads, alone: where meshes have both (Split::mixed).
  std::optional<Lattice> lattice;
  int first = 0;                                        ///< least valence that it is stated for
  int last = 0;                                         ///< greatest valence
  std::vector<std::pair<std::string, Formula>> values;  ///< by key, in the order of the file
  std::string source;                                   ///< citation
  Place place;                                          ///< of the table
};

/// The scheme is another one with its parameters set, at every value of its own; held true by the
/// tests as facts are.
struct Equivalence {
  std::string scheme;  ///< a shipped name
  /// Parameters of that scheme as expressions in this one's names, n among them; its others have
  /// their defaults.
  std::vector<std::pair<std::string, Formula>> with;
  std::string source;  ///< citation
  Place place;         ///< of the table
};

/// Coefficients in rows from the top (largest e2) down; on triangles a hexagon of rows, each
/// shifted by half an edge against the next. Every coefficient is times `scale`.
struct Rows {
  std::vector<std::vector<Formula>> rows;  ///< the top one first, each from left to right
  std::optional<Formula> scale;            ///< nothing: 1
  Place place;                             ///< where the rows begin
};

/// A regular mask as a product: one refinement, `stages` whole smoothing stages, single
/// directions (steps of the refined lattice, basis of lattice.h) with counts, and a kernel.
struct Factors {
  std::optional<Formula> stages;  ///< how many; nothing: none
  /// Steps and how often each counts.
  std::vector<std::pair<std::array<int, 2>, Formula>> directions;
  std::optional<Rows> kernel;  ///< nothing: 1
  Place place;                 ///< of the table
};

/// @enum Stages::First
/// Cuts all faces into quads; or triangles into triangles, and then averagings are even in number.

/// A step as a sequence of averagings [ZorinSchroeder2001; Stam2001; StamLoop2003]. The mesh is
/// cut: old vertices stay, edges give their middles, faces the means of their corners. Then values
/// go from vertices to faces and back. Two averagings together give each vertex what `pair` says, a
/// last one each face its corners' mean (boundary: refine/staged_step.h). A bilinear cut is
/// quad-dyadic's, and so is the split; after an odd number quad-dual. Where `pair` is the mean of
/// means on quads they are the tensor B-spline of degree `count` + 1. A linear cut is
/// quad-triangle's, and so is the split; `pair` may depend on how many quads a vertex has.
struct Stages {
  enum class First { bilinear, linear };
  First first = First::bilinear;  ///< the cut
  /// Of a linear cut: meshes have faces of this lattice alone, and the split is its dyadic one
  /// (lattice_schemes.h); nothing: they have both.
  std::optional<Lattice> only;
  /// Whether meshes have both kinds of faces, so that the split is quad-triangle.
  [[nodiscard]] bool is_mixed() const { return first == First::linear && !only; }
  Formula times;  ///< how many averagings: an integer in 0 … kMostAveragings, in the parameters
  int count = 0;  ///< what that is at the scheme's present parameters
  /// A vertex rule on the mesh that was cut, of the roles of PairRole alone; what a file of a
  /// bilinear cut leaves out is the mean of means: self 1/4, ring 1/(2n), diagonal 1/(4n).
  Rule pair;
  Weight corner;  ///< "1/n", of each corner in the middle of a face of n
  Place place;    ///< of the table
};
/// The weights of Stages::pair: of the vertex, of each neighbour, of the corner opposite in each
/// quad at it.
enum class PairRole : unsigned char { self, ring, diagonal };
inline constexpr std::array<std::string_view, 3> kPairRoles{"self", "ring", "diagonal"};  ///< names
/// Of a weight of such a rule.
[[nodiscard]] inline PairRole pair_role(const Weight& weight) {
  return weight.role == "self"   ? PairRole::self
         : weight.role == "ring" ? PairRole::ring
                                 : PairRole::diagonal;
}
/// So that what controls the surface round a vertex lies within the stars that are analysed.
inline constexpr int kMostAveragings = 8;

/// A file that a scheme was read from, as it was read.
struct SourceText {
  std::string name;  ///< what it is called in the file that extends it; of the first its path
  std::string text;  ///< all of it
};

/// A scheme as plain data. One that `read_scheme` or `find_scheme` gave has been checked: every
/// rule sums to 1 and is symmetric at the valences that the checks look at.
struct Scheme {
  std::string name;               ///< as stated; else the file's, without its ending
  std::string title;              ///< one line, for listings
  std::string source;             ///< citation
  std::string notes;              ///< what a user should know, free text
  std::string file;               ///< path, or "NAME.toml" of a shipped scheme
  std::vector<SourceText> texts;  ///< the file and those that it extends, in the order of reading
  const Split* split = nullptr;   ///< one of splits(), never null in a scheme that was read
  std::vector<std::pair<std::string, Formula>> lets;  ///< names for expressions, as in the file
  std::vector<Parameter> parameters;                  ///< in the order of the file
  std::array<std::optional<Rule>, kRuleKinds> rules;  ///< by RuleKind; nothing: not stated
  /// The edge_side rule that smooth triangles have; it is none of `rules` until that is asked for
  /// (use_smooth_triangles). At the lattice's own faces it says what the edge rule says.
  std::optional<Rule> smooth_triangles;
  std::vector<Fact> facts;                ///< in the order of the file
  std::vector<Equivalence> equivalences;  ///< in the order of the file
  std::optional<Rows> stated_mask;        ///< facts: the regular mask as the literature prints it
  std::optional<Rows> mask;               ///< the scheme is given by its mask alone …
  std::optional<Factors> factors;         ///< … or by factors alone
  std::optional<Stages> stages;           ///< … or by stages alone: then it has no rules
  /// weights = "decimal": the file's decimals are rounded values of what they stand for, so that
  /// its rules may sum to 1 to rounding alone (decimals.h).
  bool has_decimals = false;

  /// The rule of that kind, or nothing.
  [[nodiscard]] const std::optional<Rule>& rule(RuleKind kind) const {
    return rules[static_cast<std::size_t>(kind)];
  }
};

/// Reads a scheme file. Every fault (TOML syntax, unknown key, wrong type, unknown split, role or
/// name, a decimal, weights that do not sum to 1, an asymmetric rule, a vanishing
/// denominator…) is an error with file, line and column. `extends` takes the rules that the
/// file does not state from another scheme (a shipped name, or a path relative to the file).
/// Cost: some milliseconds, nearly all of it exact checks of the weights.
[[nodiscard]] Result<Scheme> read_scheme(const std::string& path);
/// The same of a text; `path` is for messages, and what `extends` is relative to.
[[nodiscard]] Result<Scheme> parse_scheme(std::string_view text, const std::string& path);

/// A shipped scheme by name, or else a scheme file by path; an unknown name lists the near ones.
[[nodiscard]] Result<Scheme> find_scheme(const std::string& name_or_path);
/// Names of the shipped schemes, sorted.
[[nodiscard]] std::vector<std::string> shipped_schemes();

/// Edges of triangles are refined by the scheme's rule for smooth triangles, OpenSubdiv's option of
/// that name; false, and nothing done, where it has none.
bool use_smooth_triangles(Scheme& scheme);

/// Sets parameters to expressions (which may use n and the lets), then checks the rules and the
/// ranges anew, of all of them together: counts of a box spline may fit only as a whole. Each
/// assignment is "name=expression". On an error the scheme is unchanged.
[[nodiscard]] Status set_parameters(Scheme& scheme, const std::vector<std::string>& assignments);
/// The same of one assignment.
[[nodiscard]] Status set_parameter(Scheme& scheme, const std::string& assignment);

}  // namespace limn
