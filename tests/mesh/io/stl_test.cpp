#include <gtest/gtest.h>

#include "limn/mesh/io/mesh_file.h"
#include "limn/mesh/io/stl_slivers.h"
#include "limn/mesh/mesh.h"
#include "mesh/io/mesh_samples.h"

namespace limn {
namespace {

Polygons parse(std::string_view text, Warnings* warnings = nullptr) {
  Result<Polygons> mesh = parse_mesh(text, "stl", "test.stl", warnings);
  EXPECT_TRUE(mesh.ok()) << mesh.error().text();
  return mesh.ok() ? *mesh : Polygons{};
}

float float_at(const std::string& text, std::size_t at) {
  float value = 0;
  std::memcpy(&value, text.data() + at, sizeof(value));
  return value;
}

TEST(Stl, AsciiInAnyCaseAndLayoutMergesEqualCorners) {
  const Polygons mesh = parse(
      "SOLID two words\nFACET NORMAL nan nan nan\n OUTER LOOP\n  VERTEX 0 0 0\n  VERTEX 1 0 0\n"
      "  VERTEX 0 1 0\n ENDLOOP\nENDFACET\nendsolid two words\n"
      "solid\n\nfacet normal 0 0 1 outer loop vertex 1 0\n0 vertex 1 1 0 vertex 0 1 0 endloop "
      "endfacet\nendsolid");
  EXPECT_EQ(mesh.positions, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  EXPECT_EQ(mesh.corners, (std::vector<Index>{0, 1, 2, 1, 3, 2}));
  EXPECT_EQ(mesh.face_begin, (std::vector<Index>{0, 3, 6}));
}

TEST(Stl, ZerosOfBothSignsAreOnePlace) {
  const Polygons mesh = parse(
      "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 -0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\nfacet normal 0 0 1\nouter loop\nvertex -0 0 0\nvertex 0 1 0\nvertex 1 0 0\n"
      "endloop\nendfacet\nendsolid\n");
  EXPECT_EQ(mesh.vertex_count(), 3);
  for (const Point3& p : mesh.positions)
    for (const double x : {p.x, p.y, p.z}) EXPECT_FALSE(std::signbit(x));
}

/// Each corner of the cube's triangles has zeros of signs of its own.
TEST(Stl, ACubeWithNegativeZerosIsClosed) {
  std::string text = *format_mesh("stl", test::cube());
  for (std::size_t at = 84, k = 0; at + 50 <= text.size(); at += 50) {
    for (std::size_t corner = at + 12; corner < at + 48; corner += 4, ++k)
      if (float_at(text, corner) == 0 && k % 5 > 1) text[corner + 3] = '\x80';
  }
  const Polygons mesh = parse(text);
  EXPECT_EQ(mesh.vertex_count(), 8);
  const Result<Mesh> built = Mesh::build(mesh);
  ASSERT_TRUE(built.ok()) << built.error().text();
  EXPECT_FALSE(built->has_boundary());
}

std::string facet(const char* a, const char* b, const char* c) {
  return std::string(" facet normal 0 0 0\n  outer loop\n   vertex ") + a + "\n   vertex " + b +
         "\n   vertex " + c + "\n  endloop\n endfacet\n";
}

TEST(Stl, EndAndItsWordMayBeApart) {
  const std::string good = "solid t\n" + facet("0 0 0", "0 1 0", "1 0 0") + "endsolid t\n";
  const Polygons plain = parse(good);
  for (const std::string end : {"end solid t\n", "End Solid\n", "END SOLID a name with blanks",
                                "ENDSOLID", "end\nsolid t\n"})
    EXPECT_EQ(parse("solid t\n" + facet("0 0 0", "0 1 0", "1 0 0") + end), plain) << end;
  std::string apart = good;
  apart.replace(apart.find("endloop"), 7, "end loop");
  apart.replace(apart.find("endfacet"), 8, "END Facet");
  EXPECT_EQ(parse(apart), plain);
  EXPECT_FALSE(
      parse_mesh("solid t\n" + facet("0 0 0", "0 1 0", "1 0 0") + "end t\n", "stl", "").ok());
  // Two solids, of which one ends so; that they were two is not kept.
  Warnings warnings;
  EXPECT_EQ(
      parse("solid a b\n" + facet("0 0 0", "0 1 0", "1 0 0") + "end solid a b\nSOLID end solid\n" +
                facet("0 0 0", "1 0 0", "0 0 1") + "endsolid\n",
            &warnings)
          .face_count(),
      2);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].message, "left out: which facets form a solid, 2 solids");
}

TEST(Stl, DegenerateFacetsAreDroppedWithAWordAndFacetsKeepTheirNumbers) {
  const std::string text = "solid\n" + facet("9 9 9", "9 9 9", "8 8 8") +
                           facet("0 0 0", "0 1 0", "1 0 0") + facet("0 0 0", "1 0 0", "-0 0 -0") +
                           facet("0 0 0", "1 0 0", "0 0 1") + "endsolid\n";
  const Result<MeshFile> file = parse_mesh_file(text, "stl", "test.stl");
  ASSERT_TRUE(file.ok());
  EXPECT_EQ(file->polygons.vertex_count(), 4);  // the places of a dropped facet are no vertices
  EXPECT_EQ(file->polygons.corners, (std::vector<Index>{0, 1, 2, 0, 2, 3}));
  ASSERT_EQ(file->warnings.size(), 1u);
  EXPECT_EQ(
      file->warnings[0].text(),
      "test.stl:2: 2 facets dropped: two of their corners are one place (the first is facet 0, "
      "counted from 0)");
  EXPECT_EQ(file->source.file_faces, (std::vector<Index>{1, 3}));
  EXPECT_EQ(file->source.face_lines, (std::vector<int>{2, 9, 16, 23}));
  EXPECT_FALSE(
      parse_mesh("solid\n" + facet("0 0 0", "0 0 0", "1 0 0") + "endsolid\n", "stl", "").ok());
}

TEST(Stl, FacetsOnALineAreDroppedWithAWord) {
  const std::string closed = facet("0 0 0", "0 1 0", "1 0 0") + facet("0 0 0", "1 0 0", "0 0 1") +
                             facet("1 0 0", "0 1 0", "0 0 1") + facet("0 0 0", "0 0 1", "0 1 0");
  // Beside a closed surface: one of places that no other facet has, one along an edge of it.
  for (const std::string& sliver :
       {facet("0 0 0", "0.5 0.5 0", "1 1 0"), facet("0 0 0", "1e-200 0 0", "1 0 0"),
        facet("5 7 9", "3e100 3e100 3e100", "7 9 11")}) {
    const bool on_a_line = sliver.find("e100") == std::string::npos;
    const Result<MeshFile> file =
        parse_mesh_file("solid\n" + closed + sliver + "endsolid\n", "stl", "test.stl");
    ASSERT_TRUE(file.ok());
    EXPECT_EQ(file->polygons.vertex_count(), on_a_line ? 4 : 7) << sliver;
    EXPECT_EQ(file->polygons.face_count(), on_a_line ? 4 : 5);
    ASSERT_EQ(file->warnings.size(), on_a_line ? 1u : 0u);
    if (on_a_line)
      EXPECT_EQ(file->warnings[0].text(),
                "test.stl:30: 1 facet dropped: its corners lie on a line (facet 4, counted from "
                "0)");
  }
  const Result<MeshFile> nothing =
      parse_mesh_file("solid\n" + facet("0 0 0", "1 1 1", "2 2 2") + "endsolid\n", "stl", "");
  ASSERT_FALSE(nothing.ok());
  EXPECT_NE(nothing.error().message.find("no facet are three places off a line"),
            std::string::npos);
}

TEST(Stl, ThinFacetsAreNoLines) {
  for (const std::string& thin :
       {facet("0 0 0", "1e-300 0 0", "1e-300 1e-15 0"), facet("0 0 0", "1 0 0", "1 1e-15 0"),
        facet("0 0 0", "1e300 0 0", "1e300 1e-15 0"), facet("0 1e-300 0", "0 0 0", "1e-300 0 0")})
    EXPECT_EQ(parse("solid\n" + thin + "endsolid\n").face_count(), 1) << thin;
  EXPECT_TRUE(io::lie_on_a_line({0.1, 0.2, 0.3}, {0.2, 0.4, 0.6}, {0.4, 0.8, 1.2}));
  EXPECT_FALSE(io::lie_on_a_line({0.1, 0.2, 0.3}, {0.2, 0.4, 0.6}, {0.3, 0.6, 0.9}));  // rounded
  EXPECT_TRUE(io::lie_on_a_line({1e-310, 0, 0}, {2e-310, 0, 0}, {4e-310, 0, 0}));
}

/// Half-edges without a twin.
int open_edges(const Polygons& polygons) {
  const Result<Mesh> mesh = Mesh::build(polygons);
  EXPECT_TRUE(mesh.ok()) << (mesh.ok() ? "" : mesh.error().text());
  int count = 0;
  for (Index h = 0; mesh.ok() && h < mesh->halfedge_count(); ++h) count += mesh->twin(h) == kNone;
  return count;
}

TEST(Stl, WhereAFacetOnALineClosesTheSurfaceItsNeighbourIsCut) {
  // The edge from 0 to 1 of a tetrahedron is cut at several places on one side only; slivers close
  // the seam, as a fan from 0, or in a chain.
  const std::string others = facet("1 0 0", "0 1 0", "0 0 1") + facet("0 0 0", "0 0 1", "0 1 0") +
                             facet("0 0 0", "1 0 0", "0 0 1");
  const std::string side = facet("0 0 0", "0 1 0", "0.25 0 0") +
                           facet("0.25 0 0", "0 1 0", "0.5 0 0") +
                           facet("0.5 0 0", "0 1 0", "1 0 0");
  const std::string fan =
      facet("0 0 0", "0.25 0 0", "0.5 0 0") + facet("0 0 0", "0.5 0 0", "1 0 0");
  const std::string chain =
      facet("0.25 0 0", "0.5 0 0", "1 0 0") + facet("1 0 0", "0 0 0", "0.25 0 0");
  for (const std::string& slivers : {fan, chain}) {
    const Result<MeshFile> file =
        parse_mesh_file("solid\n" + slivers + side + others + "endsolid\n", "stl", "test.stl");
    ASSERT_TRUE(file.ok());
    EXPECT_EQ(open_edges(file->polygons), 0);
    EXPECT_EQ(file->polygons.vertex_count(), 6);
    EXPECT_EQ(file->polygons.face_count(), 8);
    for (Index f = 0; f < file->polygons.face_count(); ++f) {
      const Index* c = file->polygons.corners.data() + 3 * f;
      const std::vector<Point3>& p = file->polygons.positions;
      EXPECT_FALSE(io::lie_on_a_line(p[c[0]], p[c[1]], p[c[2]])) << f;
    }
    ASSERT_EQ(file->warnings.size(), 1u);
    EXPECT_EQ(file->warnings[0].message,
              "2 facets dropped: their corners lie on a line (the first is facet 0, counted from "
              "0); 2 facets that met the whole line are cut at the corner between, so that no "
              "crack opens");
  }
  // Two slivers that have nothing but each other.
  EXPECT_FALSE(parse_mesh("solid\n" + facet("0 0 0", "1 0 0", "2 0 0") +
                              facet("2 0 0", "1 0 0", "0 0 0") + "endsolid\n",
                          "stl", "")
                   .ok());
}

TEST(Stl, PaddingBehindBinaryDataIsAWarning) {
  const std::string text = *format_mesh("stl", test::cube());
  for (const std::string& padding : {std::string("\n"), std::string(512, '\0')}) {
    Warnings warnings;
    EXPECT_EQ(parse(text + padding, &warnings), parse(text));
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].message.find("padding"), std::string::npos);
  }
  EXPECT_FALSE(parse_mesh(text + "x", "stl", "").ok());
}

TEST(Stl, BinaryWithASolidHead) {
  std::string text = *format_mesh("stl", test::cube());
  EXPECT_NE(text.substr(0, 5), "solid");
  const Polygons mesh = parse(text);
  text.replace(0, 11, "solid model");
  EXPECT_EQ(parse(text), mesh);
  EXPECT_EQ(mesh.vertex_count(), 8);
  EXPECT_EQ(mesh.face_count(), 12);
}

TEST(Stl, WritesFansWithOutwardNormals) {
  const std::string text = *format_mesh("stl", test::cube());
  ASSERT_EQ(text.size(), 84u + 12 * 50);
  const float expected[6][3] = {{0, 0, -1}, {0, 0, 1}, {0, -1, 0},
                                {1, 0, 0},  {0, 1, 0}, {-1, 0, 0}};
  for (std::size_t triangle = 0; triangle < 12; ++triangle) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(float_at(text, 84 + 50 * triangle + 4 * axis), expected[triangle / 2][axis]);
    }
  }
  // The second triangle of the first quad 0 3 2 1 is 0 2 1.
  EXPECT_EQ(float_at(text, 84 + 50 + 12 + 12), 1);
  EXPECT_EQ(float_at(text, 84 + 50 + 12 + 16), 1);
}

TEST(Stl, ManyVerticesAreMergedOnce) {
  // A strip of quads: more vertices than the first table of the merger holds.
  Polygons strip;
  for (int k = 0; k <= 1000; ++k) {
    strip.positions.push_back({double(k), 0, 0});
    strip.positions.push_back({double(k), 1, 0});
  }
  for (Index k = 0; k < 1000; ++k) {
    for (const Index v : {2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1}) strip.corners.push_back(v);
    strip.face_begin.push_back(static_cast<Index>(strip.corners.size()));
  }
  const Polygons mesh = parse(*format_mesh("stl", strip));
  EXPECT_EQ(mesh.vertex_count(), 2002);
  EXPECT_EQ(mesh.face_count(), 2000);
}

}  // namespace
}  // namespace limn
