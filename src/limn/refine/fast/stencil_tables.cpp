#include "limn/refine/fast/stencil_tables.h"

#include <algorithm>
#include <numeric>

#include <fmt/core.h>

#include "limn/mesh/lattice.h"
#include "limn/refine/linear_form.h"
#include "limn/refine/refine_values.h"
#include "limn/refine/star_step.h"

namespace limn::fast {
namespace {

constexpr Index kClassRings = 2;  // of a star that holds a point of each class

using Form = LinearForm<double>;

/// Forms of fine points (numbered as on the coarse star) over the coarse vertices.
class Reader {
 public:
  explicit Reader(const Scheme& scheme)
      : scheme_(scheme), closed_(scheme, Boundary::left_out), open_(scheme, Boundary::refined) {}

  Result<std::vector<Form>> read(const StarShape& shape, Index rings,
                                 const std::vector<Index>& wanted) {
    if (!shape.open) {
      const StarStep step = star_step(*scheme_.split, shape.sectors, static_cast<int>(rings));
      return read(closed_, step.coarse, step.fine.births, step.images, wanted);
    }
    const FanStep step = fan_step(*scheme_.split, shape.sectors, static_cast<int>(rings));
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

/// The form of fine point (x, y) of sector 0 as a stencil, on the star or fan that makes the plane
/// or half of it.
Stencil to_stencil(const Form& form, const StarShape& shape, Index fine_x, Index fine_y) {
  Stencil stencil;
  for (const auto& [vertex, weight] : form.terms) {
    if (weight == 0) continue;
    const Offset place = on_plane(shape.lattice, sector_point(shape, vertex));
    stencil.push_back({{place.a - fine_x / 2, place.b - fine_y / 2}, weight});
  }
  std::sort(stencil.begin(), stencil.end(),
            [](const Tap& p, const Tap& q) { return p.place < q.place; });
  return stencil;
}

ZoneTable to_table(const std::vector<Form>& forms, const StarShape& shape) {
  auto [rows, vertices] = to_rows(forms);
  ZoneTable table{shape.sectors, {}, {}, std::move(rows)};
  for (const Index v : vertices) table.sources.push_back(sector_point(shape, v));
  for (Index i = 0; i < table.rows.targets(); ++i) table.targets.push_back(sector_point(shape, i));
  return table;
}

class TableMaker {
 public:
  TableMaker(const Scheme& scheme, const std::vector<VertexKind>& kinds)
      : scheme_(scheme), lattice_(scheme.split->lattice), kinds_(kinds), reader_(scheme) {}

  Result<StencilTables> make() {
    const bool boundary =
        std::any_of(kinds_.begin(), kinds_.end(), [](const VertexKind& kind) { return kind.open; });
    const std::optional<Reach> reach = find_reach(scheme_, boundary);
    if (!reach) return Error{fmt::format("the rules of scheme '{}' look too far", scheme_.name)};
    tables_.lattice = lattice_;
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
    const StarShape plane{lattice_, plane_sectors(lattice_), false};
    std::vector<Index> wanted;
    for (const Index y : {0, 1})
      for (const Index x : {0, 1}) wanted.push_back(vertex_at(plane, {0, x, y}));
    const Result<std::vector<Form>> forms = reader_.read(plane, kClassRings, wanted);
    if (!forms) return forms.error();
    for (const Index y : {0, 1})
      for (const Index x : {0, 1}) {
        const std::size_t c = class_of(x, y);
        tables_.interior[c] = to_stencil((*forms)[c], plane, x, y);
        for (const auto& [place, weight] : tables_.interior[c])
          tables_.halo = std::max(tables_.halo, rows_beyond(x, y, place));
      }
    return Done{};
  }

  /// How far a place lies beyond the sides of any patch that holds the fine point.
  [[nodiscard]] Index rows_beyond(Index x, Index y, Offset place) const {
    const auto [a, b] = place;
    const Index beyond = lattice_ == Lattice::triangle ? a + b - (x + y + 1) / 2
                                                       : std::max(a - (x + 1) / 2, b - (y + 1) / 2);
    return std::max({-a, -b, beyond});
  }

  Status read_strips() {
    const Index depth = tables_.reach.strip_depth;
    const StarShape half{lattice_, half_plane_sectors(lattice_), true};
    std::vector<Index> wanted;
    for (Index y = 0; y <= depth; ++y)
      for (const Index x : {0, 1}) wanted.push_back(vertex_at(half, {0, x, y}));
    const Index rings = std::max(depth, kClassRings) + 1;
    const Result<std::vector<Form>> forms = reader_.read(half, rings, wanted);
    if (!forms) return forms.error();
    for (Index i = 0; i < 2 * (depth + 1); ++i)
      tables_.strips.push_back(
          to_stencil((*forms)[static_cast<std::size_t>(i)], half, i % 2, i / 2));
    return Done{};
  }

  Status read_zone(const VertexKind& kind) {
    if (kind.faces == 0) return Done{};
    const bool open = kind.open;
    const Index sectors = kind.faces;
    const StarShape shape{lattice_, sectors, open};
    if (sectors > kLargestTable || (!open && sectors < fewest_sectors(lattice_)))
      return Error{fmt::format("no table for vertex {} of {} faces", kind.vertices[0], sectors)};
    const Reach& reach = tables_.reach;
    const Index zone = !open ? reach.star_zone : sectors == 1 ? reach.corner_zone : reach.fan_zone;
    const Index rings = std::max(zone, open ? reach.fan_rings : reach.star_rings);
    const Index size = zone == 0 ? 1
                       : open    ? fan_size(lattice_, sectors, zone)
                                 : star_size(lattice_, sectors, zone);
    std::vector<Index> wanted(static_cast<std::size_t>(size));
    std::iota(wanted.begin(), wanted.end(), 0);
    const Result<std::vector<Form>> forms = reader_.read(shape, rings, wanted);
    if (!forms) return forms.error();
    (open ? tables_.fans : tables_.stars).emplace(sectors, to_table(*forms, shape));
    return Done{};
  }

  const Scheme& scheme_;
  Lattice lattice_;
  const std::vector<VertexKind>& kinds_;
  Reader reader_;
  StencilTables tables_;
};

}  // namespace

Result<StencilTables> read_stencils(const Scheme& scheme, const std::vector<VertexKind>& kinds) {
  return TableMaker(scheme, kinds).make();
}

}  // namespace limn::fast
