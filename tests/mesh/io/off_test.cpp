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
           "OFF\n4 2 0\n" + kPoints + "3 0 1 2\n3 0 2 3\n\0\0"}) {
    EXPECT_EQ(parse(text, &warnings), plain) << text;
  }
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(parse("OFF\n4 2 0\n" + kPoints + "3 0 1 2 255 0 0\n3 0 2 3 0.5 0.5 0.5 1\n", &warnings),
            plain);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].text(), "test.off:7:9: left out: face colours, 2 faces");
}

TEST(Off, KeywordGluedInLowerCaseOrMissing) {
  const std::string rest = "\n" + kPoints + "3 0 1 2\n3 0 2 3\n";
  const Polygons plain = parse("OFF\n4 2 0" + rest);
  for (const std::string head : {"OFF4 2 0", "OFF4 2", "off\n4 2 0", "off 4 2 0", "off4 2 0",
                                 "Off\n4 2 0", "4 2 0", "4 2", "# a comment\n4 2 0"}) {
    Warnings warnings;
    EXPECT_EQ(parse(head + rest, &warnings), plain) << head;
    EXPECT_TRUE(warnings.empty()) << head;
    EXPECT_EQ(format_of_content(head + rest).value(), "off") << head;
  }
  for (const std::string head : {"COFF4 2 0", "coff\n4 2 0", "noff 4 2 0", "STOFF4 2 0"}) {
    EXPECT_EQ(parse(head + rest), plain) << head;
    EXPECT_EQ(format_of_content(head + rest).value(), "off") << head;
  }
  for (const std::string head : {"nOFF\n3\n4 2 0", "4OFF\n4 2 0", "4OFF4 2 0", "OFFSET\n4 2 0",
                                 "OFF BINARY\n4 2 0", "OFFx4 2 0"})
    EXPECT_FALSE(parse_mesh(head + rest, "off", "").ok()) << head;
}

TEST(Off, SeveralOnALineAreReadNumberByNumberWithAWord) {
  const Polygons plain = parse("OFF\n4 2 0\n" + kPoints + "3 0 1 2\n3 0 2 3\n");
  for (const std::string text : {"OFF\n4 2 0\n0 0 0 1 0 0\n1 1 0 0 1 0\n3 0 1 2 3 0 2 3\n",
                                 "OFF\n4 2 0\n0 0\n0 1 0 0\n1 1 0 0 1 0 3 0 1\n2 3 0 2 3",
                                 "OFF\n4\n2\n0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n",
                                 "OFF\n4 2\n0 0 0 1 0 0\n1 1 0 0 1 0\n3 0 1 2 3 0 2 3\n",
                                 "4 2 0 0 0 0 1 0 0 1 1 0 0 1 0 3 0 1 2 3 0 2 3"}) {
    Warnings warnings;
    EXPECT_EQ(parse(text, &warnings), plain) << text;
    ASSERT_EQ(warnings.size(), 1u) << text;
    EXPECT_NE(warnings[0].message.find("number by number"), std::string::npos);
  }
}

TEST(Off, VariantsKeepThePositions) {
  const Polygons plain = parse("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  struct Variant {
    const char *head, *extras, *warning;
  };
  for (const Variant& variant :
       {Variant{"COFF", " 255 0 0 255", "left out: vertex colours, 3 vertices"},
        Variant{"NOFF", " 0 0 1", "left out: normals, 3 vertices"},
        Variant{"STOFF", " 0 0", "left out: texture coordinates, 3 vertices"},
        Variant{"OFF", " 255 0 0", "left out: numbers behind the coordinates, 3 vertices"}}) {
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
    EXPECT_EQ(warnings.size(), head[0] == 'S' ? 3u : 2u) << head;
  }
}

TEST(Off, BinaryIsCalledThatInAnyCase) {
  for (const std::string head : {"OFF BINARY\n", "off binary\n", "COFF Binary\n"}) {
    const Result<Polygons> mesh = parse_mesh(head + std::string(40, '\0'), "off", "");
    ASSERT_FALSE(mesh.ok());
    EXPECT_EQ(mesh.error().message, "binary OFF is not read");
  }
}

}  // namespace
}  // namespace limn
