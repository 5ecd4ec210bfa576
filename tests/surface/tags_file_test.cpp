#include "limn/surface/tags_file.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

std::string fault(const std::string& text) {
  const Result<SharpnessTags> tags = surface::parse_tags(text, "t.toml", 1);
  return tags ? "" : tags.error().text();
}

TEST(TagsFile, IsReadByTheNumbersOfTheMeshFile) {
  const SharpnessTags tags = surface::parse_tags(
                                 "boundary = \"edgeAndCorner\"\ncreases = \"chaikin\"\n"
                                 "[[crease]]\nvertices = [1, 2, 3]\nsharpness = 2.5\n"
                                 "[[crease]]\nvertices = [4, 5, 6]\nsharpness = [1, \"infinite\"]\n"
                                 "[[corner]]\nvertices = [7, 8]\nsharpness = \"infinite\"\n"
                                 "[[hole]]\nfaces = [1]\n",
                                 "t.toml", 1)
                                 .value();
  EXPECT_EQ(tags.boundary, BoundaryMode::edge_and_corner);
  EXPECT_EQ(tags.method, CreaseMethod::chaikin);
  ASSERT_EQ(tags.creases.size(), 2U);
  EXPECT_EQ(tags.creases[0].vertices, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(tags.creases[0].sharpness, std::vector<double>{2.5});
  EXPECT_EQ(tags.creases[0].line, 3);
  EXPECT_EQ(tags.creases[1].sharpness, (std::vector<double>{1, 10}));
  ASSERT_EQ(tags.corners.size(), 2U);
  EXPECT_EQ(tags.corners[1].vertex, 7);
  EXPECT_EQ(tags.corners[1].sharpness, 10);
  ASSERT_EQ(tags.holes.size(), 1U);
  EXPECT_EQ(tags.holes[0].face, 0);
  EXPECT_EQ(tags.first, 1);
}

TEST(TagsFile, WithFaultsIsRefusedWithTheirPlace) {
  EXPECT_NE(fault("[[crease]]\nvertices = [0, 1]\nsharpness = 1\n")
                .find("t.toml:2:13: expected a number of the mesh file's vertices, 1 or more"),
            std::string::npos);
  EXPECT_NE(fault("[[crease]]\nvertices = [1, 2]\nsharpness = -1\n")
                .find("t.toml:3:13: expected a "
                      "sharpness"),
            std::string::npos);
  EXPECT_NE(fault("[[crease]]\nvertices = [1, 2, 3]\nsharpness = [1, 2, 3]\n").find("a list of 2"),
            std::string::npos);
  EXPECT_NE(fault("[[crease]]\nvertices = [1]\nsharpness = 1\n").find("2 or more"),
            std::string::npos);
  EXPECT_NE(fault("[[corner]]\nvertices = [1]\n").find("needs a sharpness"), std::string::npos);
  EXPECT_NE(fault("boundary = \"edge\"\n").find("none, edgeOnly, edgeAndCorner"),
            std::string::npos);
  EXPECT_NE(fault("[[creases]]\nvertices = [1]\n"), "");
  EXPECT_NE(fault("[[crease]\n"), "");
}

}  // namespace
}  // namespace limn
