/// Finding schemes by name and path, files that extend others, and setting parameters.

#include <gtest/gtest.h>

#include <filesystem>

#include "limn/base/files/file.h"
#include "limn/mesh/lattice.h"
#include "scheme/refined.h"
#include "support/temporary_folder.h"

namespace limn {
namespace {

std::string error_of(const std::string& name_or_path) {
  const Result<Scheme> scheme = find_scheme(name_or_path);
  return scheme.ok() ? "found" : scheme.error().text();
}

TEST(FindScheme, EveryShippedFileByNameAndByPath) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(LIMN_SCHEMES))
    files.push_back(entry.path().stem().string());
  std::sort(files.begin(), files.end());
  EXPECT_EQ(shipped_schemes(), files);
  for (const std::string& name : files) {
    const Result<Scheme> shipped = find_scheme(name);
    ASSERT_TRUE(shipped.ok()) << shipped.error().text();
    EXPECT_EQ(shipped->name, name);
    const Result<Scheme> read = find_scheme(std::string(LIMN_SCHEMES) + "/" + name + ".toml");
    ASSERT_TRUE(read.ok()) << read.error().text();
    EXPECT_EQ(read->name, name);
  }
}

TEST(FindScheme, Suggestions) {
  EXPECT_EQ(error_of("lop"), "no shipped scheme and no file is called 'lop' (did you mean loop?)");
  EXPECT_NE(error_of("looop").find("did you mean loop?"), std::string::npos);
  EXPECT_NE(error_of("butterfy").find("did you mean butterfly?"), std::string::npos);
  EXPECT_NE(error_of("catmul-clark").find("did you mean catmull-clark?"), std::string::npos);
  EXPECT_NE(error_of("modified").find("did you mean butterfly-modified?"), std::string::npos);
  EXPECT_NE(error_of("zzzzzzzz").find("`limn schemes` lists"), std::string::npos);
  EXPECT_NE(error_of("").find("`limn schemes` lists"), std::string::npos);
  EXPECT_NE(error_of("folder/loop").find("No such file"), std::string::npos);
  EXPECT_NE(error_of("lop.toml").find("No such file"), std::string::npos);
}

class Extending : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) {
    const std::string path = folder_ / name;
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    EXPECT_TRUE(base::write_file(path, text).ok());
    return path;
  }
  test::TemporaryFolder folder_;
};

const std::string kBase =
    "split = \"triangle-dyadic\"\n[let]\nc = \"1/8\"\n[parameter.b]\ndefault = \"3/8\"\n"
    "[vertex]\nself = \"1 - b\"\nring = \"b/n\"\n[edge]\nend = \"1/2 - c\"\nwing = \"c\"\n";

TEST_F(Extending, RelativeToTheFile) {
  write("base/one.toml", kBase);
  write("two.toml", "extends = \"base/one.toml\"\n[let]\nc = \"1/6\"\n");
  const std::string three = write("deep/three.toml", "extends = \"../two.toml\"\n");
  const Result<Scheme> scheme = read_scheme(three);
  ASSERT_TRUE(scheme.ok()) << scheme.error().text();
  EXPECT_EQ(scheme->name, "three");
  test::expect_same_refinement(
      *scheme,
      test::must_parse("split = \"triangle-dyadic\"\n[vertex]\nself = \"5/8\"\nring = \"3/8/n\"\n"
                       "[edge]\nend = \"1/3\"\nwing = \"1/6\"\n"),
      mesh::torus(Lattice::triangle, 4, 5), 2);
}

TEST_F(Extending, ALetTakesThePlaceOfAParameter) {
  write("one.toml", kBase);
  Result<Scheme> scheme =
      read_scheme(write("two.toml", "extends = \"one.toml\"\nlet.b = \"9/16\"\n"));
  ASSERT_TRUE(scheme.ok()) << scheme.error().text();
  EXPECT_TRUE(scheme->parameters.empty());
}

TEST_F(Extending, AFaultThatTheExtensionMakes) {
  write("one.toml", kBase);
  const std::string path = write("two.toml", "extends = \"one.toml\"\nlet.c = \"1/(n - n)\"\n");
  const Result<Scheme> scheme = read_scheme(path);
  ASSERT_FALSE(scheme.ok());
  EXPECT_EQ(scheme.error().file, path) << scheme.error().text();
  EXPECT_NE(scheme.error().message.find("n has no value here"), std::string::npos);
}

TEST_F(Extending, AFileMayBeCalledLikeTheSchemeItExtends) {
  const Result<Scheme> scheme = read_scheme(write("loop.toml", "extends = \"loop\"\n"));
  EXPECT_TRUE(scheme.ok());
}

TEST_F(Extending, LongChains) {
  write("0.toml", kBase);
  const auto link = [&](int i) {
    return write(std::to_string(i) + ".toml", "extends = \"" + std::to_string(i - 1) + ".toml\"\n");
  };
  std::string last;
  for (int i = 1; i <= 7; ++i) last = link(i);
  EXPECT_TRUE(read_scheme(last).ok());
  for (int i = 8; i <= 12; ++i) last = link(i);
  const Result<Scheme> scheme = read_scheme(last);
  ASSERT_FALSE(scheme.ok());
  EXPECT_NE(scheme.error().message.find("more than 8 schemes extend one another"),
            std::string::npos)
      << scheme.error().text();
}

// ---------------------------------------------------------------------------------------------

/// What refining a star gives, as a fingerprint of a scheme's weights.
std::vector<double> fingerprint(const Scheme& scheme) {
  return test::refined(scheme, mesh::star(Lattice::triangle, 5, 2), 2).value().values;
}

TEST(SetParameter, ExpressionsInNAndLets) {
  Scheme scheme = find_scheme("laplacian-loop").value();
  EXPECT_TRUE(set_parameter(scheme, "a=0").ok());
  EXPECT_EQ(fingerprint(scheme), fingerprint(find_scheme("loop").value()));
  for (const char* good : {"a=1/8", " a = -1/8 ", "a=1/n - lambda/2", "a=n*beta - 1/2",
                           "a=(n == 6)/8", "a=cos(pi/n)/4"}) {
    const Status status = set_parameter(scheme, good);
    EXPECT_TRUE(status.ok()) << good << ": " << status.error().text();
  }
}

struct Faulty {
  const char* assignment;
  const char* message;
};

TEST(SetParameter, AFailureLeavesTheSchemeUnchanged) {
  const Faulty faulty[] = {
      {"a", "'a' sets no parameter"},
      {"", "'' sets no parameter"},
      {"b=1", "scheme 'laplacian-loop' has no parameter 'b'"},
      {"=1", "scheme 'laplacian-loop' has no parameter ''"},
      {"beta=1", "has no parameter 'beta'"},
      {"a=", "-p a=: column 3: found the end, expected a number"},
      {"a=1/", "-p a=1/: column 5: found the end"},
      {"a=0.125", "-p a=0.125: column 3: a decimal stands for a fraction here"},
      {"a==1", "-p a==1: column 3: found '=1', expected a number"},
      {"a=foo", "-p a=foo: unknown name 'foo'"},
      {"a=a + 1", "-p a=a + 1: 'a' is defined in terms of itself"},
      {"a=2", "-p a=2: parameter a = 2 is above its range [-1, 1] at n = 3"},
      {"a=-2", "is below its range"},
      {"a=1/(n - 9)", "-p a=1/(n - 9): division by zero"},
      {"a=n/8", "is above its range [-1, 1] at n = 9"},
      {"a=k/n", "k has no value here"},
      {"a=cos(1)", "is not a rational multiple of pi"},
      {"a=pi", "pi"},
  };
  Scheme scheme = find_scheme("laplacian-loop").value();
  ASSERT_TRUE(set_parameter(scheme, "a=1/8").ok());
  const std::vector<double> before = fingerprint(scheme);
  for (const Faulty& f : faulty) {
    const Status status = set_parameter(scheme, f.assignment);
    ASSERT_FALSE(status.ok()) << f.assignment;
    EXPECT_NE(status.error().message.find(f.message), std::string::npos) << status.error().text();
    EXPECT_EQ(scheme.parameters[0].value.expression.text(), "1/8") << f.assignment;
    EXPECT_EQ(fingerprint(scheme), before) << f.assignment;
  }
}

TEST(SetParameter, OfFactorsMakesTheRulesAnew) {
  Scheme scheme = find_scheme("box-spline-quad").value();
  const Mesh mesh = mesh::torus(Lattice::quad, 6, 6);
  const std::vector<double> bicubic = test::refined(scheme, mesh)->values;
  EXPECT_FALSE(set_parameter(scheme, "i=3").ok());  // then the centre fits no primal split
  EXPECT_EQ(test::refined(scheme, mesh)->values, bicubic);
  EXPECT_FALSE(set_parameter(scheme, "i=17").ok());
  EXPECT_FALSE(set_parameter(scheme, "i=1/2").ok());
  ASSERT_TRUE(set_parameter(scheme, "i=2").ok());  // no symmetry, no rules
  EXPECT_FALSE(test::refined(scheme, mesh).ok());
  ASSERT_TRUE(set_parameter(scheme, "j=2").ok());  // bilinear
  const Result<refine::Refined<double>> linear = test::refined(scheme, mesh);
  ASSERT_TRUE(linear.ok());
  const std::vector<double> old = test::random_values(mesh);
  for (Index v = 0; v < mesh.vertex_count(); ++v) EXPECT_NEAR(linear->values[v], old[v], 1e-15);
}

TEST(SetParameter, SeveralAtOnce) {
  Scheme scheme = find_scheme("box-spline-triangle").value();
  const Mesh mesh = mesh::torus(Lattice::triangle, 6, 6);
  EXPECT_FALSE(set_parameter(scheme, "i=1").ok());  // one by one the centre does not fit
  ASSERT_TRUE(set_parameters(scheme, {"i=1", "j=1", "k3=1"}).ok());
  const std::vector<double> linear = test::refined(scheme, mesh)->values;
  const Status status = set_parameters(scheme, {"i=2", "j=2", "k3=1/2"});
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.error().message.find("-p i=2 -p j=2 -p k3=1/2: "), std::string::npos);
  EXPECT_EQ(test::refined(scheme, mesh)->values, linear);
  EXPECT_TRUE(set_parameters(scheme, {}).ok());
}

TEST(SetParameter, NamesTheParametersThatThereAre) {
  Scheme scheme = find_scheme("loop").value();
  EXPECT_EQ(set_parameter(scheme, "w=1").error().hint, "it has no parameters");
  scheme = find_scheme("box-spline-quad").value();
  EXPECT_EQ(set_parameter(scheme, "w=1").error().hint, "it has i, j, p, q");
}

}  // namespace
}  // namespace limn
