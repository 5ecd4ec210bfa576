#include "limn/report/eigen/faces_report.h"

#include <cmath>
#include <vector>

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace limn::report {
namespace {

using Json = nlohmann::ordered_json;

std::vector<int> corners_of(const mesh::Sectors& sectors) {
  std::vector<int> corners;
  for (const Lattice lattice : sectors.lattices)
    corners.push_back(lattice == Lattice::triangle ? 3 : 4);
  return corners;
}

constexpr double kReal = 1e-10;

std::string value_text(std::complex<double> value) {
  if (std::abs(value.imag()) < kReal) return fmt::format("{:9.6f}", value.real());
  return fmt::format("{:9.6f} {} {:.6f} i", value.real(), value.imag() < 0 ? '-' : '+',
                     std::abs(value.imag()));
}

std::string tangent_text(const limit::SectorSpectrum& spectrum) {
  if (!spectrum.tangent) return "none";
  const auto [first, second] = *spectrum.tangent;
  return fmt::format("{:.6f} and {:.6f}, {}", first, second,
                     first - second < kReal ? "equal" : "distinct");
}

}  // namespace

nlohmann::ordered_json faces_json(const std::string& name, const limit::SectorSpectrum& spectrum) {
  Json matrix = Json::array();
  const Eigen::MatrixXd& entries = spectrum.matrix.entries;
  for (Eigen::Index i = 0; i < entries.rows(); ++i) {
    matrix.push_back(Json::array());
    for (Eigen::Index j = 0; j < entries.cols(); ++j) matrix.back().push_back(entries(i, j));
  }
  Json eigenvalues = Json::array();
  for (const std::complex<double> value : spectrum.eigenvalues)
    eigenvalues.push_back({{"value", {value.real(), value.imag()}}, {"modulus", std::abs(value)}});
  return {{"scheme", name},
          {"faces", corners_of(spectrum.matrix.sectors)},
          {"rings", spectrum.matrix.rings},
          {"matrix", std::move(matrix)},
          {"eigenvalues", std::move(eigenvalues)},
          {"tangent", spectrum.tangent ? Json(*spectrum.tangent) : Json()},
          {"verdict",
           {{"convergent", to_string(spectrum.convergent)},
            {"c1_necessary", to_string(spectrum.c1_necessary)},
            {"reasons", spectrum.reasons}}}};
}

std::string faces_text(const std::string& name, const limit::SectorSpectrum& spectrum) {
  const std::vector<int> corners = corners_of(spectrum.matrix.sectors);
  std::string text = fmt::format("{}, a vertex of the faces {}: {} rings\n\neigenvalues\n", name,
                                 fmt::join(corners, ", "), spectrum.matrix.rings);
  for (const std::complex<double> value : spectrum.eigenvalues)
    text += "  " + value_text(value) + "\n";
  text += fmt::format("\ntangent pair    {}\nconvergent      {}\nC1: necessary   {}\n",
                      tangent_text(spectrum), to_string(spectrum.convergent),
                      to_string(spectrum.c1_necessary));
  for (const std::string& reason : spectrum.reasons) text += "                " + reason + "\n";
  return text +
         "\nC1: necessary   what a C1 surface needs of the eigenvalues; more is needed: a\n"
         "                characteristic map that is regular, and smooth seams\n"
         "All of it in double precision.\n";
}

}  // namespace limn::report
