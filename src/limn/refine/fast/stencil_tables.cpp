#include "limn/refine/fast/stencil_tables.h"

#include <algorithm>
#include <numeric>
#include <set>

#include <fmt/core.h>

#include "limn/mesh/lattice.h"
#include "limn/refine/linear_form.h"
#include "limn/refine/refine_values.h"
#include "limn/refine/star_step.h"

namespace limn::fast {
namespace {

constexpr Index kRegular = 6;     // faces at a regular interior vertex
constexpr Index kHalfPlane = 3;   // and at a regular boundary vertex
constexpr Index kClassRings = 2;  // of a star that holds a point of each class

using Form = LinearForm<double>;

/// Forms of fine points (numbered as on the coarse star) over the coarse vertices.
class Reader {
 public:
  explicit Reader(const Scheme& scheme)
      : scheme_(scheme), closed_(scheme, Boundary::left_out), open_(scheme, Boundary::refined) {}

  Result<std::vector<Form>> star(Index n, Index rings, const std::vector<Index>& wanted) {
    const StarStep step = star_step(*scheme_.split, n, static_cast<int>(rings));
    return read(closed_, step.coarse, step.fine.births, step.images, wanted);
  }

  Result<std::vector<Form>> fan(Index faces, Index rings, const std::vector<Index>& wanted) {
    const FanStep step = fan_step(*scheme_.split, faces, static_cast<int>(rings));
    return read(open_, step.coarse, step.fine.front().births, step.images, wanted);
  }

 private:
  Result<std::vector<Form>> read(RuleTables<double>& tables, const Mesh& coarse,
                                 const Births& births, const std::vector<Index>& images,
                                 const std::vector<Index>& wanted) {
    if (Status status = tables.prepare(coarse, births); !status) return status.error();
    std::vector<Index> vertices;
    vertices.reserve(wanted.size());
    for (const Index i : wanted) vertices.push_back(images[i]);
    return refine_values_at(scheme_, coarse, births, tables,
                            unit_forms<double>(coarse.vertex_count()), vertices);
  }

  const Scheme& scheme_;
  RuleTables<double> closed_, open_;
};

/// The form of fine point (x, y) of sector 0 as a stencil. `open`: on the fan of half the plane.
Stencil to_stencil(const Form& form, bool open, Index fine_x, Index fine_y) {
  const Index sectors = open ? kHalfPlane : kRegular;
  Stencil stencil;
  for (const auto& [vertex, weight] : form.terms) {
    if (weight == 0) continue;
    const Offset place = on_plane(sector_point(sectors, open, vertex));
    stencil.push_back({{place.a - fine_x / 2, place.b - fine_y / 2}, weight});
  }
  std::sort(stencil.begin(), stencil.end(),
            [](const Tap& p, const Tap& q) { return p.place < q.place; });
  return stencil;
}

ZoneTable to_table(const std::vector<Form>& forms, Index sectors, bool open) {
  std::set<Index> used;
  for (const Form& form : forms)
    for (const auto& [vertex, weight] : form.terms)
      if (weight != 0) used.insert(vertex);
  std::map<Index, int> slot;
  ZoneTable table;
  table.sectors = sectors;
  for (const Index v : used) {
    slot[v] = static_cast<int>(table.sources.size());
    table.sources.push_back(sector_point(sectors, open, v));
  }
  table.rows.sources = static_cast<int>(table.sources.size());
  for (std::size_t i = 0; i < forms.size(); ++i) {
    table.targets.push_back(sector_point(sectors, open, static_cast<Index>(i)));
    for (const auto& [vertex, weight] : forms[i].terms)
      if (weight != 0) table.rows.terms.push_back({slot[vertex], weight});
    table.rows.row_begin.push_back(static_cast<int>(table.rows.terms.size()));
  }
  return table;
}

class TableMaker {
 public:
  TableMaker(const Scheme& scheme, const std::vector<VertexKind>& kinds)
      : scheme_(scheme), kinds_(kinds), reader_(scheme) {}

  Result<StencilTables> make() {
    const bool boundary =
        std::any_of(kinds_.begin(), kinds_.end(), [](const VertexKind& kind) { return kind.open; });
    const std::optional<Reach> reach = find_reach(scheme_, boundary);
    if (!reach)
      return Error{
          fmt::format("the rules of scheme '{}' look too far", scheme_.name), {}, {}, 0, 0};
    tables_.reach = *reach;
    if (Status status = read_interior(); !status) return status.error();
    if (boundary)
      if (Status status = read_strips(); !status) return status.error();
    for (const VertexKind& kind : kinds_)
      if (Status status = read_zone(kind); !status) return status.error();
    return std::move(tables_);
  }

 private:
  Status read_interior() {
    std::vector<Index> wanted;
    for (const Index y : {0, 1})
      for (const Index x : {0, 1}) wanted.push_back(vertex_at(kRegular, false, {0, x, y}));
    const Result<std::vector<Form>> forms = reader_.star(kRegular, kClassRings, wanted);
    if (!forms) return forms.error();
    for (const Index y : {0, 1})
      for (const Index x : {0, 1}) {
        const std::size_t c = class_of(x, y);
        tables_.interior[c] = to_stencil((*forms)[c], false, x, y);
        for (const auto& [place, weight] : tables_.interior[c])
          tables_.halo =
              std::max({tables_.halo, -place.a, -place.b, place.a + place.b - (x + y + 1) / 2});
      }
    return Done{};
  }

  Status read_strips() {
    const Index depth = tables_.reach.strip_depth;
    std::vector<Index> wanted;
    for (Index y = 0; y <= depth; ++y)
      for (const Index x : {0, 1}) wanted.push_back(vertex_at(kHalfPlane, true, {0, x, y}));
    const Index rings = std::max(depth, kClassRings) + 1;
    const Result<std::vector<Form>> forms = reader_.fan(kHalfPlane, rings, wanted);
    if (!forms) return forms.error();
    for (Index i = 0; i < 2 * (depth + 1); ++i)
      tables_.strips.push_back(
          to_stencil((*forms)[static_cast<std::size_t>(i)], true, i % 2, i / 2));
    return Done{};
  }

  Status read_zone(const VertexKind& kind) {
    if (kind.faces == 0) return Done{};
    const bool open = kind.open;
    const Index sectors = kind.faces;
    if (sectors > kLargestTable || (!open && sectors < 3))
      return Error{fmt::format("no table for vertex {} of {} faces", kind.vertices[0], sectors),
                   {},
                   {},
                   0,
                   0};
    const Reach& reach = tables_.reach;
    const Index zone = !open ? reach.star_zone : sectors == 1 ? reach.corner_zone : reach.fan_zone;
    const Index rings = std::max(zone, open ? reach.fan_rings : reach.star_rings);
    const Index size = zone == 0 ? 1
                       : open    ? fan_size(Lattice::triangle, sectors, zone)
                                 : star_size(Lattice::triangle, sectors, zone);
    std::vector<Index> wanted(static_cast<std::size_t>(size));
    std::iota(wanted.begin(), wanted.end(), 0);
    const Result<std::vector<Form>> forms =
        open ? reader_.fan(sectors, rings, wanted) : reader_.star(sectors, rings, wanted);
    if (!forms) return forms.error();
    (open ? tables_.fans : tables_.stars).emplace(sectors, to_table(*forms, sectors, open));
    return Done{};
  }

  const Scheme& scheme_;
  const std::vector<VertexKind>& kinds_;
  Reader reader_;
  StencilTables tables_;
};

}  // namespace

Result<StencilTables> read_stencils(const Scheme& scheme, const std::vector<VertexKind>& kinds) {
  return TableMaker(scheme, kinds).make();
}

}  // namespace limn::fast
