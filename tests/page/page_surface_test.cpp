#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "core/page_core.h"
#include "limn/mesh/io/mesh_file.h"
#include "limn/mesh/mesh.h"
#include "limn/mesh/surface_distance.h"
#include "limn/scheme/file/shipped_files.h"
#include "limn/surface/refine_surface.h"

namespace limn::test {
namespace {

using nlohmann::json;
using page::PageCore;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

json parsed(const std::string& text) { return json::parse(text); }

std::string text_of(const std::string& scheme) {
  for (const scheme::ShippedFile& file : scheme::shipped_files())
    if (file.name == scheme) return std::string(file.text);
  return {};
}

int id_of(const std::string& answer) {
  const json made = parsed(answer);
  EXPECT_TRUE(made.at("ok")) << made;
  return made.value("id", 0);
}

bool is_ok(const std::string& answer) { return parsed(answer).at("ok"); }

using Row = std::array<double, 6>;

/// Position and normal of each vertex, rounded so that neighbours in size stay so, in order.
std::vector<Row> rows_of(std::vector<Row> rows) {
  for (Row& row : rows)
    for (double& number : row) number = std::round(number * 1e4) / 1e4 + 0.0;
  std::sort(rows.begin(), rows.end());
  return rows;
}

std::vector<Row> rows_of(const page::SurfaceAnswer& surface) {
  std::vector<Row> rows(surface.positions.size() / 3);
  for (std::size_t v = 0; v < rows.size(); ++v)
    for (std::size_t c = 0; c < 3; ++c) {
      rows[v][c] = static_cast<double>(surface.positions[3 * v + c]);
      rows[v][c + 3] = static_cast<double>(surface.normals[3 * v + c]);
    }
  return rows_of(std::move(rows));
}

std::vector<Row> rows_of(const RefinedSurface& surface) {
  std::vector<Row> rows;
  for (std::size_t v = 0; v < surface.limit.size(); ++v) {
    const Point3 p = surface.limit[v], n = surface.normals[v];
    rows.push_back({p.x, p.y, p.z, n.x, n.y, n.z});
  }
  return rows_of(std::move(rows));
}

/// How many rows differ by more than rounding to four decimals may.
int different(const std::vector<Row>& a, const std::vector<Row>& b) {
  if (a.size() != b.size()) return -1;
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    count += std::equal(a[i].begin(), a[i].end(), b[i].begin(),
                        [](double x, double y) { return std::abs(x - y) < 1.5e-4; })
                 ? 0
                 : 1;
  return count;
}

TEST(PageSurface, IsThatOfThePlainEngine) {
  const Polygons bracket = read_mesh(LIMN_EXAMPLES "/bracket.obj").value();
  for (const char* name : {"loop", "sqrt3", "butterfly-modified", "loop-ternary"}) {
    const Scheme scheme = find_scheme(name).value();
    PageCore core;
    const int plan = id_of(core.plan(id_of(core.load(text_of(name), "")),
                                     id_of(core.mesh("bracket")), R"({"levels":2})"));
    const page::SurfaceAnswer surface = core.evaluate(plan);
    ASSERT_TRUE(parsed(surface.json).at("limit")) << name << surface.json;
    SurfaceOptions options;
    options.levels = 2;
    options.limit = options.normals = true;
    options.engine = SurfaceOptions::Engine::plain;
    const RefinedSurface plain =
        refine_surface(scheme, Mesh::build(bracket).value(), bracket.positions, options).value();
    // rounding may put a few rows of nearly equal numbers in another order
    const std::vector<Row> ours = rows_of(surface), theirs = rows_of(plain);
    ASSERT_EQ(ours.size(), theirs.size());
    EXPECT_LE(different(ours, theirs), static_cast<int>(ours.size() / 100)) << name;
  }
}

Point3 point_of(const page::LinesAnswer& lines, std::size_t point,
                const std::vector<float>& positions) {
  Point3 sum;
  const std::uint32_t first = lines.begin.at(point), last = lines.begin.at(point + 1);
  for (std::uint32_t i = first; i < last; ++i) {
    const std::size_t v = 3 * std::size_t{lines.vertices.at(i)};
    sum = sum + Point3{positions.at(v), positions.at(v + 1), positions.at(v + 2)};
  }
  return (1.0 / (last - first)) * sum;
}

/// Total length of the lines on the surface.
double length_of(const page::LinesAnswer& lines, const std::vector<float>& positions) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < lines.segments.size(); i += 2) {
    const Point3 along = point_of(lines, lines.segments[i + 1], positions) -
                         point_of(lines, lines.segments[i], positions);
    length += std::sqrt(dot(along, along));
  }
  return length;
}

TEST(PageSurface, LinesAreTheControlEdgesImages) {
  for (const char* mesh : {"cube", "cube-creased"}) {
    PageCore core;
    const int scheme = id_of(core.load(text_of("catmull-clark"), ""));
    const int control = id_of(core.mesh(mesh));
    double before = 0;
    for (const char* options : {R"({"levels":2})", R"({"levels":3})", R"({"levels":4})"}) {
      const int plan = id_of(core.plan(scheme, control, options));
      const page::LinesAnswer lines = core.lines(plan);
      const std::size_t pieces = std::size_t{12} << (options[10] - '0');
      ASSERT_EQ(lines.segments.size(), 2 * pieces) << mesh;
      // curves on one surface: finer polygons of them are only a little longer
      const double length = length_of(lines, core.evaluate(plan).positions);
      if (before > 0) {
        EXPECT_NEAR(length, before, 0.02 * before) << mesh;
      }
      before = length;
    }
  }
}

// The engines number vertices each in its own way: of what is found in the plain one's order, the
// places must be those of this plan. On a torus, whose patches are all alike, curves come to rest.
TEST(PageSurface, LinesAreThereForEverySplit) {
  for (const char* name : {"loop", "sqrt3", "four-eight", "doo-sabin", "midedge", "loop-ternary",
                           "catmull-clark", "butterfly-ternary"}) {
    PageCore core;
    const json scheme = parsed(core.load(text_of(name), ""));
    const int control =
        id_of(core.mesh(scheme.at("lattice") == "triangles" ? "torus-triangles" : "torus-quads"));
    const json about = parsed(core.control(control).json);
    double before = 0;
    for (const int levels : {2, 3, 4}) {
      const int plan = id_of(core.plan(scheme.at("id"), control, json{{"levels", levels}}.dump()));
      const page::LinesAnswer lines = core.lines(plan);
      ASSERT_GE(lines.segments.size(), 2 * about.at("edges").get<std::size_t>()) << name;
      const double length = length_of(lines, core.evaluate(plan).positions);
      if (before > 0) {
        EXPECT_NEAR(length, before, 0.03 * before) << name << levels;
      }
      before = length;
    }
  }
}

constexpr const char* kSquares =  // two quads, a seam between them
    "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 3 3\nvt 4 3\nvt 4 4\nvt 3 4\n"
    "f 1/1 2/2 5/3 4/4\nf 2/5 3/6 6/7 5/8\n";

/// The place in the plane of each corner, by x and y, goes with its texture coordinates.
TEST(PageSurface, TextureCoordinatesGoAlong) {
  PageCore core;
  const int scheme = id_of(core.load(text_of("catmull-clark"), ""));
  const int mesh = id_of(core.load_mesh("squares.obj", kSquares, ""));
  const int plan = id_of(core.plan(scheme, mesh, R"({"levels":2,"limit":false,"texture":true})"));
  const page::TextureAnswer texture = core.texture(plan);
  EXPECT_EQ(parsed(texture.json).at("pattern"), "image");
  const std::vector<std::uint32_t> triangles = core.topology(plan).triangles;
  ASSERT_EQ(texture.coordinates.size(), 2 * triangles.size());
  ASSERT_EQ(triangles.size(), 2U * 16 * 2 * 3);
  const std::vector<float> positions = core.evaluate(plan).positions;
  int left = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const float x = positions[3 * triangles[i]], u = texture.coordinates[2 * i];
    if (x < 0.9F || x > 1.1F) {
      EXPECT_EQ(x < 1, u < 2) << x << " " << u;  // either side of the seam
    }
    left += u < 2 ? 1 : 0;
  }
  EXPECT_EQ(2 * static_cast<std::size_t>(left), triangles.size());
}

TEST(PageSurface, FacesHaveTextureCoordinatesOfTheirOwn) {
  PageCore core;
  const int mesh = id_of(core.mesh("octahedron"));
  const int loop = id_of(core.load(text_of("loop"), ""));
  const int plan = id_of(core.plan(loop, mesh, R"({"levels":2,"texture":true})"));
  const page::TextureAnswer texture = core.texture(plan);
  EXPECT_EQ(parsed(texture.json).at("pattern"), "triangles");
  ASSERT_EQ(texture.coordinates.size(), 2 * core.topology(plan).triangles.size());
  for (std::size_t i = 0; i < texture.coordinates.size(); i += 2) {  // quarters of the face
    const float u = 4 * texture.coordinates[i], v = 4 * texture.coordinates[i + 1];
    EXPECT_NEAR(u, std::round(u), 1e-6);
    EXPECT_NEAR(v, std::round(v), 1e-6);
    EXPECT_LE(u + v, 4 + 1e-6);
  }
  // faces that lie across old edges have none, and it is said
  const int turned = id_of(
      core.plan(id_of(core.load(text_of("sqrt3"), "")), mesh, R"({"levels":2,"texture":true})"));
  const json none = parsed(core.texture(turned).json);
  EXPECT_EQ(none.at("pattern"), "none");
  EXPECT_NE(none.at("reason").get<std::string>().find("seams"), std::string::npos);
  EXPECT_FALSE(is_ok(core.texture(id_of(core.plan(loop, mesh, ""))).json));
}

// At a vertex of valence 5 these weights have no limit.
TEST(PageSurface, WhereThereIsNoLimitThereAreHoles) {
  PageCore core;
  const std::string text =
      "name = \"jumps\"\nsplit = \"triangle-dyadic\"\nextends = \"loop\"\n"
      "[[vertex]]\nwhen = \"n == 5\"\nself = \"3\"\nring = \"-2/n\"\n"
      "[[vertex]]\nself = \"1 - n*beta\"\nring = \"beta\"\n";
  const int scheme = id_of(core.load(text, ""));
  std::string hill = "v 0 0 1\n";
  for (int i = 0; i < 5; ++i)
    hill += "v " + std::to_string(std::cos(i * 2 * M_PI / 5)) + " " +
            std::to_string(std::sin(i * 2 * M_PI / 5)) + " 0\n";
  for (int i = 0; i < 5; ++i)
    hill += "f 1 " + std::to_string(2 + i) + " " + std::to_string(2 + (i + 1) % 5) + "\n";
  const int mesh = id_of(core.load_mesh("hill.obj", hill, ""));
  const json plan = parsed(core.plan(scheme, mesh, R"({"levels":2})"));
  ASSERT_TRUE(plan.at("ok")) << plan;
  EXPECT_TRUE(plan.at("limit"));
  EXPECT_GE(plan.at("missing"), 1);
  EXPECT_FALSE(plan.at("reason").get<std::string>().empty());
  const std::size_t triangles = core.topology(plan.at("id")).triangles.size() / 3;
  EXPECT_EQ(triangles, plan.at("triangles"));
  EXPECT_LE(triangles, 80U - 5);
  const json whole = parsed(core.plan(scheme, mesh, R"({"levels":2,"limit":false})"));
  EXPECT_EQ(whole.at("triangles"), 80);
}

TEST(PageSurface, APlanInsteadOfAnotherIsThatOfItsOwnParameters) {
  PageCore core;
  const std::string text = text_of("laplacian-loop");
  const int mesh = id_of(core.mesh("bracket"));
  const auto load = [&](const char* a) { return id_of(core.load(text, json{{"a", a}}.dump())); };
  int before = id_of(core.plan(load("1/32"), mesh, R"({"levels":3})"));
  for (const char* a : {"1/16", "1/8", "1/32"}) {
    const int fresh = id_of(core.plan(load(a), mesh, R"({"levels":3})"));
    const int instead =
        id_of(core.plan(load(a), mesh, json{{"levels", 3}, {"instead", before}}.dump()));
    EXPECT_EQ(core.evaluate(instead).positions, core.evaluate(fresh).positions) << a;
    EXPECT_EQ(core.evaluate(instead).normals, core.evaluate(fresh).normals) << a;
    EXPECT_EQ(core.topology(instead).triangles, core.topology(fresh).triangles) << a;
    EXPECT_FALSE(is_ok(core.evaluate(before).json));
    before = instead;
  }
  // of other levels, and of another mesh, nothing of it is left
  const int coarse =
      id_of(core.plan(load("1/8"), mesh, json{{"levels", 1}, {"instead", before}}.dump()));
  const int other = id_of(core.plan(load("1/8"), id_of(core.mesh("octahedron")),
                                    json{{"levels", 2}, {"instead", coarse}}.dump()));
  EXPECT_EQ(core.evaluate(other).positions.size(), 3U * 66);
  EXPECT_EQ(core.topology(other).triangles.size(), 3U * 128);
}

TEST(PageSurface, FollowsAMovedVertex) {
  PageCore core;
  const int mesh = id_of(core.mesh("octahedron"));
  const int plan = id_of(core.plan(id_of(core.load(text_of("loop"), "")), mesh, R"({"levels":1})"));
  const std::vector<float> before = core.evaluate(plan).positions;
  EXPECT_TRUE(is_ok(core.move_vertex(mesh, 0, 5, 0, 0)));
  const std::vector<float> after = core.evaluate(plan).positions;
  ASSERT_EQ(before.size(), after.size());
  // vertex 0's limit is 3/8/(3/8 + 4 beta) … of it and the rest of its neighbours, which stay
  EXPECT_GT(after[0], before[0] + 1);
  EXPECT_TRUE(is_ok(core.move_vertex(mesh, 0, 1.3, 0, 0)));
  EXPECT_EQ(core.evaluate(plan).positions, before);
}

TEST(PageSurface, SharpEdgesNeedTheirPlanAnew) {
  PageCore core;
  const int scheme = id_of(core.load(text_of("catmull-clark"), ""));
  const int mesh = id_of(core.mesh("cube"));
  const int smooth = id_of(core.plan(scheme, mesh, R"({"levels":2})"));
  for (int edge = 0; edge < 12; ++edge)
    EXPECT_TRUE(is_ok(core.set_sharpness(mesh, "edge", edge, 10)));
  const int sharp = id_of(core.plan(scheme, mesh, R"({"levels":2})"));
  const std::vector<float> points = core.evaluate(sharp).positions;
  // all edges sharp: the cube itself, whose corners stay
  const float largest = *std::max_element(points.begin(), points.end());
  EXPECT_NEAR(largest, 1, 1e-6);
  const std::vector<float> round = core.evaluate(smooth).positions;
  EXPECT_LT(*std::max_element(round.begin(), round.end()), 0.9);
}

TEST(PageSurface, CurvatureOfARefinedTorusAddsUpToZero) {
  PageCore core;
  const int plan = id_of(core.plan(id_of(core.load(text_of("loop"), "")),
                                   id_of(core.mesh("torus-triangles")), R"({"levels":2})"));
  const page::CurvatureAnswer curvature = core.curvature(plan);
  const page::SurfaceAnswer surface = core.evaluate(plan);
  const page::TopologyAnswer topology = core.topology(plan);
  ASSERT_EQ(3 * curvature.gaussian.size(), surface.positions.size());
  double total = 0, absolute = 0;  // Gauss and Bonnet: ∫ K = 2π χ = 0
  for (std::size_t t = 0; t + 2 < topology.triangles.size(); t += 3) {
    std::array<Point3, 3> p;
    double k = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t v = topology.triangles[t + i];
      p[i] = {surface.positions[3 * v], surface.positions[3 * v + 1], surface.positions[3 * v + 2]};
      k += static_cast<double>(curvature.gaussian[v]) / 3;
    }
    const Point3 area = cross(p[1] - p[0], p[2] - p[0]);
    total += k * std::sqrt(dot(area, area)) / 2;
    absolute += std::abs(k) * std::sqrt(dot(area, area)) / 2;
  }
  EXPECT_GT(absolute, 10);
  EXPECT_LT(std::abs(total), 0.02 * absolute);
}

TEST(PageSurface, DistanceIsBetweenTheTwoSurfaces) {
  PageCore core;
  const int mesh = id_of(core.mesh("bracket"));
  const int loop = id_of(core.plan(id_of(core.load(text_of("loop"), "")), mesh, R"({"levels":2})"));
  const int other =
      id_of(core.plan(id_of(core.load(text_of("butterfly"), "")), mesh, R"({"levels":2})"));
  const page::FieldAnswer apart = core.distance(loop, other);
  ASSERT_TRUE(is_ok(apart.json)) << apart.json;
  EXPECT_EQ(3 * apart.values.size(), core.evaluate(loop).positions.size());
  const float largest = *std::max_element(apart.values.begin(), apart.values.end());
  EXPECT_LE(largest, parsed(apart.json).at("largest").get<float>() * 1.0001F);
  EXPECT_GT(largest, 0.01F);
  EXPECT_EQ(parsed(core.distance(loop, loop).json).at("largest"), 0);
}

TEST(PageSurface, EveryShippedSchemeHasAMeshThatItRefines) {
  for (const scheme::ShippedFile& file : scheme::shipped_files()) {
    PageCore core;
    const json loaded = parsed(core.load(std::string(file.text), ""));
    ASSERT_TRUE(loaded.at("ok")) << file.name;
    const std::string name =
        loaded.at("lattice") == "triangles" ? "torus-triangles" : "torus-quads";
    const json plan = parsed(core.plan(loaded.at("id"), id_of(core.mesh(name)), R"({"levels":2})"));
    EXPECT_EQ(plan.at("ok"), loaded.at("features").at("refine")) << file.name << plan;
    if (!plan.at("ok")) continue;
    const page::SurfaceAnswer surface = core.evaluate(plan.at("id"));
    EXPECT_EQ(surface.positions.size(), 3 * plan.at("vertices").get<std::size_t>()) << file.name;
    EXPECT_TRUE(std::all_of(surface.positions.begin(), surface.positions.end(), [](float x) {
      return std::isfinite(x);
    })) << file.name;
  }
}

TEST(PageSurface, FaultyMeshesAreToldAndRepaired) {
  PageCore core;
  // a bow-tie of two triangles, and one more that is flipped
  const std::string faulty =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv -1 -1 0\nv -1 0 0\nf 1 2 3\nf 2 3 4\nf 1 5 6\n";
  const json refused = parsed(core.load_mesh("x.obj", faulty, ""));
  EXPECT_FALSE(refused.at("ok"));
  EXPECT_FALSE(refused.at("check").at("refinable"));
  EXPECT_FALSE(refused.at("errors").empty());
  const json mended = parsed(core.load_mesh("x.obj", faulty, "repair"));
  EXPECT_TRUE(mended.at("ok")) << mended;
  EXPECT_FALSE(mended.at("repaired").empty());
  const json nothing = parsed(core.load_mesh("x.obj", "v 1 2\n", ""));
  EXPECT_FALSE(nothing.at("ok"));
  EXPECT_EQ(nothing.at("errors").at(0).at("line"), 1);
}

TEST(PageSurface, BadNumbersAreRefused) {
  PageCore core;
  const int scheme = id_of(core.load(text_of("loop"), ""));
  const int mesh = id_of(core.mesh("octahedron"));
  const int plan = id_of(core.plan(scheme, mesh, ""));
  EXPECT_FALSE(is_ok(core.eigen(scheme, 1000000, true)));
  EXPECT_FALSE(is_ok(core.eigen(scheme, -1, false)));
  EXPECT_FALSE(is_ok(core.eigen(99, 5, true)));
  EXPECT_FALSE(is_ok(core.characteristic_map(scheme, 128, 99).json));
  EXPECT_FALSE(is_ok(core.artifacts(scheme, kNan, 0)));
  EXPECT_FALSE(is_ok(core.sampling(scheme, kNan)));
  EXPECT_FALSE(is_ok(core.artifact_map(scheme, 1 << 30, "mean_energy").json));
  EXPECT_FALSE(is_ok(core.wave(scheme, 1e300, 0, 2).json));
  EXPECT_FALSE(is_ok(core.regularity(scheme, kNan)));
  for (const char* options :
       {R"({"levels":11})", R"({"levels":-1})", R"({"levels":1e9})", "[", "7", R"({"limit":3})"})
    EXPECT_FALSE(is_ok(core.plan(scheme, mesh, options))) << options;
  const int bracket = id_of(core.mesh("bracket"));
  EXPECT_FALSE(is_ok(core.plan(scheme, bracket, R"({"levels":10})")));  // too many vertices
  EXPECT_FALSE(is_ok(core.move_vertex(mesh, 6, 0, 0, 0)));
  EXPECT_FALSE(is_ok(core.move_vertex(mesh, 0, kNan, 0, 0)));
  EXPECT_FALSE(is_ok(core.set_sharpness(mesh, "edge", 0, kNan)));
  EXPECT_FALSE(is_ok(core.set_sharpness(mesh, "face", 0, 1)));
  EXPECT_FALSE(is_ok(core.set_sharpness(mesh, "edge", -1, 1)));
  EXPECT_FALSE(is_ok(core.load(text_of("laplacian-loop"), R"({"a": null})")));
  EXPECT_FALSE(is_ok(core.load(text_of("laplacian-loop"), R"({"a": 1e300})")));
  EXPECT_FALSE(is_ok(core.load(text_of("laplacian-loop"), R"({"a": "1/0"})")));
  EXPECT_FALSE(is_ok(core.load(text_of("laplacian-loop"), "{")));
  EXPECT_FALSE(is_ok(core.mesh("no such mesh")));
  EXPECT_FALSE(is_ok(core.distance(plan, 99).json));
  EXPECT_TRUE(is_ok(core.evaluate(plan).json));
}

/// A text with some of its bytes replaced, doubled or left out.
std::string mutated(std::string text, std::mt19937& random) {
  for (int i = 0; i < 4 && !text.empty(); ++i) {
    const std::size_t at = random() % text.size();
    switch (random() % 3) {
      case 0: text[at] = static_cast<char>(random() % 256); break;
      case 1: text.insert(at, text.substr(at, random() % 40)); break;
      default: text.erase(at, random() % 40);
    }
  }
  return text;
}

TEST(PageSurface, NoTextIsTooWild) {
  std::mt19937 random(7);
  PageCore core;
  const int mesh = id_of(core.mesh("octahedron"));
  for (int round = 0; round < 60; ++round) {
    const std::string text = mutated(text_of(round % 2 == 0 ? "loop" : "butterfly"), random);
    const json loaded = parsed(core.load(text, ""));
    if (!loaded.at("ok")) {
      EXPECT_FALSE(loaded.at("errors").empty());
      continue;
    }
    const int id = loaded.at("id");
    (void)parsed(core.eigen(id, 5, true));
    (void)parsed(core.plan(id, mesh, R"({"levels":2})"));
    core.unload(id);
  }
  for (int round = 0; round < 200; ++round) {
    const std::string text =
        mutated("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n", random);
    (void)parsed(core.load_mesh("x.obj", text, round % 2 == 0 ? "" : "repair"));
  }
}

}  // namespace
}  // namespace limn::test
