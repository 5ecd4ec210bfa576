/// "-" for standard input and output, and --quiet.

#include <gtest/gtest.h>

#include "limn/mesh/io/mesh_file.h"
#include "run_command.h"

namespace limn::test {
namespace {

const std::string kBracket = "'" LIMN_EXAMPLES "/bracket.obj'";

TEST(Streams, AMeshComesAndGoesInEveryFormat) {
  const Folder folder;
  ASSERT_EQ(folder.limn("refine " + kBracket + " -s loop -n 1 -o expected.obj").code, 0);
  for (const std::string format : {"obj", "off", "ply"}) {
    ASSERT_EQ(folder.limn("refine " + kBracket + " -s loop -n 0 -o in." + format).code, 0);
    const Outcome outcome = folder.shell("\"$LIMN\" refine - -s loop -n 1 -o - <in." + format);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, folder.read("expected.obj")) << format;
    EXPECT_NE(outcome.err.find("vertices"), std::string::npos);  // the report
  }
  for (const std::string format : {"obj", "off", "ply", "stl", "glb"}) {
    ASSERT_EQ(folder.limn("refine " + kBracket + " -s loop -n 1 -o a." + format).code, 0);
    const Outcome outcome =
        folder.limn("refine " + kBracket + " -s loop -n 1 -o - --format " + format);
    EXPECT_EQ(outcome.out, folder.read("a." + format)) << format;
  }
  EXPECT_EQ(folder
                .shell("\"$LIMN\" refine - -s loop -n 1 -o - <in.off | "
                       "\"$LIMN\" refine - -s loop -n 0 -o two.obj")
                .code,
            0);
  EXPECT_EQ(folder.read("two.obj"), folder.read("expected.obj"));
}

TEST(Streams, AFigureGoesInEveryFormat) {
  const Folder folder;
  const std::string draw = "draw " + kBracket + " -s loop -n 1 -o ";
  if (folder.limn(draw + "a.pdf").code == 2) GTEST_SKIP() << "built without cairo";
  for (const std::string format : {"pdf", "svg", "png"}) {
    ASSERT_EQ(folder.limn(draw + "a." + format).code, 0);
    const Outcome outcome = folder.limn(draw + "- --format " + format);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, folder.read("a." + format)) << format;
    EXPECT_NE(outcome.err.find("the limit surface of loop"), std::string::npos);  // the report
    ASSERT_EQ(folder.limn(draw + "noext --format " + format).code, 0);
    EXPECT_EQ(folder.read("noext"), outcome.out);
  }
  EXPECT_EQ(folder.limn(draw + "-").out, folder.read("a.pdf"));
  EXPECT_EQ(folder.limn("--quiet " + draw + "-").err, "");
  expect_refused(folder.limn(draw + "- --json"), {"figure", "JSON", "standard output"});
  expect_refused(folder.limn(draw + "a.svg --format gif"), {"--format"});
}

TEST(Streams, ASchemeComesOnStandardInput) {
  const Folder folder;
  const std::string scheme = " <'" LIMN_SCHEMES "/loop.toml'";
  EXPECT_EQ(folder.shell("\"$LIMN\" refine " + kBracket + " -s - -n 1 -o a.obj" + scheme).code, 0);
  ASSERT_EQ(folder.limn("refine " + kBracket + " -s loop -n 1 -o b.obj").code, 0);
  EXPECT_EQ(folder.read("a.obj"), folder.read("b.obj"));
  EXPECT_EQ(folder.shell("\"$LIMN\" eigen - --valence 5" + scheme).out,
            folder.limn("eigen loop --valence 5").out);
  expect_refused(folder.shell("echo 'split = 3' | \"$LIMN\" show -"), {"standard input:1:9"});
  expect_refused(folder.shell("head -c 2000000 /dev/zero | \"$LIMN\" show -"), {"256 KiB"});
  expect_refused(folder.shell("\"$LIMN\" show - <&-"), {"standard input"});
}

TEST(Streams, AreNotUsedTwice) {
  const Folder folder;
  expect_refused(
      folder.shell("\"$LIMN\" refine - -s - -n 1 -o a.obj <'" LIMN_SCHEMES "/loop.toml'"),
      {"standard input", "twice"});
  expect_refused(folder.limn("refine " + kBracket + " -s loop -o - --json"),
                 {"standard output", "--json"});
  expect_refused(folder.limn("refine - -s loop -o a.obj"), {"standard input: "});
  EXPECT_EQ(folder.count(), 0);
}

TEST(Streams, AFileMayBeCalledByADash) {
  const Folder folder;
  EXPECT_EQ(folder.limn("refine " + kBracket + " -s loop -n 1 -o ./- --format off").code, 0);
  EXPECT_EQ(folder.read("-").substr(0, 3), "OFF");
}

TEST(Streams, QuietLeavesErrorsAlone) {
  const Folder folder;
  folder.write("uv.obj",
               "v 1 1 1\nv -1 -1 1\nv -1 1 -1\nv 1 -1 -1\nvn 0 0 1\nf 1 2 4\nf 3 2 1\n"
               "f 1 4 3\nf 2 3 4\n");
  const std::string job = "refine uv.obj -s loop -n 1 -o a.obj";
  EXPECT_NE(folder.limn(job).err, "");
  const Outcome quiet = folder.limn(job + " --quiet");
  EXPECT_EQ(quiet.code, 0);
  EXPECT_EQ(quiet.err, "");
  EXPECT_NE(quiet.out, "");
  EXPECT_EQ(folder.limn("--quiet refine uv.obj -s loop -n 1 -o -").err, "");
  expect_refused(folder.limn("refine none.obj -s loop -n 1 -o a.obj --quiet"), {"none.obj"});
}

TEST(Streams, CoordinatesThatAFormatCannotHoldAreNamed) {
  const Folder folder;
  const std::string faces = "f 1 2 4\nf 3 2 1\nf 1 4 3\nf 2 3 4\n";
  folder.write("large.obj", "v 1e39 1 1\nv -1 -1 1\nv -1 1 -1\nv 1 -1 -1\n" + faces);
  for (const std::string format : {"stl", "glb"})
    expect_refused(folder.limn("refine large.obj -s loop -n 0 -o a." + format),
                   {"vertex 0", "x = 1e+39", format + " holds floats", "obj"});
  // sums of a few coordinates may be infinite, but numbers that the refinement itself brings beyond
  // all bounds are the mesh's fault
  const std::string huge = "1.797e308";
  folder.write("huge.obj", "v " + huge + " 1 1\nv -" + huge + " -1 1\nv -1 " + huge + " -1\nv " +
                               huge + " -1 -1\n" + faces);
  EXPECT_EQ(folder.limn("refine huge.obj -s butterfly -n 3 -o huge.ply").code, 0);
  folder.write("more.obj", "v " + huge + " 1 1\nv " + huge + " -1 1\nv -" + huge + " 1 -1\nv " +
                               huge + " -1 -1\n" + faces);
  const Outcome beyond = folder.limn("refine more.obj -s butterfly -n 3 -o more.ply");
  expect_refused(beyond, {"more.obj: ", "inf", "scale"});
  for (const std::string format : {"obj", "off", "ply"})
    EXPECT_EQ(folder.limn("refine large.obj -s loop -n 0 -o a." + format).code, 0) << format;
}

}  // namespace
}  // namespace limn::test
