#pragma once
/// How smooth a scheme is on the regular lattice, with proof.
///
/// The refined data S^n f have differences of order k whose growth is the joint spectral radius ρ
/// of finitely many matrices: the transition operators, one for each digit, on the smallest space
/// of sequences that holds the differences of order k of the unit impulse and that they map to
/// itself (transition_operators.h). With k the order of the sum rules, the limit functions have
/// the Hölder exponent -log ρ / log √|det M| at least, and exactly that where the shifts of φ are
/// stable [DynLevin2002; Jia1999; Han2003]. Hölder exponents are Zygmund's: α = r + s, 0 < s ≤ 1,
/// says that the derivatives of order r have differences, of the second order where s = 1, that
/// shrink like |h|^{s'} for every s' < s.
///
/// ρ lies between the spectral radius of one product and a norm (joint_spectral_radius.h), after
/// common invariant subspaces have been split off exactly. All that is called proved rests on exact
/// rationals or on doubles rounded outwards.
///
/// **Exact exponents.** Where the product has a rational eigenvalue μ, |μ|^(1/length) is rational
/// too, and a polytope in exact numbers is invariant at that level (exact_polytope.h), ρ is known
/// exactly, and the exponent with it: 2, log2(3). The polytope proves more: on its block, products
/// of n operators are at most a constant times ρⁿ.
///
/// **Attained.** An exponent α = r + s, r whole, 0 < s ≤ 1, is called attained where the
/// derivatives of order r have differences of the first order that are O(|h|^s), that is, where
/// differences of order r + 1 of the limit functions are O(|h|^α). This is so where products of n
/// operators on differences of order r + 1 of the data are O(ρⁿ); for stable shifts only then.
/// Where they grow like n^p ρⁿ, differences of order r + 1 grow like |h|^α log^p(1/|h|). (A step h
/// is a sum of lattice steps, one of each level from |h| on. In the product of r + 1 such steps the
/// longer ones are sums of steps of the finest level among them, so that lattice steps tell of
/// all.)
///
/// For α not whole, the operators on differences of order k tell as much. For whole α = r + 1, to
/// be attained is more than membership in Zygmund's class: the polynomials of degree α have an
/// eigenvalue of the size |det M|^(-α/2) on those differences too, and where it meets the ρ of the
/// differences of order k there may be a Jordan block. So the four-point scheme is in Zygmund's
/// class of the exponent 2, and its second differences have a logarithm [Dubuc1986]; the
/// butterfly's have its square [GuglielmiProtasov2016].
///
/// Differences tell no more than the sum rules, and nothing from above where shifts depend on one
/// another. Where φ is a box spline (box_spline.h), its exponent is known in spite of that.

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "limn/base/budget.h"
#include "limn/base/error.h"
#include "limn/base/rational.h"
#include "limn/base/truth.h"
#include "limn/scheme/mask.h"

namespace limn {

// What is known of the joint spectral radius ρ of finitely many matrices: the growth of the
// largest of all products of n of them, lim max ‖A_{i1} … A_{in}‖^{1/n} [Jungers2009]. It is found
// by joint_spectral_radius.h.

/// A bracket of ρ, and what it rests on.
struct JointSpectralRadius {
  /// One diagonal block along a chain of common invariant subspaces.
  struct Block {
    int size = 0;      ///< rows of its matrices
    double lower = 0;  ///< of the block's own ρ; rounded, not proved, but in the block that leads
    double upper = 0;  ///< proved: of the block's ρ, or of that of all where this is smaller
    int vertices = 0;  ///< of the largest polytope made; 0 where size is 1
    bool irreducible = false;  ///< proved; else merely nothing was found to split
    /// Proved: products of n of the block's matrices are bounded by a constant times gⁿ, where g is
    /// the growth of `product`, exactly (exact_polytope.h).
    bool bounded = false;
    bool below = false;  ///< proved: the block's ρ is less than that growth
  };
  double lower = 0;  ///< proved: ρ ≥ lower
  double upper = 0;  ///< proved: ρ ≤ upper
  /// The matrices of the product with the greatest spectral radius found, first factor first;
  /// ρ ≥ |an eigenvalue of it|^(1/length). Empty where ρ = 0.
  std::vector<int> product;
  std::optional<Rational> eigenvalue;  ///< of the product, where it is rational
  /// Proved: ρ is |eigenvalue|^(1/length), or 0 where there is no product. Every block is bounded
  /// by it or below it.
  bool exact = false;
  std::vector<Block> blocks;  ///< along one chain; ρ is the greatest of theirs
  bool time_ended = false;    ///< `stop` asked for an end: more time would narrow the bracket
};

// Which polynomials a mask generates and reproduces: its sum rules, exactly, for any dilation.

/// Orders count: order k speaks of all polynomials of degree < k.
struct PolynomialOrders {
  /// The largest k for which the moments Σ_j p(j) a(j) over each coset of M Z² are equal for all
  /// p of degree < k. Then the scheme maps polynomials of degree < k to such, and where the shifts
  /// of φ are stable, k - 1 bounds the r of C^r [CDM §8; Jia1998].
  int sum_rules = 0;
  /// The largest d such that sampled polynomials of degree ≤ d have themselves as limits, sample
  /// points as in the mask's own parametrisation (its mean offset moved to 0): ≤ sum_rules - 1;
  /// -1 where not even constants are reproduced.
  int reproduction = -1;
};

/// Cost: small; orders above 40 are not looked for (box splines of 16 directions have fewer).
[[nodiscard]] PolynomialOrders polynomial_orders(const Mask& mask);

/// How long and how closely to look.
struct RegularityOptions {
  /// Work for each irreducible block: vertices of a polytope whose norm bounds it. Where it does
  /// not suffice for `tolerance` the bracket reached is given.
  int budget = 7000;
  double tolerance = 4e-3;  ///< width of the Hölder bracket below which little more is sought
  int most_steps = 4;       ///< of the difference schemes, tried for a norm below 1; 0: none
  /// Called with what is done next, if given.
  std::function<void(const std::string&)> progress;
  /// Infinite: without end. When the time ends what was reached is given, proved all the same.
  double seconds = std::numeric_limits<double>::infinity();
  TimeBudget::Clock clock = steady_seconds;  ///< what measures `seconds`
};

/// Whether the Hölder exponent α = r + s, 0 < s ≤ 1, is attained: see above.
struct Attainment {
  /// Whether differences of order r + 1 are O(|h|^α): yes and no are proved.
  Truth verdict = Truth::undecided;
  int order = 0;  ///< r + 1; 0 where the exponent is not known exactly
  /// The p for which they are not o(|h|^α log^p(1/|h|)), the greatest proved; > 0 where `verdict`
  /// is no.
  int logarithm = 0;
  bool sharp = false;  ///< proved: they are O(|h|^α log^p(1/|h|))
  std::string reason;  ///< what the verdict rests on, or what keeps it open
};

/// Ends of an interval that holds the Hölder exponent.
struct HolderBracket {
  double lower = 0;                   ///< proved for every limit function
  std::optional<double> upper;        ///< of φ; proved; nothing where stability is not
  JointSpectralRadius radius;         ///< of the transition operators, digit by digit
  std::vector<LatticeVector> digits;  ///< of radius.product
  /// The exponent of φ in closed form, proved: "2", "3/2", "log2(24/7)", "log2(5)/3" and the like;
  /// empty where there is none, or it is not proved. Then `lower` and `upper` are the doubles that
  /// enclose it.
  std::string exact;
  /// What `exact` rests on where differences prove less and φ is a box spline (box_spline.h); empty
  /// otherwise. `lower` is then the exponent, more than the radius tells, and `upper` nothing.
  std::string exact_reason;
  Attainment attained;  ///< whether that exponent is attained
};

/// Whether the scheme converges, uniformly, to limit functions that are r times continuously
/// differentiable.
struct Smoothness {
  Truth verdict = Truth::undecided;  ///< yes and no are proved
  /// The number of steps for which ‖(S_r)^power‖∞ ≤ norm < 1, rounded up, where S_r is the scheme
  /// of the differences of order r + 1, times |det M|^{r/2}; 0: none of the powers tried is below
  /// 1, and the proof, if there is one, is the bracket.
  int power = 0;
  double norm = 0;     ///< the bound of that norm; 0 where `power` is 0
  std::string reason;  ///< what the verdict rests on, or what keeps it open
};

/// What `enclose_regularity` finds.
struct Regularity {
  PolynomialOrders orders;  ///< sum rules and reproduction, exactly
  HolderBracket holder;     ///< the Hölder exponent
  /// C0, C1, C2, and as long as the one before is proved: C3, C4, ….
  std::vector<Smoothness> smoothness;
  /// Whether the shifts of φ are stable: yes where proved, else undecided.
  Truth stable = Truth::undecided;
  std::string stability_reason;  ///< what `stable` rests on
  bool time_ended = false;       ///< the time budget ended the search: more time might tell more
};

/// Brackets the regularity of a mask. Deterministic, whatever the number of threads, as long as the
/// time does not end. Cost: seconds at the default options for masks of radius 3 that have a
/// factor or two, minutes for wider ones: then bound the time. Fails where a coset of the mask does
/// not sum to 1, and where the mask is so wide that more than 400 control points would have to be
/// followed.
[[nodiscard]] Result<Regularity> enclose_regularity(const Mask& mask,
                                                    const RegularityOptions& options = {});

// Whether curvature is bounded on the regular lattice, that is, whether second differences over h²
// of the refined data stay bounded: what bounded curvature at an extraordinary vertex presupposes,
// since the surface round the vertex is regular.
//
// With ρ the joint spectral radius of the transition operators on differences that
// is so where ρ < 1/|det M|: the Hölder exponent is above 2. Where ρ is greater, and the shifts of
// φ are stable, it is not so: the exponent is below 2; nor where shifts are stable and the sum
// rules are of order 2 or less [Jia1998]. At the exponent 2 itself rounded brackets cannot tell.
// There an exact norm ≤ 1 of some steps of the normalised scheme of second differences proves
// boundedness (quadratic splines), and a Jordan block at the critical eigenvalue of a product of
// the operators proves, for stable shifts, that second differences grow like a power of the level
// (the butterfly, the four-point scheme). Where shifts are dependent, differences of the data may
// tell nothing; of a box spline (box_spline.h) it is known from its directions (midedge).

/// Of a mask: found once in a process and then remembered (a few hundred masks; from several
/// threads at once). The search stops as soon as it is decided, and gives up, undecided, where a
/// wide mask would take long. Whether shifts are stable is looked at in any case. Cost: at most a few
/// tenths of a second; the reason says what was proved.
[[nodiscard]] RegularPart find_regular_part(const Mask& mask);

/// Of a scheme at its present parameters; undecided, with the reason, where it has no regular mask.
/// Where meshes have both kinds of faces it is what holds on either lattice; of the seams between
/// them nothing is said.
[[nodiscard]] RegularPart find_regular_part(const Scheme& scheme);

}  // namespace limn
