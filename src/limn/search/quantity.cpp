#include "limn/search/quantity.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/core.h>

#include "limn/base/files/file.h"
#include "limn/base/near_word.h"
#include "limn/mesh/io/mesh_file.h"
#include "limn/mesh/mesh.h"
#include "limn/mesh/surface_distance.h"
#include "limn/regular/sampling_density.h"
#include "limn/scheme/evaluate.h"
#include "limn/study/compare_record.h"
#include "limn/study/fairness_record.h"
#include "limn/surface/refine_surface.h"

namespace limn {
namespace {

using Kind = QuantityRow::Kind;
using Arguments = QuantityArguments;

constexpr int kMostLevels = 8;
constexpr int kLargestValence = 2000;

// ------------------------------------------------------------------------------ the lattice

Result<double> artifact(SchemeReading& scheme, const Arguments& at) {
  if (!scheme.artifacts()) return scheme.artifacts().error();
  return scheme.artifacts()->in_limit({at.numbers[0], at.numbers[1]}).percent_of_signal();
}

Result<double> artifact_energy(SchemeReading& scheme, const Arguments& at) {
  if (!scheme.artifacts()) return scheme.artifacts().error();
  return scheme.artifacts()->energy_percent({at.numbers[0], at.numbers[1]});
}

Result<double> worst_artifact(SchemeReading& scheme, const Arguments& at) {
  if (!scheme.artifacts()) return scheme.artifacts().error();
  if (!(at.numbers[0] > 0)) return Error{"a wave has more than 0 edges"};
  return wave_artifacts(*scheme.artifacts(), at.numbers[0]).worst;
}

Result<double> density(SchemeReading& scheme, const Arguments& at) {
  if (!scheme.artifacts()) return scheme.artifacts().error();
  const Result<SamplingDensity> found =
      sampling_density(*scheme.artifacts(), at.numbers[0], ArtifactMeasure::total_energy);
  if (!found) return found.error();
  return found->worst.edges_per_wavelength;
}

Result<double> holder_lower(SchemeReading& scheme, const Arguments&) {
  if (!scheme.regularity()) return scheme.regularity().error();
  return scheme.regularity()->holder.lower;
}

Result<double> holder_upper(SchemeReading& scheme, const Arguments&) {
  if (!scheme.regularity()) return scheme.regularity().error();
  const HolderBracket& holder = scheme.regularity()->holder;
  if (holder.upper) return *holder.upper;
  if (!holder.exact.empty()) return holder.lower;  // of a box spline
  return Error{"the Hölder exponent has no upper bound: shifts are not proved stable"};
}

Result<double> sum_rules(SchemeReading& scheme, const Arguments&) {
  if (!scheme.regularity()) return scheme.regularity().error();
  return scheme.regularity()->orders.sum_rules;
}

// ----------------------------------------------------------------------------- the vertices

Result<double> component(SchemeReading& scheme, int n, std::optional<double> Eigencomponents::*one,
                         std::string_view name) {
  const Result<Eigencomponents>& found = scheme.components(n);
  if (!found) return found.error();
  if ((*found).*one) return *((*found).*one);
  return Error{fmt::format("there is no {} at valence {}", name, n)};
}

int valence_of(const Arguments& at) { return static_cast<int>(at.numbers[0]); }

Result<double> tangent(SchemeReading& scheme, const Arguments& at) {
  return component(scheme, valence_of(at), &Eigencomponents::tangent, "tangent");
}

Result<double> cup(SchemeReading& scheme, const Arguments& at) {
  return component(scheme, valence_of(at), &Eigencomponents::cup, "cup");
}

Result<double> saddle(SchemeReading& scheme, const Arguments& at) {
  return component(scheme, valence_of(at), &Eigencomponents::saddle, "saddle");
}

/// The largest |one − tangent²| over the valences that have it.
Result<double> largest_gap(SchemeReading& scheme, std::optional<double> Eigencomponents::*one,
                           std::string_view name, int least_valence) {
  double largest = 0;
  for (const int n : scheme.valences()) {
    if (n < least_valence) continue;
    const Result<double> value = component(scheme, n, one, name);
    const Result<double> slope = component(scheme, n, &Eigencomponents::tangent, "tangent");
    if (!value) return value;
    if (!slope) return slope;
    largest = std::max(largest, std::abs(*value - *slope * *slope));
  }
  return largest;
}

constexpr int kFirstSaddle = 4;  // valence 3 has no frequency 2 of its own

Result<double> cup_gap(SchemeReading& scheme, const Arguments&) {
  return largest_gap(scheme, &Eigencomponents::cup, "cup", 3);
}

Result<double> saddle_gap(SchemeReading& scheme, const Arguments&) {
  return largest_gap(scheme, &Eigencomponents::saddle, "saddle", kFirstSaddle);
}

// ----------------------------------------------------------------------------- the surfaces

Result<FairnessLevel> fairness(SchemeReading& scheme, const Arguments& at) {
  Result<Mesh> mesh = Mesh::build(*at.mesh);
  if (!mesh) return mesh.error();
  FairnessOptions options;
  options.levels = static_cast<int>(at.numbers[0]);
  const Result<FairnessRecord> record =
      approx_fairness({}, scheme.scheme(), *mesh, at.mesh->positions, options);
  if (!record) return record.error();
  return record->last();
}

Result<double> thin_plate(SchemeReading& scheme, const Arguments& at) {
  const Result<FairnessLevel> level = fairness(scheme, at);
  if (!level) return level.error();
  return level->energies.thin_plate;
}

Result<double> curvature_variation(SchemeReading& scheme, const Arguments& at) {
  const Result<FairnessLevel> level = fairness(scheme, at);
  if (!level) return level.error();
  return level->energies.curvature_variation;
}

Result<Polygons> limit_surface(const Scheme& scheme, const Polygons& control, int levels) {
  Result<Mesh> mesh = Mesh::build(control);
  if (!mesh) return mesh.error();
  SurfaceOptions options;
  options.levels = levels;
  options.limit = true;
  Result<RefinedSurface> surface =
      refine_surface(scheme, *std::move(mesh), control.positions, options);
  if (!surface) return surface.error();
  surface->polygons.positions = std::move(surface->limit);
  return std::move(surface->polygons);
}

Result<double> distance(SchemeReading& scheme, const Arguments& at) {
  const Result<Polygons> own =
      limit_surface(scheme.scheme(), *at.mesh, static_cast<int>(at.numbers[0]));
  if (!own) return own.error();
  const Result<SurfaceDistance> apart = approx_surface_distance(*own, *at.reference);
  if (!apart) return apart.error();
  return 100 * apart->largest / apart->diagonal;
}

std::vector<QuantityRow> make_quantities() {
  const QuantityRow::Argument fx{"fx", Kind::number}, fy{"fy", Kind::number};
  const QuantityRow::Argument n{"n", Kind::valence}, mesh{"mesh", Kind::mesh};
  const QuantityRow::Argument levels{"levels", Kind::levels};
  return {
      {"artifact",
       {fx, fy},
       "artifacts of the wave (fx, fy) in the limit, by ADS's mean energy",
       "% of the signal",
       "milliseconds",
       artifact},
      {"artifact_energy",
       {fx, fy},
       "all waves that the limit of the wave (fx, fy) has beside it",
       "% of the signal",
       "milliseconds",
       artifact_energy},
      {"worst_artifact",
       {{"edges", Kind::number}},
       "artifact_energy of waves of so many control edges in their worst direction",
       "% of the signal",
       "milliseconds",
       worst_artifact},
      {"sampling_density",
       {{"percent", Kind::number}},
       "control edges a wavelength that keep artifact_energy below so many percent in every "
       "direction",
       "edges",
       "tenths of a second",
       density},
      {"holder_lower",
       {},
       "proved lower bound of the Hölder exponent on the regular lattice",
       "",
       "milliseconds to seconds",
       holder_lower},
      {"holder_upper",
       {},
       "proved upper bound of the same",
       "",
       "milliseconds to seconds",
       holder_upper},
      {"sum_rules", {}, "order of the sum rules", "", "milliseconds to seconds", sum_rules},
      {"tangent",
       {n},
       "eigenvalue that leads frequency 1 at valence n",
       "",
       "milliseconds",
       tangent},
      {"cup", {n}, "second eigenvalue of frequency 0 at valence n", "", "milliseconds", cup},
      {"saddle", {n}, "eigenvalue that leads frequency 2 at valence n", "", "milliseconds", saddle},
      {"cup_gap",
       {},
       "the largest |cup - tangent^2| over the study's valences",
       "",
       "milliseconds a valence",
       cup_gap},
      {"saddle_gap",
       {},
       "the largest |saddle - tangent^2| over the study's valences from 4 on",
       "",
       "milliseconds a valence",
       saddle_gap},
      {"thin_plate",
       {mesh, levels},
       "integral of k1^2 + k2^2 over the limit surface of a mesh",
       "",
       "microseconds a vertex",
       thin_plate},
      {"curvature_variation",
       {mesh, levels},
       "integral of the squared derivative of the second fundamental form",
       "1/length^2",
       "microseconds a vertex",
       curvature_variation},
      {"distance",
       {{"scheme", Kind::scheme}, mesh, levels},
       "largest distance to the limit surface of another scheme",
       "% of the mesh's diagonal",
       "microseconds a vertex",
       distance},
  };
}

// ------------------------------------------------------------------------------------ reading

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

/// A part of a text and the column where it begins.
struct Part {
  std::string_view text;
  int column;
};

/// The parts between commas outside parentheses; none of nothing.
std::vector<Part> parts_of(std::string_view text, int column) {
  std::vector<Part> parts;
  if (trimmed(text).empty()) return parts;
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    if (i < text.size() && text[i] == '(') ++depth;
    if (i < text.size() && text[i] == ')') --depth;
    if (i < text.size() && (text[i] != ',' || depth > 0)) continue;
    const std::string_view part = text.substr(begin, i - begin);
    const std::size_t blanks = part.find_first_not_of(" \t");
    parts.push_back(
        {trimmed(part), column + static_cast<int>(begin + (blanks == part.npos ? 0 : blanks))});
    begin = i + 1;
  }
  return parts;
}

Error at_column(Error error, int column) {
  error.file.clear();
  error.line = 0;
  error.column = column;
  return error;
}

Result<double> read_number(const Part& part) {
  const Result<Expression> expression = Expression::parse(part.text, Decimals::admitted);
  if (!expression)
    return at_column(expression.error(), part.column + std::max(expression.error().column, 1) - 1);
  const Result<double> value =
      evaluate<double>(*expression, [](const std::string& name) -> Result<double> {
        return Error{fmt::format("a number was expected, not the name '{}'", name)};
      });
  if (!value) return at_column(value.error(), part.column + std::max(value.error().column, 1) - 1);
  return value;
}

Result<double> read_whole(const Part& part, int least, int most, std::string_view what) {
  const Result<double> value = read_number(part);
  if (!value) return value;
  if (*value == std::floor(*value) && *value >= least && *value <= most) return value;
  return at_column(
      Error{fmt::format("expected {}, a whole number from {} to {}", what, least, most)},
      part.column);
}

std::string path_from(const std::string& folder, std::string_view path) {
  const std::filesystem::path given{std::string(path)};
  return given.is_absolute() || folder.empty() ? given.string() : (folder / given).string();
}

std::string list_of_arguments(const QuantityRow& row) {
  std::string list = std::string(row.name) + "(";
  for (std::size_t i = 0; i < row.arguments.size(); ++i)
    list += (i > 0 ? ", " : "") + std::string(row.arguments[i].name);
  return list + ")";
}

Result<const QuantityRow*> find_row(std::string_view name) {
  std::vector<std::string> known;
  for (const QuantityRow& row : quantities()) {
    if (row.name == name) return &row;
    known.emplace_back(row.name);
  }
  return at_column(Error{fmt::format("there is no quantity '{}'", name),
                         did_you_mean(name, known, "`limn study --quantities` lists them")},
                   1);
}

}  // namespace

const std::vector<QuantityRow>& quantities() {
  static const std::vector<QuantityRow> rows = make_quantities();
  return rows;
}

namespace {

/// Reads the arguments one after the other; `scheme` is where a reference surface is found.
struct ArgumentReader {
  const std::string& folder;
  QuantityArguments arguments = {};
  std::optional<Scheme> scheme = {};
  std::string content = {};

  Status read(Kind kind, const Part& part) {
    switch (kind) {
      case Kind::mesh: return read_mesh_at(part);
      case Kind::scheme: return read_scheme_at(part);
      default: break;
    }
    const Result<double> number = kind == Kind::number ? read_number(part)
                                  : kind == Kind::levels
                                      ? read_whole(part, 1, kMostLevels, "refinement steps")
                                      : read_whole(part, 3, kLargestValence, "a valence");
    if (!number) return number.error();
    arguments.numbers.push_back(*number);
    return Done{};
  }

  Status read_mesh_at(const Part& part) {
    const std::string path = path_from(folder, part.text);
    const Result<std::string> bytes = read_file(path);
    if (!bytes) return at_column(bytes.error(), part.column);
    Result<Polygons> polygons = read_mesh(path);
    if (!polygons) return at_column(polygons.error(), part.column);
    if (const Result<Mesh> mesh = Mesh::build(*polygons); !mesh)
      return at_column(mesh.error(), part.column);
    content += *bytes;
    arguments.mesh = std::make_shared<const Polygons>(*std::move(polygons));
    return Done{};
  }

  Status read_scheme_at(const Part& part) {
    const std::vector<std::string> shipped = shipped_schemes();
    const bool is_shipped = std::find(shipped.begin(), shipped.end(), part.text) != shipped.end();
    Result<Scheme> found =
        find_scheme(is_shipped ? std::string(part.text) : path_from(folder, part.text));
    if (!found) return at_column(found.error(), part.column);
    for (const SourceText& text : found->texts) content += text.text;
    scheme = *std::move(found);
    return Done{};
  }

  Status finish(int column) {
    if (!scheme) return Done{};
    Result<Polygons> surface =
        limit_surface(*scheme, *arguments.mesh, static_cast<int>(arguments.numbers[0]));
    if (!surface) return at_column(surface.error(), column);
    arguments.reference = std::make_shared<const Polygons>(*std::move(surface));
    return Done{};
  }
};

}  // namespace

Result<Quantity> Quantity::parse(std::string_view text, const std::string& folder) {
  const std::string_view all = trimmed(text);
  const std::size_t open = all.find('(');
  const int begin = static_cast<int>(all.data() - text.data());
  const Result<const QuantityRow*> row = find_row(trimmed(all.substr(0, open)));
  if (!row) return at_column(row.error(), begin + 1);
  if (open != all.npos && all.back() != ')')
    return at_column(Error{"expected ')' at the end"}, begin + static_cast<int>(all.size()));
  const std::vector<Part> parts = open == all.npos
                                      ? std::vector<Part>()
                                      : parts_of(all.substr(open + 1, all.size() - open - 2),
                                                 begin + static_cast<int>(open) + 2);
  if (parts.size() != (*row)->arguments.size())
    return at_column(Error{fmt::format("{} takes {} arguments, not {}", (*row)->name,
                                       (*row)->arguments.size(), parts.size()),
                           "write " + list_of_arguments(**row)},
                     begin + 1);
  ArgumentReader reader{folder};
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (Status status = reader.read((*row)->arguments[i].kind, parts[i]); !status)
      return status.error();
  if (Status status = reader.finish(begin + 1); !status) return status.error();
  Quantity quantity;
  quantity.text_ = all;
  quantity.content_ = std::move(reader.content);
  quantity.row_ = *row;
  quantity.arguments_ = std::move(reader.arguments);
  return quantity;
}

Result<double> Quantity::operator()(SchemeReading& scheme) const {
  const Result<double> value = row_->value(scheme, arguments_);
  if (!value || std::isfinite(*value)) return value;
  return Error{fmt::format("{} is not finite", text_)};
}

}  // namespace limn
