#include "limn/report/eigen/eigenvector_report.h"

#include <cmath>
#include <optional>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace limn::report {
namespace {

using Json = nlohmann::ordered_json;

struct Shape {
  const char* name;
  Eigenvalue eigenvalue;
};

/// The labelled eigenvalues that the valence has.
std::vector<Shape> shapes(const Eigencomponents& components) {
  std::vector<Shape> list{{"position", components.spectra[0].eigenvalues[0]}};
  if (components.tangent) list.push_back({"tangent", components.spectra[1].eigenvalues[0]});
  if (components.cup) list.push_back({"cup", components.spectra[0].eigenvalues[1]});
  if (components.saddle) list.push_back({"saddle", components.spectra[2].eigenvalues[0]});
  return list;
}

double rounded(double x) { return std::abs(x) < 1e-15 ? 0.0 : x; }

Json vector_json(const Eigen::VectorXcd& vector) {
  Json list = Json::array();
  for (const std::complex<double> x : vector) {
    if (std::abs(x.imag()) < 1e-15)
      list.push_back(rounded(x.real()));
    else
      list.push_back({rounded(x.real()), rounded(x.imag())});
  }
  return list;
}

Json vectors_json(const FrequencyBlocks& blocks, const Eigenvalue& eigenvalue) {
  const Eigenvectors vectors = approx_eigenvectors(blocks, eigenvalue);
  Json right = Json::array();
  Json left = Json::array();
  for (Eigen::Index i = 0; i < vectors.right.cols(); ++i)
    right.push_back(vector_json(vectors.right.col(i)));
  for (Eigen::Index i = 0; i < vectors.left.rows(); ++i)
    left.push_back(vector_json(vectors.left.row(i).transpose()));
  return {{"value", {eigenvalue.value.real(), eigenvalue.value.imag()}},
          {"right", std::move(right)},
          {"left", std::move(left)}};
}

Json spatial_json(const FrequencyBlocks& blocks, const Eigenvalue& eigenvalue) {
  const Eigenvectors vectors = approx_eigenvectors(blocks, eigenvalue);
  const auto values = spatial_vectors(blocks, eigenvalue.frequency, vectors.right.col(0));
  const auto weights = spatial_functionals(blocks, eigenvalue.frequency, vectors.left.row(0));
  const bool alone = eigenvalue.frequency == 0 || 2 * eigenvalue.frequency == blocks.valence;
  Json json{{"right", {values[0]}}, {"left", {weights[0]}}};
  if (alone) return json;
  // of X e^{iωθ} the second is the sine, which weighs with -Im
  std::vector<double> second = weights[1];
  for (double& weight : second) weight = rounded(-weight);
  json["right"].push_back(values[1]);
  json["left"].push_back(std::move(second));
  return json;
}

std::string amplitude_text(std::complex<double> x) {
  if (std::abs(x.imag()) < 1e-12) return fmt::format("{:10.6f}", rounded(x.real()));
  return fmt::format("{:.4f}{:+.4f}i", x.real(), x.imag());
}

}  // namespace

void add_vectors_json(const FrequencyBlocks& blocks, const Eigencomponents& components,
                      nlohmann::ordered_json& json) {
  Json orbits = Json::array();
  for (const Orbit& orbit : blocks.orbits)
    orbits.push_back({{"ring", orbit.ring}, {"angle", orbit.angle}});
  json["orbits"] = std::move(orbits);
  for (std::size_t i = 0; i < components.spectra.size(); ++i) {
    Json list = Json::array();
    const std::vector<Eigenvalue>& values = components.spectra[i].eigenvalues;
    for (std::size_t k = 0; k < values.size(); ++k)
      if (k == 0 || std::abs(values[k].value - values[k - 1].value) > kEqualBelow)
        list.push_back(vectors_json(blocks, values[k]));
    json["blocks"][i]["vectors"] = std::move(list);
  }
  Json spatial;
  for (const Shape& shape : shapes(components))
    spatial[shape.name] = spatial_json(blocks, shape.eigenvalue);
  json["spatial"] = std::move(spatial);
}

std::string vectors_text(const FrequencyBlocks& blocks, const Eigencomponents& components) {
  const std::vector<Shape> list = shapes(components);
  std::vector<Eigenvectors> vectors;
  std::string text = fmt::format("{:>11}{:>8} ", "ring", "angle");
  for (const Shape& shape : list) {
    vectors.push_back(approx_eigenvectors(blocks, shape.eigenvalue));
    text += fmt::format("  {:>21}", shape.name);
  }
  text += fmt::format("\n{:>20}", "");
  for (std::size_t i = 0; i < list.size(); ++i)
    text += fmt::format("  {:>10} {:>10}", "vector", "stencil");
  text += '\n';
  const int center = blocks.has_center ? 1 : 0;
  for (int row = 0; row < static_cast<int>(blocks.orbits.size()) + center; ++row) {
    if (row < center) {
      text += fmt::format("{:>11}{:>8} ", "centre", "");
    } else {
      const Orbit& orbit = blocks.orbits[static_cast<std::size_t>(row - center)];
      text += fmt::format("{:>11}{:>8.4g} ", orbit.ring, orbit.angle);
    }
    for (const Eigenvectors& one : vectors) {
      const int lost = one.frequency > 0 ? center : 0;
      if (row < lost)
        text += fmt::format("  {:>10} {:>10}", "", "");
      else
        text += fmt::format("  {:>10} {:>10}", amplitude_text(one.right(row - lost, 0)),
                            amplitude_text(one.left(0, row - lost)));
    }
    text += '\n';
  }
  return text;
}

}  // namespace limn::report
