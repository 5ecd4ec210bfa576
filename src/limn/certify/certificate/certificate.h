#pragma once
/// A certificate: what is claimed of a scheme's surfaces, and what a check needs to see that it is
/// so without searching. Theorems, hypotheses and an example by hand: docs/certificates.md.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limn/certify/all/all_valences.h"
#include "limn/mesh/split/split.h"
#include "limn/scheme/scheme.h"

namespace limn::certify {

enum class Answer { proved, refuted, undecided };
/// "proved", "refuted" or "undecided".
[[nodiscard]] std::string_view to_string(Answer answer);

/// bounded: second derivatives stay bounded at the vertex and not all of them vanish for all nets;
/// flat: they tend to 0; unbounded: for almost all nets they do not stay bounded.
enum class CurvatureAnswer { bounded, unbounded, flat, undecided };
/// "bounded", "unbounded", "flat" or "undecided".
[[nodiscard]] std::string_view to_string(CurvatureAnswer answer);

/// A tree of products of cell matrices (contraction.h).
struct TreeClaim {
  double leaf_norm = 0;
  int products = 0;
  int longest = 0;
};

/// The regular lattice: that products of cell matrices contract.
struct RegularClaim {
  Answer c1 = Answer::undecided;  ///< never refuted here
  std::string reason;
  TreeClaim neighbours;  ///< of cells with their neighbours: the surface is C1
  TreeClaim cells;       ///< of cells alone: bounds of gradients
};

/// A cell of the characteristic ring (ring_cells.h) and the parts it was cut into: words of digits,
/// "" the whole cell, "02" part 2 of part 0; they fill it.
struct CellClaim {
  LatticeVector cell{};
  std::vector<std::string> parts;
};

/// A part of a cell.
struct PartPlace {
  LatticeVector cell{};
  std::string part;
};

/// That an eigenvalue of a block is larger than tangent².
struct LargeEigenvalue {
  int frequency = 0;
  std::vector<int> rows;  ///< of the block, that depend on one another; its matrix has it
  double value = 0;
};

/// How often λ² is an eigenvalue of a block, exactly and without Jordan blocks.
struct SquareEigenvalue {
  int frequency = 0;
  int multiplicity = 0;
};

struct CurvatureClaim {
  CurvatureAnswer answer = CurvatureAnswer::undecided;
  std::string reason;
  std::optional<LargeEigenvalue> large;  ///< unbounded: an eigenvalue > λ²
  /// unbounded: λ² has a Jordan block there; its multiplicity in the square of block - λ².
  std::optional<SquareEigenvalue> jordan;
  std::vector<SquareEigenvalue> equal;  ///< bounded, flat
  std::vector<int> squarings;           ///< by frequency, of what is less than λ²
};

/// What is claimed of one valence. Numbers are rounded to doubles: the check encloses what is near
/// them, and compares.
struct ValenceClaim {
  int valence = 0;
  Answer c1 = Answer::undecided;
  std::string reason;
  int bits = 0;       ///< of the ball arithmetic
  int frequency = 1;  ///< of the eigenvalue that leads all others but 1
  double eigenvalue = 0;
  std::vector<double> eigenvector;  ///< in the real basis (real_blocks.h); empty: nothing is shown
  std::vector<int> squarings;       ///< by frequency, of all other eigenvalues
  int inner = 0;                    ///< edge lengths from the centre to the ring's inner boundary
  std::vector<CellClaim> ring;
  std::optional<std::array<PartPlace, 2>> fold;  ///< the Jacobian is positive, and negative
  CurvatureClaim curvature;
};

/// C1 at every valence from `from` on.
struct AllClaim {
  struct Exception {
    int valence = 0;
    Answer c1 = Answer::undecided;
  };
  int from = 3;
  Answer c1 = Answer::undecided;  ///< proved: at all but the exceptions; never refuted
  std::string reason;
  std::vector<Exception> exceptions;  ///< of Certificate::valences, ascending
  AllValences proof;                  ///< of those from proof.from on; the others one by one
};

struct Certificate {
  std::vector<SourceText> texts;        ///< the scheme's files, as in Scheme
  std::vector<std::string> parameters;  ///< "name=expression", set after reading
  std::string scheme;                   ///< its name
  RegularClaim regular;
  std::vector<ValenceClaim> valences;
  std::optional<AllClaim> all;
};

}  // namespace limn::certify
