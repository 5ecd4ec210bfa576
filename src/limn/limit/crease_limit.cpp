#include "limn/limit/crease_limit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <fmt/core.h>

#include "limn/base/parallel.h"
#include "limn/limit/limit_ways.h"
#include "limn/limit/mesh_part.h"
#include "limn/limit/vertex_sides.h"
#include "limn/mesh/index.h"
#include "limn/mesh/sharpness/cut_mesh.h"
#include "limn/mesh/unit_normal.h"
#include "limn/refine/refine.h"

namespace limn::limit {
namespace {

constexpr int kMostSteps = 160;
constexpr int kRestingSteps = 4;  // so many in which a point does not move by more than rounding
constexpr double kNormalRests = 1e-14;
constexpr std::size_t kTogether = 128;  // vertices whose neighbourhoods fade in one part

using mesh::at;

double distance(Point3 a, Point3 b) {
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

/// What rests in the end: a vertex's point, and the normal of each of its sides.
struct Rested {
  Point3 point;
  std::vector<Point3> normals;  ///< empty: none is known
  bool reached = false;
};

class CreaseLimit {
 public:
  CreaseLimit(const Scheme& scheme, const Mesh& mesh, const std::vector<Point3>& values,
              const Sharpness& sharpness, const LimitOptions& options, bool normals)
      : scheme_(scheme),
        mesh_(mesh),
        values_(values),
        sharpness_(sharpness),
        options_(options),
        normals_(normals),
        rings_(rings_of_limit(scheme)),
        found_(limit_ways(scheme, mesh, sharpness, options.vertices)) {}

  Result<SharpLimitPoints> run() {
    const std::size_t count = found_.ways.size();
    result_.positions.resize(count);
    result_.normals.resize(count);
    if (options_.curvatures) {
      constexpr double nan = std::numeric_limits<double>::quiet_NaN();
      result_.curvatures.assign(count, {nan, nan});
      result_.no_curvature.assign(count, NoCurvature::no_normal);
    }
    if (Status status = find_on_cut(); !status) return status.error();
    if (Status status = rest_all(); !status) return status.error();
    if (Status status = find_later(); !status) return status.error();
    if (result_.sides.empty()) result_.sides.of_corner.clear();
    return std::move(result_);
  }

 private:
  using Kind = refine::CreaseStep::Rule;
  /// Smooth vertices and those on creases have the limits of the mesh that is cut there.
  Status find_on_cut() {
    const mesh::CutMesh cut = mesh::cut_along(mesh_, found_.sharp);
    std::vector<Point3> values;
    values.reserve(cut.originals.size());
    LimitOptions some = options_;
    some.vertices.clear();
    some.partial = true;  // so that vertices have their own numbers here
    std::vector<Index> copies(found_.ways.size(), 0);
    for (std::size_t copy = 0; copy < cut.originals.size(); ++copy) {
      const std::size_t v = at(cut.originals[copy]);
      values.push_back(values_[v]);
      ++copies[v];
      if (found_.ways[v] == LimitWay::on_cut) some.vertices.push_back(static_cast<Index>(copy));
    }
    if (some.vertices.empty()) return Done{};
    Result<LimitPoints> found = approx_limit_points(scheme_, cut.mesh, values, some);
    if (!found) return found.error();
    for (const Index copy : some.vertices) {
      const std::size_t v = at(cut.originals[at(copy)]);
      result_.positions[v] = result_.positions[v] + (1.0 / copies[v]) * found->positions[at(copy)];
      if (copies[v] > 1) continue;
      take(*found, at(copy), v);
    }
    find_sides_on_cut(cut, copies, found->normals);
    for (LimitPoints::Refused& gap : found->refused) gap.vertex = cut.originals[at(gap.vertex)];
    return refuse(std::move(found->refused));
  }

  /// These have no limit, which is an error but where that is allowed.
  Status refuse(std::vector<LimitPoints::Refused> gaps) {
    if (gaps.empty()) return Done{};
    if (!options_.partial)
      return Error{fmt::format("no limit point at vertex {}: {}", gaps[0].vertex, gaps[0].reason)};
    std::vector<LimitPoints::Refused>& all = result_.refused;
    for (LimitPoints::Refused& gap : gaps) all.push_back(std::move(gap));
    using Refused = LimitPoints::Refused;
    const auto before = [](const Refused& a, const Refused& b) { return a.vertex < b.vertex; };
    const auto same = [](const Refused& a, const Refused& b) { return a.vertex == b.vertex; };
    std::stable_sort(all.begin(), all.end(), before);
    all.erase(std::unique(all.begin(), all.end(), same), all.end());
    return Done{};
  }

  /// Normal and curvature of a vertex with one side.
  void take(const LimitPoints& found, std::size_t from, std::size_t to) {
    result_.normals[to] = found.normals[from];
    if (!options_.curvatures) return;
    result_.curvatures[to] = found.curvatures[from];
    result_.no_curvature[to] = found.no_curvature[from];
  }

  void find_sides_on_cut(const mesh::CutMesh& cut, const std::vector<Index>& copies,
                         const std::vector<Point3>& normals) {
    std::vector<Index> number(cut.originals.size(), kNone);
    for (Index h = 0; h < mesh_.halfedge_count(); ++h) {
      const std::size_t v = at(mesh_.origin(h));
      if (found_.ways[v] != LimitWay::on_cut || copies[v] < 2) continue;
      Index& side = number[at(cut.mesh.origin(h))];
      if (side == kNone) side = add_side(normals[at(cut.mesh.origin(h))]);
      of_corner(h) = side;
    }
  }

  Index add_side(const Point3& normal) {
    result_.sides.normals.push_back(normal);
    return static_cast<Index>(result_.sides.normals.size()) - 1;
  }
  Index& of_corner(Index h) {
    if (result_.sides.of_corner.empty())
      result_.sides.of_corner.assign(at(mesh_.halfedge_count()), kNone);
    return result_.sides.of_corner[at(h)];
  }

  /// One for each side, or none.
  void put_normals(Index v, const VertexSides& sides, const std::vector<Point3>& normals) {
    if (normals.empty()) return;
    if (sides.count() == 1) {
      result_.normals[at(v)] = normals[0];
      return;
    }
    for (std::size_t side = 0; side < sides.count(); ++side) {
      const Index number = add_side(normals[side]);
      for (std::size_t i = sides.begins[side]; i < sides.begins[side + 1]; ++i)
        of_corner(sides.halfedges[i]) = number;
    }
  }

  Status rest_all() {
    const std::vector<Index> vertices = found_.those(LimitWay::resting);
    std::vector<Rested> rested(vertices.size());
    std::vector<Status> done(vertices.size(), Done{});
    const auto rest_some = [&](Index first, Index last) {
      for (Index i = first; i < last; ++i) {
        Result<Rested> one = rest(vertices[at(i)]);
        if (one)
          rested[at(i)] = std::move(*one);
        else
          done[at(i)] = one.error();
      }
    };
    base::parallel_for(Index{0}, static_cast<Index>(vertices.size()), rest_some, 1);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (!done[i]) return done[i];
      if (!rested[i].reached) return Error{"the limit at a vertex is not reached"};
      result_.positions[at(vertices[i])] = rested[i].point;
      put_normals(vertices[i], sides_of(mesh_, sharpness_, vertices[i]), rested[i].normals);
    }
    return Done{};
  }

  /// Until the point rests, or nearly, and the normals: their steps shrink by a factor each. The
  /// point is kept at 0, so that nothing is lost of what is round it.
  Result<Rested> rest(Index v) const {
    if (found_.kinds[at(v)] == Kind::corner && !normals_) return Rested{values_[at(v)], {}, true};
    refine::RuleTables<double> tables(scheme_);
    PartCutter cutter(mesh_, values_, sharpness_);
    MeshPart part = cutter.run({v}, rings_);
    const VertexSides sides = sides_of(mesh_, sharpness_, v);
    name_edges(mesh_, sharpness_, v, cutter, part);
    double size = 0;
    for (const Point3& p : part.values) size = std::max(size, distance(p, {}));
    Rested result;
    result.point = moved_to_origin(part);
    int exponent = 0;  // the part is 2^exponent times as large as it was
    // a cone has no normal
    const bool cone = found_.kinds[at(v)] == Kind::corner && !sides.open && sides.count() == 1;
    int resting = 0;
    for (int step = 0; step < kMostSteps && resting < kRestingSteps; ++step) {
      Result<refine::Refined<Point3>> fine = refine::refine_once(
          scheme_, part.mesh, part.values, part.sharpness, options_.steps_made + step, tables);
      if (!fine) return fine.error();
      part = cut_out({std::move(fine->mesh), std::move(fine->values), std::move(fine->sharpness)},
                     1, rings_);
      const Point3 way = mesh::scaled({moved_to_origin(part)}, -exponent)[0];
      exponent += made_usual(part);
      result.point = result.point + way;
      result.reached = distance(way, {}) <= std::numeric_limits<double>::epsilon() * size;
      std::vector<Point3> normals;
      if (normals_ && !cone)
        normals = normals_of_faces(part.mesh, part.values, same_sides(part, 0, mesh_, sides));
      bool rests = result.reached && normals.size() == result.normals.size();
      for (std::size_t i = 0; rests && i < normals.size(); ++i)
        rests = distance(normals[i], result.normals[i]) <= kNormalRests;
      resting = rests ? resting + 1 : 0;
      result.normals = std::move(normals);
    }
    return result;
  }

  /// Multiplies by a power of two, so that nothing is lost however small the part becomes; returns
  /// its exponent.
  static int made_usual(MeshPart& part) {
    int largest = mesh::kNoExponent;
    for (const Point3& p : part.values)
      largest = std::max(largest, mesh::largest_exponent(std::array{p.x, p.y, p.z}));
    if (largest == mesh::kNoExponent) return 0;
    part.values = mesh::scaled(std::move(part.values), -largest);
    return -largest;
  }

  /// Where the centre was.
  static Point3 moved_to_origin(MeshPart& part) {
    const Point3 centre = part.values[0];
    for (Point3& p : part.values) p = p - centre;
    return centre;
  }

  /// Vertices at which something fades, or near which something fades or rests: their
  /// neighbourhoods are refined until it has faded, or is farther off.
  Status find_later() {
    const std::vector<Index> vertices = found_.those(LimitWay::later);
    for (std::size_t first = 0; first < vertices.size(); first += kTogether) {
      const std::size_t end = std::min(first + kTogether, vertices.size());
      const std::vector<Index> some(vertices.begin() + static_cast<std::ptrdiff_t>(first),
                                    vertices.begin() + static_cast<std::ptrdiff_t>(end));
      if (Status status = find_later(some); !status) return status;
      if (options_.progress) options_.progress(static_cast<int>(vertices.size() - end));
    }
    return Done{};
  }

  Status find_later(const std::vector<Index>& vertices) {
    PartCutter cutter(mesh_, values_, sharpness_);
    MeshPart part = cutter.run(vertices, rings_);
    for (const Index v : vertices) name_edges(mesh_, sharpness_, v, cutter, part);
    refine::RuleTables<double> tables(scheme_);
    const auto centres = static_cast<Index>(vertices.size());
    LimitOptions there = options_;
    there.partial = true;
    do {
      Result<refine::Refined<Point3>> fine = refine::refine_once(
          scheme_, part.mesh, part.values, part.sharpness, there.steps_made, tables);
      if (!fine) return fine.error();
      part = cut_out({std::move(fine->mesh), std::move(fine->values), std::move(fine->sharpness)},
                     centres, rings_);
      ++there.steps_made;
    } while (part.sharpness.fades());
    there.vertices.resize(vertices.size());
    std::iota(there.vertices.begin(), there.vertices.end(), 0);
    const Result<SharpLimitPoints> found =
        approx_limit_points(scheme_, part.mesh, part.values, part.sharpness, there, normals_);
    if (!found) return found.error();
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Index v = vertices[i];
      result_.positions[at(v)] = found->positions[i];
      take(*found, i, at(v));
      put_normals(v, sides_of(mesh_, sharpness_, v),
                  normals_there(part, *found, static_cast<Index>(i), v));
    }
    std::vector<LimitPoints::Refused> gaps = found->refused;
    for (LimitPoints::Refused& gap : gaps) gap.vertex = vertices[at(gap.vertex)];
    return refuse(std::move(gaps));
  }

  /// Of the sides of vertex v, which is centre i of a part whose limits were found.
  [[nodiscard]] std::vector<Point3> normals_there(const MeshPart& part,
                                                  const SharpLimitPoints& found, Index i,
                                                  Index v) const {
    if (found.sides.empty()) return {found.normals[at(i)]};
    const VertexSides there = same_sides(part, i, mesh_, sides_of(mesh_, sharpness_, v));
    std::vector<Point3> normals;
    for (std::size_t side = 0; side < there.count(); ++side) {
      const Index number = found.sides.of_corner[at(there.halfedges[there.begins[side]])];
      normals.push_back(number == kNone ? found.normals[at(i)] : found.sides.normals[at(number)]);
    }
    return normals;
  }

  const Scheme& scheme_;
  const Mesh& mesh_;
  const std::vector<Point3>& values_;
  const Sharpness& sharpness_;
  const LimitOptions& options_;
  bool normals_;
  int rings_;
  LimitWays found_;
  SharpLimitPoints result_;
};

}  // namespace

Result<SharpLimitPoints> approx_limit_points(const Scheme& scheme, const Mesh& mesh,
                                             const std::vector<Point3>& values,
                                             const Sharpness& sharpness,
                                             const LimitOptions& options, bool normals) {
  if (sharpness.any()) return CreaseLimit(scheme, mesh, values, sharpness, options, normals).run();
  Result<LimitPoints> smooth = approx_limit_points(scheme, mesh, values, options);
  if (!smooth) return smooth.error();
  SharpLimitPoints result;
  static_cast<LimitPoints&>(result) = *std::move(smooth);
  return result;
}

}  // namespace limn::limit
