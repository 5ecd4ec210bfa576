#include "limn/report/eigen/eigen_report.h"

#include <cmath>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "limn/report/json_number.h"

namespace limn::report {
namespace {

using Json = nlohmann::ordered_json;

Json entry_json(std::complex<double> entry) {
  if (std::abs(entry.imag()) < 1e-15) return entry.real();
  return {entry.real(), entry.imag()};
}

Json block_json(const Eigen::MatrixXcd& block, const BlockSpectrum& spectrum) {
  Json matrix = Json::array();
  for (Eigen::Index i = 0; i < block.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index j = 0; j < block.cols(); ++j) row.push_back(entry_json(block(i, j)));
    matrix.push_back(std::move(row));
  }
  Json eigenvalues = Json::array();
  for (const Eigenvalue& one : spectrum.eigenvalues)
    eigenvalues.push_back({{"value", {one.value.real(), one.value.imag()}},
                           {"modulus", std::abs(one.value)},
                           {"ring", one.ring},
                           {"multiplicity", one.multiplicity},
                           {"jordan", one.jordan}});
  return {{"frequency", spectrum.frequency},
          {"matrix", std::move(matrix)},
          {"eigenvalues", std::move(eigenvalues)}};
}

Json shape_json(const std::optional<Curvature>& shape) {
  return shape ? Json(to_string(*shape)) : Json();
}

std::string number_text(const std::optional<double>& value) {
  return value ? fmt::format("{:9.6f}", *value) : fmt::format("{:>9}", "–");
}

std::string shape_text(const std::optional<Curvature>& shape) {
  return shape ? std::string(to_string(*shape)) : "–";
}

constexpr char kLine[] = "{:>7}  {:>9} {:>9} {:>9}  {:<10} {:<12} {:<13} {:<12} {}\n";

}  // namespace

nlohmann::ordered_json regular_part_json(const RegularPart& part) {
  return {{"bounded", to_string(part.bounded)}, {"reason", part.reason}};
}

nlohmann::ordered_json eigen_json(const Eigencomponents& components) {
  const Verdict& verdict = components.verdict;
  return {{"valence", components.valence},
          {"rings", components.rings},
          {"components",
           {{"position", number_json(components.position)},
            {"tangent", number_json(components.tangent)},
            {"cup", number_json(components.cup)},
            {"saddle", number_json(components.saddle)}}},
          {"verdict",
           {{"convergent", to_string(verdict.convergent)},
            {"c1_necessary", to_string(verdict.c1_necessary)},
            {"curvature_necessary", to_string(verdict.curvature_necessary)},
            {"regular_part", regular_part_json(verdict.regular_part)},
            {"bounded_curvature", to_string(verdict.bounded_curvature)},
            {"cup", shape_json(verdict.cup)},
            {"saddle", shape_json(verdict.saddle)},
            {"reasons", verdict.reasons}}}};
}

nlohmann::ordered_json eigen_json(const FrequencyBlocks& blocks,
                                  const Eigencomponents& components) {
  Json list = Json::array();
  for (const BlockSpectrum& spectrum : components.spectra)
    list.push_back(
        block_json(blocks.blocks[static_cast<std::size_t>(spectrum.frequency)], spectrum));
  Json json{
      {"valence", components.valence}, {"rings", components.rings}, {"blocks", std::move(list)}};
  json.update(eigen_json(components));
  return json;
}

std::string eigen_heading() {
  return fmt::format("{:>52} {:<12} {:<13} {}\n", "", "C1:", "curvature", "against tangent²") +
         fmt::format(kLine, "valence", "tangent", "cup", "saddle", "convergent", "necessary",
                     "bounded", "cup", "saddle");
}

std::string eigen_text(const Eigencomponents& components) {
  const Verdict& verdict = components.verdict;
  std::string text = fmt::format(kLine, components.valence, number_text(components.tangent),
                                 number_text(components.cup), number_text(components.saddle),
                                 to_string(verdict.convergent), to_string(verdict.c1_necessary),
                                 to_string(verdict.bounded_curvature), shape_text(verdict.cup),
                                 shape_text(verdict.saddle));
  for (const std::string& reason : verdict.reasons) text += "           " + reason + "\n";
  return text;
}

std::string regular_part_text(const RegularPart& part) {
  return fmt::format("curvature bounded on the regular lattice: {} ({})\n", to_string(part.bounded),
                     part.reason);
}

std::string eigen_legend() {
  return "\nC1: necessary   what a C1 surface needs of the eigenvalues; more is needed (the\n"
         "                characteristic map: --map draws it)\n"
         "curvature       at the vertex, by the eigenvalues and the regular surface round it, if\n"
         "                the surface is C1 there\n"
         "cup, saddle     their eigenvalues against tangent²: flat <, bounded =, unbounded >\n"
         "All of it in double precision, but for what is said of the regular lattice;\n"
         "eigenvalues less than 1e-10 apart count as equal.\n";
}

}  // namespace limn::report
