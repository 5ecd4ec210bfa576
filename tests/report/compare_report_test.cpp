#include "limn/report/compare/compare_report.h"
#include "limn/report/compare/record_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "limn/regular/regular_mask.h"

namespace limn {
namespace {

/// The sides of a cube, as triangles or quads.
Polygons cube(bool triangles) {
  Polygons mesh;
  for (int v = 0; v < 8; ++v)
    mesh.positions.push_back({double(v & 1), double(v >> 1 & 1), double(v >> 2)});
  mesh.corners = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  mesh.face_begin = {0, 4, 8, 12, 16, 20, 24};
  return triangles ? triangulated(mesh) : mesh;
}

report::MeshComparison on_cube(const std::vector<std::string>& names, bool triangles) {
  std::vector<report::LabelledScheme> schemes;
  schemes.reserve(names.size());
  for (const std::string& name : names) schemes.push_back({name, *find_scheme(name)});
  const Polygons polygons = cube(triangles);
  return report::compare_on_mesh(schemes, "cube", *Mesh::build(polygons), polygons.positions,
                                 {.steps = 2, .fairness_levels = 2});
}

/// Without the parts that take their time.
study::RecordOptions quick() {
  study::RecordOptions options{.first_valence = 3, .last_valence = 7};
  options.regularity.budget = 20;
  return options;
}

TEST(CompareRecord, KnowsWhatInterpolates) {
  const auto interpolating = [](const char* name, const char* parameter = nullptr) {
    Scheme scheme = *find_scheme(name);
    if (parameter != nullptr) EXPECT_TRUE(set_parameter(scheme, parameter).ok());
    return interpolates(*regular_mask(scheme));
  };
  for (const char* name : {"butterfly", "butterfly-modified", "interpolating-loop"})
    EXPECT_TRUE(interpolating(name)) << name;
  for (const char* name : {"loop", "sqrt3", "catmull-clark", "doo-sabin", "four-eight"})
    EXPECT_FALSE(interpolating(name)) << name;
  // only its edge rule is blended
  EXPECT_TRUE(interpolating("laplacian-butterfly", "b=1/8"));
  EXPECT_TRUE(interpolating("laplacian-loop", "a=3/8"));  // 1 - 6 beta + a is then 1
  EXPECT_FALSE(interpolating("laplacian-loop", "a=1/8"));
}

/// A wave as long as the sampling density asks for has the artifacts that it allows.
TEST(CompareRecord, ArtifactsAndSamplingDensityAgree) {
  for (const char* name : {"sqrt3", "doo-sabin"}) {
    const ArtifactAnalysis analysis = *ArtifactAnalysis::of(*regular_mask(*find_scheme(name)));
    const study::WaveArtifacts wave = study::wave_artifacts(analysis, 5);
    const auto density = [&](double percent) {
      return *sampling_density(analysis, percent, ArtifactMeasure::total_energy);
    };
    EXPECT_NEAR(density(wave.worst).worst.edges_per_wavelength, 5, 1e-9);
    EXPECT_EQ(density(wave.worst).worst.direction, wave.worst_direction);
    EXPECT_NEAR(density(wave.best).best.edges_per_wavelength, 5, 1e-9);
    EXPECT_EQ(density(wave.best).best.direction, wave.best_direction);
  }
}

TEST(CompareRecord, SaysWhatASchemeLacks) {
  const study::SchemeRecord record =
      study::approx_record("spline", *find_scheme("box-spline-triangle"), quick());
  EXPECT_TRUE(record.artifacts.ok());
  EXPECT_TRUE(record.valences[3].components.ok());  // n = 6
  EXPECT_FALSE(record.valences[4].components.ok());
  ASSERT_EQ(study::missing_parts(record).size(), 1U);
  EXPECT_NE(study::missing_parts(record)[0].find("no vertex rule at n = 3"), std::string::npos);
  const nlohmann::ordered_json json = report::record_json(record);
  EXPECT_EQ(json.at("scheme"), "spline");
  EXPECT_TRUE(json.at("valences")[4].at("components").is_null());
  EXPECT_EQ(json.at("valences")[3].at("components").at("tangent"), .5);
  EXPECT_EQ(json.at("missing").size(), 1U);
}

TEST(CompareOnMesh, MeasuresEveryPair) {
  const report::MeshComparison three = on_cube({"loop", "butterfly-modified", "sqrt3"}, true);
  ASSERT_EQ(three.surfaces.size(), 3U);
  ASSERT_EQ(three.distances.size(), 3U);
  // the butterfly's surface holds the cube's corners; Loop's lies within by its limit stencil
  const mesh::SurfaceDistance& loop = three.distances[0].distance;
  EXPECT_GT(loop.largest, .2);
  EXPECT_GT(loop.diagonal, std::sqrt(3));
  EXPECT_LT(loop.diagonal, 2.5);
  EXPECT_LT(three.distances[1].distance.largest, .05);  // Loop and sqrt3 are alike
  EXPECT_TRUE(three.missing.empty());
  EXPECT_EQ(three.surfaces[0].surface.triangles.size(), 12U * 16U);
  EXPECT_EQ(three.surfaces[2].surface.triangles.size(), 12U * 27U);  // three steps
}

TEST(CompareOnMesh, SkipsSchemesThatDoNotTakeTheMesh) {
  const report::MeshComparison mixed = on_cube({"loop", "catmull-clark", "doo-sabin"}, false);
  ASSERT_EQ(mixed.surfaces.size(), 2U);
  ASSERT_EQ(mixed.distances.size(), 1U);
  EXPECT_EQ(mixed.surfaces[mixed.distances[0].first].name, "catmull-clark");
  ASSERT_EQ(mixed.fairness.size(), 3U);
  EXPECT_FALSE(mixed.fairness[0].ok());
  EXPECT_TRUE(mixed.fairness[1].ok());
  ASSERT_EQ(mixed.missing.size(), 1U);
  EXPECT_EQ(mixed.missing[0].substr(0, 6), "loop: ");
}

/// Loop's C2 is proved, so that its list goes on to C3; butterfly's ends with C2, which is refuted.
TEST(CompareReport, ListsSmoothnessAsFarAsAnySchemeHasIt) {
  report::Comparison comparison;
  for (const char* name : {"loop", "butterfly"})
    comparison.schemes.push_back(study::approx_record(name, *find_scheme(name), quick()));
  ASSERT_EQ(comparison.schemes[0].regularity->smoothness.size(), 4U);
  ASSERT_EQ(comparison.schemes[1].regularity->smoothness.size(), 3U);
  const std::string text = report::compare_text(comparison);
  const std::size_t at = text.find("\n  C3 ");
  ASSERT_NE(at, std::string::npos) << text;
  const std::string line = text.substr(at + 1, text.find('\n', at + 1) - at - 1);
  EXPECT_EQ(line.find("yes"), std::string::npos) << line;
  EXPECT_NE(line.rfind("no"), line.find("no")) << line;  // of both
  EXPECT_EQ(text.find("\n  C4 "), std::string::npos);
}

TEST(CompareReport, HasAColumnForEachAndWhatIsMissing) {
  report::Comparison comparison;
  for (const char* name : {"loop", "box-spline-triangle", "doo-sabin"})
    comparison.schemes.push_back(study::approx_record(name, *find_scheme(name), quick()));
  comparison.on_mesh = on_cube({"loop", "box-spline-triangle", "doo-sabin"}, true);
  const std::string text = report::compare_text(comparison);
  for (const char* part :
       {"Hölder exponent", "8 edges long, worst direction", "n = 7 ", "thin plate",
        "loop – doo-sabin: largest 0.", "no vertex rule at n = 3", "* the best of its line"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  EXPECT_NE(text.find("interpolating"), std::string::npos);
  EXPECT_EQ(report::compare_text(comparison, true).find("interpolating"), std::string::npos);
  const nlohmann::ordered_json json = report::compare_json(comparison);
  EXPECT_EQ(json.at("mesh"), "cube");
  EXPECT_EQ(json.at("distances").size(), 1U);
  EXPECT_TRUE(json.at("schemes")[1].at("fairness").is_null());
  EXPECT_FALSE(json.at("schemes")[0].at("fairness").is_null());
}

}  // namespace
}  // namespace limn
