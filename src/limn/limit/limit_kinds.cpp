#include "limn/limit/limit_kinds.h"

#include <algorithm>
#include <functional>

#include "limn/mesh/lattice.h"
#include "limn/refine/star_step.h"
#include "limn/scheme/lattice_schemes.h"
#include "limn/scheme/seen_from.h"

namespace limn::limit {

SharedSites::SharedSites(const Mesh& mesh, std::vector<LimitSite>& sites) {
  std::vector<Index> result_at(static_cast<std::size_t>(mesh.face_count()), kNone);
  std::size_t kept = 0;
  for (const LimitSite& site : sites) {
    Index& result = result_at[static_cast<std::size_t>(mesh.face(site.at))];
    if (result != kNone) {
      others_[result].push_back(site.result);
      continue;
    }
    result = site.result;
    sites[kept++] = site;
  }
  sites.resize(kept);
}

LimitKinds::LimitKinds(const Scheme& scheme, bool curvatures)
    : scheme_(scheme), curvatures_(curvatures) {
  for (Scheme& one : scheme::lattice_schemes(scheme))
    lattices_.push_back(std::make_unique<OneLattice>(std::move(one)));
}

LimitKinds::Located LimitKinds::locate(const Mesh& mesh, Index at) const {
  if (scheme_.split->is_dual()) return {{false, mesh.degree(mesh.face(at)), {}}, at};
  const bool boundary = mesh.is_boundary_vertex(at);
  Index start = mesh.halfedge_of_vertex(at), h = start;
  PlaceKind place{boundary, mesh.valence(at) - (boundary ? 1 : 0), {}};
  if (!scheme_.split->mixed) return {std::move(place), start};
  std::vector<Lattice>& faces = place.faces;
  for (int i = 0; i < place.size; ++i, h = mesh.rotate(h))  // other faces are quads a step later
    faces.push_back(mesh.degree(mesh.face(h)) == 3 ? Lattice::triangle : Lattice::quad);
  if (std::adjacent_find(faces.begin(), faces.end(), std::not_equal_to<>()) == faces.end()) {
    faces.resize(1);
    return {std::move(place), start};
  }
  std::vector<Lattice> turned = faces;
  h = start;
  for (int i = 1; i < place.size && !boundary; ++i) {
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    h = mesh.rotate(h);
    if (turned >= faces) continue;
    faces = turned;
    start = h;
  }
  return {std::move(place), start};
}

std::optional<mesh::Sectors> LimitKinds::seam_of(const PlaceKind& place) {
  if (place.faces.size() < 2) return std::nullopt;
  return mesh::Sectors{place.faces, place.boundary};
}

LimitKinds::OneLattice& LimitKinds::lattice_of(const PlaceKind& place) const {
  const bool second = !place.faces.empty() && place.faces.front() == Lattice::quad;
  return *lattices_[second ? 1 : 0];
}

Status LimitKinds::prepare(const Mesh& mesh, std::vector<LimitSite>& sites,
                           std::vector<LimitPoints::Refused>* refused, const SharedSites& shared) {
  std::size_t kept = 0;
  for (const LimitSite& site : sites) {
    const PlaceKind place = locate(mesh, site.at).place;
    const Result<const LimitKind*> kind = find(place);
    if (kind) {
      sites[kept++] = site;
      continue;
    }
    Error error = kind.error();
    if (refused != nullptr && check_rules(place)) {
      refused->push_back({site.result, error.message});
      for (const Index v : shared.others(site.result)) refused->push_back({v, error.message});
      continue;
    }
    error.message = fmt::format("vertex {}: {}", site.result, error.message);
    return error;
  }
  sites.resize(kept);
  return Done{};
}

Result<const LimitKind*> LimitKinds::find(const PlaceKind& place) {
  auto found = kinds_.find(place);
  if (found == kinds_.end()) found = kinds_.emplace(place, make(place)).first;
  if (!found->second) return found->second.error();
  return &*found->second;
}

Status LimitKinds::check_rules(const PlaceKind& place) const {
  if (const std::optional<mesh::Sectors> seam = seam_of(place)) {
    if (seam->open) return Done{};  // stages need no rules there
    const auto quads =
        static_cast<int>(std::count(seam->lattices.begin(), seam->lattices.end(), Lattice::quad));
    const Result<refine::Row<double>> row =
        refine::tabulate_row<double>(scheme_, RuleKind::vertex, place.size, quads);
    return row ? Status(Done{}) : row.error();
  }
  const Scheme& scheme = lattice_of(place).scheme;
  const auto check = [&](RuleKind kind, int n) -> Status {
    const Result<refine::Row<double>> row = refine::tabulate_row<double>(scheme, kind, n);
    if (!row) return row.error();
    return Done{};
  };
  const Split& split = *scheme.split;
  if (split.is_dual())
    return split.births.corners ? check(RuleKind::corner, place.size) : check(RuleKind::edge, 0);
  if (!place.boundary) return check(RuleKind::vertex, place.size);
  if (Status status = check(RuleKind::boundary_vertex, place.size + 1); !status) return status;
  const bool thirds = split.births.thirds || split.odd_step_cut == 3;
  return thirds ? check(RuleKind::boundary_edge_end, place.size + 1)
                : check(RuleKind::boundary_edge, 0);
}

mesh::Pattern LimitKinds::pattern(const PlaceKind& place, int shape) const {
  if (const std::optional<mesh::Sectors> seam = seam_of(place))
    return {mesh::sector_star(*seam, shape), mesh::sector_star_size(*seam, shape - 1)};
  const Split& split = *lattice_of(place).scheme.split;
  const int size = place.size;
  if (place.boundary)
    return {mesh::fan(split.lattice, size, shape), mesh::fan_size(split.lattice, size, shape - 1)};
  return {refine::split_star(split, size, shape), refine::split_star_size(split, size, shape - 1)};
}

Result<LimitKind> LimitKinds::make(const PlaceKind& place) {
  if (Status status = check_rules(place); !status) return status.error();
  OneLattice& lattice = lattice_of(place);
  const std::optional<mesh::Sectors> seam = seam_of(place);
  Result<LimitStencil> limit = seam ? approx_sector_limit_stencil(scheme_, *seam)
                               : place.boundary
                                   ? approx_boundary_limit_stencil(lattice.scheme, place.size)
                                   : approx_limit_stencil(lattice.analysis, place.size);
  if (!limit) return limit.error();
  // What is inside must be regular: rules that are seen from an end or a corner see one ring
  // farther; and of a cropped star the corners, which have rules, count to the ring beyond.
  const int corners = place.boundary ? 0 : refine::least_star_rings(*lattice.scheme.split) - 1;
  const int more = (scheme::has_rules_seen_from(lattice.scheme) ? 1 : 0) + corners;
  const int shape = limit->rings + more;
  rings_ = std::max(rings_, limit->rings);
  LimitKind kind{std::move(*limit), shape, pattern(place, shape), {}, {}};
  if (!curvatures_) return kind;
  kind.no_curvature = place.boundary ? NoCurvature::boundary : NoCurvature::unknown;
  if (!place.boundary && !seam) add_curvature(lattice, place, more, kind);
  return kind;
}

/// What is not known of the curvature takes nothing from the limit.
void LimitKinds::add_curvature(OneLattice& lattice, const PlaceKind& place, int more,
                               LimitKind& kind) {
  Result<VertexCurvature> curvature =
      approx_curvature_stencil(lattice.scheme, lattice.analysis, place.size);
  if (!curvature) return;
  kind.no_curvature = curvature->missing;
  if (!curvature->stencil) return;
  const int rings = std::max(kind.limit.rings, curvature->stencil->rings);
  rings_ = std::max(rings_, rings);
  kind.curvature = LimitKind::Curved{*std::move(curvature->stencil), pattern(place, rings + more)};
}

}  // namespace limn::limit
