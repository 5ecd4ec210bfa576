#include "support/scheme_oracle.h"

#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "limn/refine/refine_values.h"
#include "limn/scheme/lattice_schemes.h"
#include "limn/scheme/mask_rules.h"
#include "limn/scheme/scope.h"
#include "mesh/random_mesh.h"
#include "support/frequency.h"
#include "support/reference_step.h"
#include "support/torus_forms.h"
#include "support/valences.h"

namespace limn::test {
namespace {

constexpr double kExact = 1e-12;     // of sums of a few dozen terms of size 1
constexpr double kDominance = 1e-4;  // eigenvalues in Jordan blocks are blurred
constexpr int kRandomMeshes = 20;

/// A refinement of random values, and what it must give at that value of the parameter.
struct Trial {
  std::string what;
  std::optional<double> parameter;
  Mesh mesh;
  SplitResult refined;
  std::vector<double> values, expected;
};

/// "w=1/10": another value of the scheme's own parameter than the file's.
struct Setting {
  std::string name;
  int numerator, denominator;

  [[nodiscard]] double value() const { return static_cast<double>(numerator) / denominator; }
  [[nodiscard]] std::string text() const {
    return name + "=" + std::to_string(numerator) + "/" + std::to_string(denominator);
  }
};

std::optional<Setting> other_setting(const std::string& scheme) {
  if (scheme == "butterfly" || scheme == "butterfly-modified" || scheme == "kobbelt-quad")
    return Setting{"w", 1, 10};
  if (scheme == "laplacian-butterfly") return Setting{"b", 3, 16};
  if (scheme == "laplacian-loop") return Setting{"a", -1, 10};
  if (scheme == "laplacian-loop-low") return Setting{"a", 1, 3};
  if (scheme == "butterfly-ternary") return Setting{"mu", 1, 9};
  if (scheme == "loop-type") return Setting{"b", 2, 5};
  if (scheme == "b-spline-quad") return Setting{"stam", 1, 2};
  if (scheme == "quad-triangle") return Setting{"own", 1, 2};
  return std::nullopt;
}

bool is_mask_only(const std::string& scheme) { return scheme.starts_with("box-spline"); }

Mesh octahedron() {
  return must_build(
      6, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}});
}

using Deck = std::vector<std::pair<std::string, Mesh>>;

/// Where triangles meet quads, and triangles alone.
void add_mixed(Deck& meshes) {
  meshes.emplace_back("a torus of triangles", mesh::torus(Lattice::triangle, 5, 6));
  for (Index n = 3; n <= 12; ++n)
    meshes.emplace_back("a star of triangles of valence " + std::to_string(n),
                        mesh::star(Lattice::triangle, n, 2));
  for (unsigned seed = 0; seed < kRandomMeshes; ++seed)
    meshes.emplace_back("mixed random mesh " + std::to_string(seed), RandomMesh(seed).mixed());
}

Deck deck(const Scheme& scheme) {
  const Split& split = *scheme.split;
  const bool triangles = split.lattice == Lattice::triangle;
  Deck meshes;
  meshes.emplace_back("a torus", mesh::torus(split.lattice, 5, 6));
  if (is_mask_only(scheme.name)) return meshes;
  for (Index n = 3; n <= 12; ++n) {
    meshes.emplace_back("a star of valence " + std::to_string(n), mesh::star(split.lattice, n, 2));
    if (!triangles)
      meshes.emplace_back("a face of degree " + std::to_string(n), mesh::face_star(n, 2));
  }
  if (scheme.rule(RuleKind::boundary_spoke))  // others look at a boundary vertex's curve alone
    for (Index faces = 1; faces <= 8; ++faces)
      meshes.emplace_back("a fan of " + std::to_string(faces) + " faces",
                          mesh::fan(split.lattice, faces, 2));
  meshes.emplace_back("a large star", mesh::star(split.lattice, 5, 4));
  if (split.mixed) add_mixed(meshes);
  for (const Mesh& solid : {tetrahedron(), octahedron(), icosahedron()})
    meshes.emplace_back("a platonic solid", solid);
  int wanted = kRandomMeshes;
  for (unsigned seed = 0; wanted > 0; ++seed) {
    Mesh mesh = triangles ? RandomMesh(seed).triangles() : RandomMesh(seed).polygons();
    if (has_inner_vertex_of_valence_two(mesh)) continue;
    meshes.emplace_back("random mesh " + std::to_string(seed), std::move(mesh));
    --wanted;
  }
  return meshes;
}

Trial make_trial(const Scheme& scheme, std::optional<double> parameter, const std::string& what,
                 const Mesh& mesh, int step) {
  Trial trial{what + ", step " + std::to_string(step), parameter, mesh,
              scheme.split->apply(mesh, step),         {},        {}};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (Index v = 0; v < mesh.vertex_count(); ++v) trial.values.push_back(uniform(random));
  trial.expected = reference_step(scheme.name, parameter, mesh, trial.refined.births, trial.values);
  return trial;
}

std::vector<Trial> make_trials(const Scheme& scheme, std::optional<double> parameter) {
  std::vector<Trial> trials;
  for (const auto& [what, mesh] : deck(scheme)) {
    trials.push_back(make_trial(scheme, parameter, what, mesh, 0));
    if (!scheme.split->boundary_rests() || !mesh.has_boundary()) continue;
    const Mesh finer = trials.back().refined.mesh;
    trials.push_back(make_trial(scheme, parameter, what, mesh, 1));
    trials.push_back(make_trial(scheme, parameter, what + " refined", finer, 1));
  }
  return trials;
}

/// Made once: hundreds of mutants are held against each. A mutant of stages may have another split.
const std::vector<Trial>& trials_of(const Scheme& scheme, std::optional<double> parameter) {
  static std::map<std::pair<std::string, std::optional<double>>, std::vector<Trial>> known;
  const std::pair<std::string, std::optional<double>> key{
      scheme.name + " on " + std::string(scheme.split->name), parameter};
  const auto found = known.find(key);
  return found != known.end() ? found->second
                              : known.emplace(key, make_trials(scheme, parameter)).first->second;
}

std::optional<std::string> failed_trial(const Scheme& scheme, std::optional<double> parameter) {
  refine::RuleTables<double> tables(scheme);
  for (const Trial& trial : trials_of(scheme, parameter)) {
    const Births& births = trial.refined.births;
    if (const Status status = tables.prepare(trial.mesh, births); !status)
      return trial.what + ": " + status.error().text();
    const std::vector<double> values =
        refine::refine_values(scheme, trial.mesh, births, tables, trial.values);
    if (values.size() != trial.expected.size()) return trial.what + ": another number of vertices";
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!(std::abs(values[i] - trial.expected[i]) < kExact))
        return trial.what + ": new vertex " + std::to_string(i) + " differs from the reference";
  }
  return std::nullopt;
}

/// Masks of box splines, by twice the offset: 4·∏ (1 + z^d)/2 over the directions, centred.
std::map<std::array<int, 2>, Rational> box_spline(
    const std::vector<std::pair<std::array<int, 2>, int>>& directions) {
  std::map<std::array<int, 2>, Rational> mask{{{0, 0}, 4}};
  for (const auto& [step, count] : directions) {
    for (int i = 0; i < count; ++i) {
      std::map<std::array<int, 2>, Rational> product;
      for (const auto& [at, value] : mask) {
        product[{at[0] + step[0], at[1] + step[1]}] += value / 2;
        product[{at[0] - step[0], at[1] - step[1]}] += value / 2;
      }
      mask = std::move(product);
    }
  }
  return mask;
}

/// The counts of each direction, set one by one, against the convolution.
std::optional<std::string> failed_box_splines(const Scheme& scheme) {
  const bool quad = scheme.name == "box-spline-quad";
  const std::vector<std::string> names = quad ? std::vector<std::string>{"i", "j", "p", "q"}
                                              : std::vector<std::string>{"i", "j", "k3"};
  const std::vector<std::array<int, 2>> steps{{1, 0}, {0, 1}, {1, 1}, {1, -1}};
  const std::vector<std::vector<int>> cases =
      quad ? std::vector<std::vector<int>>{{4, 4, 0, 0}, {2, 4, 2, 0}, {2, 2, 1, 3}, {3, 1, 2, 1}}
           : std::vector<std::vector<int>>{{2, 2, 2}, {1, 1, 1}, {2, 4, 6}, {3, 1, 5}};
  for (const std::vector<int>& counts : cases) {
    Scheme other = scheme;
    std::vector<std::pair<std::array<int, 2>, int>> directions;
    std::string what;
    for (std::size_t d = 0; d < names.size(); ++d) {
      // in this order, and checked at the end: the counts' parities depend on one another
      for (Parameter& parameter : other.parameters)
        if (parameter.name == names[d])
          parameter.value.expression = Expression::constant(counts[d]);
      directions.emplace_back(steps[d], counts[d]);
      what += names[d] + "=" + std::to_string(counts[d]) + " ";
    }
    if (!other.factors) return "no factors";
    const Result<Mask> mask = scheme::mask_from_factors(other, *other.factors);
    if (!mask) return what + mask.error().text();
    if (mask->coefficients != box_spline(directions)) return what + "make another mask";
  }
  return std::nullopt;
}

/// The largest eigenvalue of a frequency, beside 1, on the smallest neighbourhood that has one: the
/// papers' own. Outer rings, where eigenvalues do not depend on the rule at the centre, can
/// bring larger ones.
std::complex<double> leading_eigenvalue(const Scheme& scheme, int n, int omega) {
  const std::size_t skip = omega == 0 ? 1 : 0;
  for (int rings = refine::invariant_rings(scheme, n).value();; ++rings) {
    const auto all = eigenvalues(frequency_block(scheme, n, rings, omega));
    if (all.size() > skip) return all[skip];
  }
}

std::optional<std::string> failed_value(const Scheme& scheme, const Fact& fact, int n,
                                        const std::string& key, const Formula& formula) {
  const std::string what = key + " at valence " + std::to_string(n);
  if (key != "tangent" && key != "cup" && key != "saddle") return "an unknown fact: " + key;
  const Result<double> stated = scheme::Scope<double>(scheme, n, std::nullopt)(formula);
  if (!stated) return what + ": " + stated.error().text();
  const int omega = key == "tangent" ? 1 : key == "saddle" ? 2 : 0;
  if (omega == 2 && n < 5) return what + ": frequency 2 is no pair of its own";
  const Eigen::MatrixXcd block = frequency_block(scheme, n, analysis_rings(scheme, n), omega);
  if (!(eigenvalue_defect(block, *stated) < kExact))
    return what + " is no eigenvalue of frequency " + std::to_string(omega) + " [" + fact.source +
           "]";
  if (key == "tangent" && std::abs(eigenvalues(block).front()) > *stated + kDominance)
    return what + " is not the largest eigenvalue of frequency 1";
  if (!(std::abs(leading_eigenvalue(scheme, n, omega) - *stated) < kDominance))
    return what + " does not lead frequency " + std::to_string(omega) + " near the centre";
  return std::nullopt;
}

/// The other scheme at valence n, its parameters as `same` sets them; nothing where it refuses.
std::optional<Scheme> set_as_stated(const Scheme& scheme, const Equivalence& same, int n) {
  Result<Scheme> other = find_scheme(same.scheme);
  if (!other) return std::nullopt;
  std::vector<std::string> assignments;
  for (const auto& [name, formula] : same.with) {
    const Result<double> value = scheme::Scope<double>(scheme, n, std::nullopt)(formula);
    if (!value) return std::nullopt;
    assignments.push_back(name + "=" + to_string(Rational(*value)));  // a double is a fraction
  }
  if (!set_parameters(*other, assignments)) return std::nullopt;
  return std::move(*other);
}

std::optional<std::string> failed_equivalence(const Scheme& scheme, const Equivalence& same) {
  for (int n = 3; n <= 12; ++n) {
    const std::string what = "same as " + same.scheme + " at valence " + std::to_string(n) + ": ";
    const std::optional<Scheme> other = set_as_stated(scheme, same, n);
    if (!other) return what + "that scheme or its parameter is refused";
    // no more, so that no row belongs to a vertex of another valence: the numbers set are those at
    // n
    const int rings = refine::invariant_rings(scheme, n).value();
    const auto one = refine::subdivision_matrix<double>(scheme, n, rings);
    const auto two = refine::subdivision_matrix<double>(*other, n, rings);
    if (!one || !two) return what + "no matrix";
    if (!((dense(*one) - dense(*two)).norm() < kExact)) return what + "they differ";
  }
  return std::nullopt;
}

/// At the file's parameters and at others.
std::optional<std::string> failed_equivalences(const Scheme& scheme) {
  Scheme other = scheme;
  const std::optional<Setting> setting = other_setting(scheme.name);
  if (setting && !set_parameter(other, setting->text())) return setting->text() + " is refused";
  for (const Scheme* at : {&scheme, static_cast<const Scheme*>(&other)})
    for (const Equivalence& same : at->equivalences)
      if (auto failure = failed_equivalence(*at, same)) return failure;
  return std::nullopt;
}

}  // namespace

std::optional<std::string> failed_reference(const Scheme& scheme) {
  if (!has_reference(scheme.name)) return "no reference for a scheme named " + scheme.name;
  if (auto failure = failed_trial(scheme, std::nullopt)) return failure;
  if (scheme.name.starts_with("box-spline")) return failed_box_splines(scheme);
  if (Scheme smooth = scheme; use_smooth_triangles(smooth)) {
    smooth.name += ", smooth triangles";
    if (has_reference(smooth.name))  // else its rule is that of the scheme it extends
      if (auto failure = failed_trial(smooth, std::nullopt)) return smooth.name + ": " + *failure;
  }
  const std::optional<Setting> setting = other_setting(scheme.name);
  if (!setting) return std::nullopt;
  Scheme other = scheme;
  if (const Status status = set_parameter(other, setting->text()); !status)
    return setting->text() + ": " + status.error().text();
  if (auto failure = failed_trial(other, setting->value()))
    return setting->text() + ": " + *failure;
  return std::nullopt;
}

std::optional<std::string> failed_mask(const Scheme& scheme) {
  if (!scheme.stated_mask) return std::nullopt;
  const Result<Mask> stated = scheme::mask_from_rows(scheme, *scheme.stated_mask);
  if (!stated) return "stated mask: " + stated.error().text();
  const Result<Mask> refined = refined_mask(scheme);
  if (!refined) return "refined mask: " + refined.error().text();
  if (stated->lattice != refined->lattice) return "the stated mask is of another lattice";
  if (stated->coefficients != refined->coefficients) return "the rules make another mask";
  return std::nullopt;
}

std::optional<std::string> failed_facts(const Scheme& scheme) {
  if (scheme.split->mixed) {
    for (const Scheme& half : scheme::lattice_schemes(scheme))
      if (auto failure = failed_facts(half))
        return std::string(scheme::lattice_name(half.split->lattice)) + "s: " + *failure;
    return std::nullopt;
  }
  if (scheme.facts.empty() && !scheme.stated_mask) return "no facts at all";
  for (const Fact& fact : scheme.facts) {
    if (fact.values.empty() || fact.source.empty()) return "a fact without value or source";
    if (fact.first < 3 || fact.first > fact.last) return "a fact of no valence";
    for (int n = fact.first; n <= fact.last; ++n)
      for (const auto& [key, formula] : fact.values)
        if (auto failure = failed_value(scheme, fact, n, key, formula)) return failure;
  }
  return failed_equivalences(scheme);
}

std::optional<std::string> first_failed_check(const Scheme& scheme) {
  if (auto failure = failed_reference(scheme)) return failure;
  if (auto failure = failed_mask(scheme)) return failure;
  return failed_facts(scheme);
}

}  // namespace limn::test
