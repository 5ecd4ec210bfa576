#include "support/scheme_oracle.h"

#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "limn/refine/refine_values.h"
#include "mesh/random_mesh.h"
#include "support/frequency.h"
#include "support/reference_step.h"
#include "support/torus_forms.h"

namespace limn::test {
namespace {

constexpr double kExact = 1e-12;     // of sums of a few dozen terms of size 1
constexpr double kDominance = 1e-4;  // eigenvalues in Jordan blocks are blurred
constexpr int kRandomMeshes = 10;

/// A refinement of random values, and what it must give.
struct Trial {
  std::string what;
  Mesh mesh;
  SplitResult refined;
  std::vector<double> values, expected;
};

bool is_mask_only(const std::string& scheme) { return scheme.starts_with("box-spline"); }

bool has_vertex_of_valence_two(const Mesh& mesh) {
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (!mesh.is_isolated(v) && !mesh.is_boundary_vertex(v) && mesh.valence(v) < 3) return true;
  return false;
}

Mesh octahedron() {
  return must_build(
      6, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}});
}

std::vector<std::pair<std::string, Mesh>> deck(const Split& split, bool tori_only) {
  const bool triangles = split.lattice == Lattice::triangle;
  std::vector<std::pair<std::string, Mesh>> meshes;
  meshes.emplace_back("a torus", torus(split.lattice, 5, 6));
  if (tori_only) return meshes;
  for (Index n = 3; n <= 12; ++n) {
    meshes.emplace_back("a star of valence " + std::to_string(n), star(split.lattice, n, 2));
    if (!triangles) meshes.emplace_back("a face of degree " + std::to_string(n), face_star(n, 2));
  }
  meshes.emplace_back("a large star", star(split.lattice, 5, 4));
  for (const Mesh& solid : {tetrahedron(), octahedron(), icosahedron()})
    meshes.emplace_back("a platonic solid", solid);
  for (unsigned seed = 0; static_cast<int>(meshes.size()) < 28 + kRandomMeshes; ++seed) {
    Mesh mesh = triangles ? RandomMesh(seed).triangles() : RandomMesh(seed).polygons();
    if (!has_vertex_of_valence_two(mesh))
      meshes.emplace_back("random mesh " + std::to_string(seed), std::move(mesh));
  }
  return meshes;
}

Trial make_trial(const Scheme& scheme, const std::string& what, const Mesh& mesh, int step) {
  Trial trial{
      what + ", step " + std::to_string(step), mesh, scheme.split->apply(mesh, step), {}, {}};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (Index v = 0; v < mesh.vertex_count(); ++v) trial.values.push_back(uniform(random));
  trial.expected = reference_step(scheme.name, mesh, trial.refined.births, trial.values);
  return trial;
}

std::vector<Trial> make_trials(const Scheme& scheme) {
  std::vector<Trial> trials;
  for (const auto& [what, mesh] : deck(*scheme.split, is_mask_only(scheme.name))) {
    trials.push_back(make_trial(scheme, what, mesh, 0));
    if (!scheme.split->trisects_boundary || !mesh.has_boundary()) continue;
    const Mesh finer = trials.back().refined.mesh;
    trials.push_back(make_trial(scheme, what, mesh, 1));
    trials.push_back(make_trial(scheme, what + " refined", finer, 1));
  }
  return trials;
}

/// Made once per scheme name: hundreds of mutants are held against each.
const std::vector<Trial>& trials_of(const Scheme& scheme) {
  static std::map<std::string, std::vector<Trial>> known;
  const auto found = known.find(scheme.name);
  return found != known.end() ? found->second
                              : known.emplace(scheme.name, make_trials(scheme)).first->second;
}

std::optional<std::string> failed_value(const Scheme& scheme, const Fact& fact, int n,
                                        const std::string& key, const Formula& formula) {
  const std::string what = key + " at valence " + std::to_string(n);
  if (key != "tangent" && key != "cup" && key != "saddle") return "an unknown fact: " + key;
  const Result<double> stated = Scope<double>(scheme, n, std::nullopt)(formula);
  if (!stated) return what + ": " + stated.error().text();
  const int omega = key == "tangent" ? 1 : key == "saddle" ? 2 : 0;
  if (omega == 2 && n < 5) return what + ": frequency 2 is no pair of its own";
  const Eigen::MatrixXcd block = frequency_block(scheme, n, analysis_rings(scheme, n), omega);
  if (!(eigenvalue_defect(block, *stated) < kExact))
    return what + " is no eigenvalue of frequency " + std::to_string(omega) + " [" + fact.source +
           "]";
  if (key == "tangent" && std::abs(eigenvalues(block).front()) > *stated + kDominance)
    return what + " is not the largest eigenvalue of frequency 1";
  return std::nullopt;
}

}  // namespace

std::optional<std::string> failed_reference(const Scheme& scheme) {
  if (!has_reference(scheme.name)) return "no reference for a scheme named " + scheme.name;
  RuleTables<double> tables(scheme);
  for (const Trial& trial : trials_of(scheme)) {
    const Births& births = trial.refined.births;
    if (const Status status = tables.prepare(trial.mesh, births); !status)
      return trial.what + ": " + status.error().text();
    const std::vector<double> values =
        refine_values(scheme, trial.mesh, births, tables, trial.values);
    if (values.size() != trial.expected.size()) return trial.what + ": another number of vertices";
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!(std::abs(values[i] - trial.expected[i]) < kExact))
        return trial.what + ": new vertex " + std::to_string(i) + " differs from the reference";
  }
  return std::nullopt;
}

std::optional<std::string> failed_mask(const Scheme& scheme) {
  if (!scheme.stated_mask) return std::nullopt;
  const Result<Mask> stated = mask_from_rows(scheme, *scheme.stated_mask);
  if (!stated) return "stated mask: " + stated.error().text();
  const Result<Mask> refined = refined_mask(scheme);
  if (!refined) return "refined mask: " + refined.error().text();
  if (stated->lattice != refined->lattice) return "the stated mask is of another lattice";
  if (stated->coefficients != refined->coefficients) return "the rules make another mask";
  return std::nullopt;
}

std::optional<std::string> failed_facts(const Scheme& scheme) {
  if (scheme.facts.empty() && !scheme.stated_mask) return "no facts at all";
  for (const Fact& fact : scheme.facts) {
    if (fact.values.empty() || fact.source.empty()) return "a fact without value or source";
    if (fact.first < 3 || fact.first > fact.last) return "a fact of no valence";
    for (int n = fact.first; n <= fact.last; ++n)
      for (const auto& [key, formula] : fact.values)
        if (auto failure = failed_value(scheme, fact, n, key, formula)) return failure;
  }
  return std::nullopt;
}

std::optional<std::string> first_failed_check(const Scheme& scheme) {
  if (auto failure = failed_reference(scheme)) return failure;
  if (auto failure = failed_mask(scheme)) return failure;
  return failed_facts(scheme);
}

}  // namespace limn::test
