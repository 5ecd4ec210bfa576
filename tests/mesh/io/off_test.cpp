#include <gtest/gtest.h>

#include "limn/mesh/io/mesh_file.h"
#include "mesh/io/mesh_samples.h"

namespace limn {
namespace {

Polygons parse(std::string_view text, Warnings* warnings = nullptr) {
  Result<Polygons> mesh = parse_mesh(text, "off", "test.off", warnings);
  EXPECT_TRUE(mesh.ok()) << mesh.error().text();
  return mesh.ok() ? *mesh : Polygons{};
}

const std::string kPoints = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

TEST(Off, CountsCommentsAndFaceColours) {
  const Polygons plain = parse("OFF\n4 2 0\n" + kPoints + "3 0 1 2\n3 0 2 3\n");
  EXPECT_EQ(plain.corners, (std::vector<Index>{0, 1, 2, 0, 2, 3}));
  Warnings warnings;
  for (const std::string& text : std::vector<std::string>{
           "OFF 4 2 5\n" + kPoints + "3 0 1 2\n3 0 2 3",       // counts on the first line
           "OFF\n4 2\n" + kPoints + "3 0 1 2\n3 0 2 3\n\n\n",  // no count of edges
           "# a\nOFF # b\n\n4 2 99 # c\n# d\n" + kPoints + "\n3 0 1 2 # e\n3 0 2 3\n# f",
           "OFF\r\n4 2 0\r\n0 0 0\r\n1 0 0\r\n1 1 0\r\n0 1 0\r\n3 0 1 2\r\n3 0 2 3\r\n",
           "OFF\n4 2 0\n" + kPoints + "3 0 1 2 255 0 0\n3 0 2 3 0.5 0.5 0.5 1\n"}) {
    EXPECT_EQ(parse(text, &warnings), plain) << text;
  }
  EXPECT_TRUE(warnings.empty());
}

TEST(Off, VariantsKeepThePositions) {
  const Polygons plain = parse("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  struct Variant {
    const char *head, *extras, *warning;
  };
  const char* texture = "texture coordinates and normals are not refined yet";
  const char* colours = "vertex colours are left out";
  for (const Variant& variant :
       {Variant{"COFF", " 255 0 0 255", colours}, Variant{"NOFF", " 0 0 1", texture},
        Variant{"STOFF", " 0 0", texture},
        Variant{"OFF", " 255 0 0", "numbers behind the coordinates of vertices are left out"}}) {
    const std::string end = std::string(variant.extras) + "\n";
    Warnings warnings;
    EXPECT_EQ(parse(std::string(variant.head) + "\n3 1 0\n0 0 0" + end + "1 0 0" + end + "0 1 0" +
                        end + "3 0 1 2\n",
                    &warnings),
              plain);
    ASSERT_EQ(warnings.size(), 1u) << variant.head;
    EXPECT_EQ(warnings[0].message, variant.warning);
  }
  for (const std::string head : {"STCNOFF", "NCOFF", "CNOFF"}) {
    Warnings warnings;
    EXPECT_EQ(parse(head + "\n3 1 0\n0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n", &warnings), plain);
    EXPECT_EQ(warnings.size(), 2u);
  }
}

}  // namespace
}  // namespace limn
