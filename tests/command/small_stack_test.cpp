/// What docs/architecture.md promises: 256 KiB of stack suffice for whatever limn does.
#include <string>

#include <gtest/gtest.h>

#include "command/run_command.h"
#include "support/sanitized.h"

namespace limn::test {
namespace {

const std::string kBracket = " '" LIMN_EXAMPLES "/bracket.obj' ";
const std::string kQuads = " '" LIMN_EXAMPLES "/bracket-quads.obj' ";

std::string repeated(const std::string& text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) result += text;
  return result;
}

class SmallStack : public ::testing::TestWithParam<std::string> {};

TEST_P(SmallStack, Suffices) {
  const Folder folder;
  const Outcome outcome = folder.limn(GetParam(), stack_of(256));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
}

INSTANTIATE_TEST_SUITE_P(
    Commands, SmallStack,
    ::testing::Values("show loop --latex", "eigen loop --valence 3..8",
                      "eigen catmull-clark --formulas", "eigen doo-sabin --map e.pdf --valence 5",
                      "artifacts loop --map m.pdf", "artifacts sqrt3 --tolerance 1",
                      "regularity butterfly --json", "regularity sqrt3",
                      "tune sqrt3 --free alpha --require 'cup = tangent^2' --valence 3..5",
                      "prescribe loop --valence 7 --eigenvalues 1/4,1/2,1/4,1/8 -o seven.toml",
                      "refine" + kBracket +
                          "-s loop -n 3 --limit --normals --curvatures k.csv -o x.ply",
                      "refine" + kQuads + "-s doo-sabin -n 2 --engine plain --limit -o x.obj",
                      "fairness" + kBracket + "-s loop -s butterfly",
                      "compare loop optimal --valence 4..6 --mesh" + kBracket + "-o c.pdf"));

TEST(SmallStackTest, NestedInputIsRefusedBeforeItRunsOut) {
  const Folder folder;
  for (const char* opening : {"(", "sqrt(", "1-(", "1/(", "cos("}) {
    const std::string nested = repeated(opening, 2000) + "1" + repeated(")", 2000);
    expect_refused(
        folder.limn("show laplacian-loop -p 'a=" + nested.substr(0, 3000) + "'", stack_of(256)),
        "nested too deeply");
  }
  folder.write("deep.toml", "split = \"triangle-dyadic\"\nx = " + repeated("[", 5000));
  expect_refused(folder.limn("show deep.toml", stack_of(256)), "depth");
}

}  // namespace
}  // namespace limn::test
