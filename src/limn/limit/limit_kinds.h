#pragma once
/// From the vertices of a mesh to where their limit stencils apply: what limit points and limit
/// forms share. Private to them.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <unordered_map>
#include <vector>

#include <fmt/core.h>

#include "limn/base/parallel.h"
#include "limn/limit/limit_curvature.h"
#include "limn/limit/limit_sites.h"
#include "limn/limit/partial_rules.h"
#include "limn/mesh/lattice.h"
#include "limn/refine/add_scaled.h"
#include "limn/refine/linear_form.h"

namespace limn::limit {

/// What is measured at vertices of one kind: their stencils, and where these apply.
struct LimitKind {
  LimitStencil limit;
  int shape = 0;  ///< rings that must be regular but for the vertex
  mesh::Pattern pattern;
  /// Curvature looks farther, so that its neighbourhood may never become regular where the limit's
  /// does.
  struct Curved {
    CurvatureStencil stencil;
    mesh::Pattern pattern;
  };
  std::optional<Curved> curvature;
  NoCurvature no_curvature = NoCurvature::none;  ///< why there is none, where it was sought
};

/// Sites that are one face of a dual split's mesh, of which one stays, and whose vertices it is
/// besides: all n boundary vertices round a face of n corners may go to its centre.
class SharedSites {
 public:
  SharedSites() = default;
  /// Leaves one site a face in the list. Cost O(faces + sites).
  SharedSites(const Mesh& mesh, std::vector<LimitSite>& sites);
  /// The other vertices of a site's result.
  [[nodiscard]] std::span<const Index> others(Index result) const {
    const auto found = others_.find(result);
    return found == others_.end() ? std::span<const Index>() : found->second;
  }

 private:
  std::unordered_map<Index, std::vector<Index>> others_;
};

/// What kind a place is of: at the boundary or not, of so many faces (dual splits: a face of so
/// many corners), and where a scheme has both kinds of faces which ones, counterclockwise from the
/// place's start; one stands for all that are alike.
struct PlaceKind {
  bool boundary = false;
  int size = 0;
  std::vector<Lattice> faces = {};  ///< empty: all of the scheme's one lattice

  friend bool operator<(const PlaceKind& a, const PlaceKind& b) {
    return std::tie(a.boundary, a.size, a.faces) < std::tie(b.boundary, b.size, b.faces);
  }
};

/// The kinds of a scheme, found when they are met.
class LimitKinds {
 public:
  LimitKinds(const Scheme& scheme, bool curvatures);
  LimitKinds(const LimitKinds&) = delete;  // the lattices' analyses refer to schemes in it
  LimitKinds& operator=(const LimitKinds&) = delete;

  /// Finds those of the sites. Without `refused`, fails at the first vertex that has none; with it,
  /// such sites move there, each with its reason. Fails where a rule is missing.
  Status prepare(const Mesh& mesh, std::vector<LimitSite>& sites,
                 std::vector<LimitPoints::Refused>* refused, const SharedSites& shared);
  Result<const LimitKind*> find(const PlaceKind& place);
  /// The kind of a place, and the half-edge from which its surroundings are numbered: on the
  /// boundary the one that lies there; inside, where faces differ, that from which they are least.
  struct Located {
    PlaceKind place;
    Index start;
  };
  /// Of a vertex, or (dual splits) of a face, named by a half-edge.
  [[nodiscard]] Located locate(const Mesh& mesh, Index at) const;
  /// Of a place that is prepared for.
  [[nodiscard]] const LimitKind& at(const PlaceKind& place) const { return *kinds_.at(place); }
  [[nodiscard]] int rings() const { return rings_; }  ///< of the widest of them

 private:
  /// What a scheme is on one lattice.
  struct OneLattice {
    explicit OneLattice(Scheme own) : scheme(std::move(own)), analysis(scheme) {}
    Scheme scheme;
    FrequencyAnalysis analysis;
  };

  /// Where faces of both kinds meet; nothing elsewhere.
  [[nodiscard]] static std::optional<mesh::Sectors> seam_of(const PlaceKind& place);
  [[nodiscard]] OneLattice& lattice_of(const PlaceKind& place) const;
  /// That the scheme has the rules of a vertex (dual splits: a face) of this kind.
  [[nodiscard]] Status check_rules(const PlaceKind& place) const;
  [[nodiscard]] Result<LimitKind> make(const PlaceKind& place);
  void add_curvature(OneLattice& lattice, const PlaceKind& place, int more, LimitKind& kind);
  [[nodiscard]] mesh::Pattern pattern(const PlaceKind& place, int shape) const;

  const Scheme& scheme_;
  bool curvatures_;
  std::vector<std::unique_ptr<OneLattice>> lattices_;  // one, or triangles and quads
  std::map<PlaceKind, Result<LimitKind>> kinds_;
  int rings_ = 1;
};

[[nodiscard]] inline bool is_known(const Point3& value) { return !std::isnan(value.x); }
[[nodiscard]] inline bool is_known(const refine::LinearForm<double>& value) {
  return std::none_of(value.terms.begin(), value.terms.end(),
                      [](const auto& term) { return std::isnan(term.second); });
}

/// Whether all values that the stencil weighs are known.
template <class Value>
[[nodiscard]] bool are_known(const LimitStencil& stencil, const std::vector<Index>& vertices,
                             const std::vector<Value>& values) {
  for (const std::vector<double>* weights :
       {&stencil.position, &stencil.first_tangent, &stencil.second_tangent})
    for (std::size_t i = 0; i < weights->size(); ++i)
      if ((*weights)[i] != 0 && !is_known(values[static_cast<std::size_t>(vertices[i])]))
        return false;
  return true;
}

/// The place of a limit: a mesh after some steps, where the vertex's neighbourhood is of its kind.
template <class Value>
struct LimitPlace {
  const LimitKind& kind;
  const Mesh& mesh;
  const std::vector<Value>& values;
  Index start;                              ///< the half-edge from which is numbered:
  const std::vector<Index>& neighbourhood;  ///< the vertices that the stencils weigh
  Index vertex;                             ///< of the control mesh
  std::span<const Index> others;            ///< vertices that share it

  /// The sum of the neighbourhood's values with these weights, one for each of its vertices.
  [[nodiscard]] Value weighted(const std::vector<double>& weights) const {
    using refine::add_scaled;
    Value sum{};
    for (std::size_t i = 0; i < weights.size(); ++i)
      if (weights[i] != 0) add_scaled(sum, weights[i], values[neighbourhood[i]]);
    return sum;
  }
};

/// Puts one result where all vertices of a place have theirs.
template <class Value, class Result>
void put(const LimitPlace<Value>& place, const Result& result, std::vector<Result>& results) {
  results[static_cast<std::size_t>(place.vertex)] = result;
  for (const Index v : place.others) results[static_cast<std::size_t>(v)] = result;
}

/// Calls limit(LimitPlace) once for each place of vertices that are not isolated, on several
/// threads, and
/// curvature(LimitPlace) for those whose kind has one, and whose neighbourhood becomes regular, or
/// whose kind has none. Fails as LimitKinds::prepare
/// and `refine`, and where no few steps make a neighbourhood regular; with `refused`, this is told
/// there and the rest done.
template <class Value, class Limit, class Curvature>
class LimitSearch {
 public:
  LimitSearch(const Scheme& scheme, LimitKinds& kinds, const LimitOptions& options, Limit limit,
              Curvature curvature)
      : scheme_(scheme),
        dual_(scheme.split->is_dual()),
        kinds_(kinds),
        options_(options),
        limit_(limit),
        curvature_(curvature),
        rules_(scheme, options.boundary ? refine::Boundary::refined : refine::Boundary::left_out) {}

  [[nodiscard]] Status run(const Mesh& control, const std::vector<Value>& control_values,
                           const std::vector<Index>& vertices,
                           std::vector<LimitPoints::Refused>* refused) {
    constexpr int kMostSteps = 12;  // until a neighbourhood is regular; each halves its faces
    constexpr int kMargin = 3;      // rings round a neighbourhood, so that a cut does not reach it
    int step = options_.steps_made;
    LimitPatch<Value> patch;
    if (dual_) {
      Result<LimitPatch<Value>> first =
          dual_patch(scheme_, control, control_values, vertices, step++, rules_.tables());
      if (!first) return first.error();
      patch = std::move(*first);
      shared_ = SharedSites(patch.mesh, patch.sites);
    } else {
      patch.sites = limit_sites(control, vertices);
    }
    bool in_patch = dual_;
    for (int round = 0; round < kMostSteps; ++round) {
      const Mesh& mesh = in_patch ? patch.mesh : control;
      const std::vector<Value>& values = in_patch ? patch.values : control_values;
      if (Status status = kinds_.prepare(mesh, patch.sites, refused, shared_); !status)
        return status;
      const bool boundary_rests = scheme_.split->boundary_rests() && step % 2 != 0;
      if (Status status = visit(mesh, values, boundary_rests, patch.sites); !status) return status;
      if (patch.sites.empty()) return Done{};
      if (options_.progress) options_.progress(static_cast<int>(patch.sites.size()));
      Result<LimitPatch<Value>> next = refined_patch(
          scheme_, mesh, values, patch.sites, kinds_.rings() + kMargin, step++, rules_.tables());
      if (!next) return next.error();
      patch = std::move(*next);
      in_patch = true;
    }
    return refuse(patch.sites, kMostSteps, refused);
  }

 private:
  enum State : char { waiting, done, unknown };

  /// Takes the limits that can be taken on this mesh, and drops the sites that are done.
  Status visit(const Mesh& mesh, const std::vector<Value>& values, bool boundary_rests,
               std::vector<LimitSite>& sites) {
    std::vector<State> states(sites.size(), waiting);
    base::parallel_for(std::size_t{0}, sites.size(), [&](std::size_t first, std::size_t last) {
      std::vector<Index> neighbourhood;
      for (std::size_t i = first; i < last; ++i)
        if (!boundary_rests || !beside_boundary_edge(mesh, sites[i].at))
          states[i] = visit(mesh, values, sites[i], neighbourhood);
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < sites.size(); ++i) {
      if (states[i] == unknown) return rules_.error_at(sites[i].result);
      if (states[i] == waiting) sites[kept++] = sites[i];
    }
    sites.resize(kept);
    return Done{};
  }

  State visit(const Mesh& mesh, const std::vector<Value>& values, LimitSite& site,
              std::vector<Index>& neighbourhood) {
    const LimitKinds::Located located = kinds_.locate(mesh, site.at);
    const LimitKind& kind = kinds_.at(located.place);
    const Index start = located.start;
    const LimitPlace<Value> place{
        kind, mesh, values, start, neighbourhood, site.result, shared_.others(site.result)};
    if (!site.has_limit && kind.pattern.match(mesh, start, neighbourhood)) {
      if (!rules_.complete() && !are_known(kind.limit, neighbourhood, values)) return unknown;
      limit_(place);
      site.has_limit = true;
    }
    if (!kind.curvature) {
      if (!site.has_limit) return waiting;
      curvature_(place);
      return done;
    }
    if (!kind.curvature->pattern.match(mesh, start, neighbourhood)) return waiting;
    curvature_(place);
    return done;
  }

  /// What is left when no further steps are made.
  [[nodiscard]] Status refuse(const std::vector<LimitSite>& sites, int steps,
                              std::vector<LimitPoints::Refused>* refused) const {
    for (const LimitSite& site : sites) {
      if (site.has_limit) continue;  // its curvature alone is not found
      const std::string reason =
          fmt::format("after {} steps its surroundings are still not regular", steps);
      if (refused == nullptr)
        return Error{fmt::format("no limit point at vertex {}: {}", site.result, reason)};
      refused->push_back({site.result, reason});
      for (const Index v : shared_.others(site.result)) refused->push_back({v, reason});
    }
    return Done{};
  }

  const Scheme& scheme_;
  bool dual_;
  LimitKinds& kinds_;
  const LimitOptions& options_;
  Limit limit_;
  Curvature curvature_;
  PartialRules rules_;
  SharedSites shared_;
};

}  // namespace limn::limit
