#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "run_command.h"

namespace limn::test {
namespace {

TEST(PrescribeCommand, WritesASchemeFileThatOtherCommandsRead) {
  const Folder folder;
  const Outcome made =
      folder.limn("prescribe loop --valence 7 --eigenvalues 1/4,1/2,1/4,1/8 -o mine.toml --json");
  ASSERT_EQ(made.code, 0) << made.err;
  const nlohmann::json json = nlohmann::json::parse(made.out);
  EXPECT_NEAR(json.at("valences")[0].at("components").at("tangent"), 1 / 2., 1e-14);
  const Outcome read = folder.limn("eigen mine.toml --valence 7 --json");
  ASSERT_EQ(read.code, 0) << read.err;
  const nlohmann::json seven = nlohmann::json::parse(read.out).at("valences")[0];
  EXPECT_NEAR(seven.at("components").at("saddle"), 1 / 4., 1e-14);
  EXPECT_EQ(seven.at("verdict").at("bounded_curvature"), "yes");
  // and a file of one's own can be built upon
  const Outcome again =
      folder.limn("prescribe mine.toml --valence 5 --eigenvalues 1/4,1/2,1/4 -o next.toml");
  ASSERT_EQ(again.code, 0) << again.err;
}

TEST(PrescribeCommand, RefusesWhatItCannotPrescribe) {
  const Folder folder;
  const auto refused = [&](const std::string& arguments, const std::string& part) {
    expect_refused(folder.limn("prescribe " + arguments), part);
    EXPECT_EQ(folder.count(), 0);
  };

  refused("loop --valence 7 --eigenvalues 1/4 -o x.toml", "frequencies 1 to 3");
  refused("loop --valence 7 --eigenvalues 1/4,1/2,1/4,0.1 -o x.toml", "0.1");
  refused("loop --valence 7 --eigenvalues 1/4,1/2,1/4,1/8 -o x.json", ".toml");
  refused("butterfly --valence 7 --eigenvalues 1/4,1/2,1/4,1/8 -o x.toml", "cannot be prescribed");
  refused("loop --valence x --eigenvalues 1/4,1/2,1/4,1/8 -o x.toml", "--valence");
}

}  // namespace
}  // namespace limn::test
