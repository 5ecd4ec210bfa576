#include "limn/search/quantity.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "limn/base/files/file.h"
#include "limn/base/near_word.h"
#include "limn/mesh/io/mesh_file.h"
#include "limn/mesh/mesh.h"
#include "limn/scheme/evaluate.h"
#include "limn/scheme/file/scheme_files.h"
#include "limn/search/quantity_table.h"

namespace limn::search {
namespace {

using Kind = QuantityRow::Kind;

constexpr int kMostLevels = 8;

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

/// With its own place in the message, as the place is to be that in the study.
Error named(const Error& error) {
  const Error placed{error.message, {}, error.file, error.line, error.column};
  return {placed.text(), error.hint};
}

Result<double> read_number(const Part& part) {
  const Result<Expression> expression = Expression::parse(part.text, Decimals::admitted);
  if (!expression)
    return at_column(expression.error(), part.column + std::max(expression.error().column, 1) - 1);
  const Result<double> value =
      scheme::evaluate<double>(*expression, [](const std::string& name) -> Result<double> {
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
                         base::did_you_mean(name, known, "`limn study --quantities` lists them")},
                   1);
}

/// Reads the arguments one after the other; `scheme` is where a reference surface is found.
struct ArgumentReader {
  const std::string& folder;
  QuantityArguments arguments = {};
  std::optional<Scheme> scheme = {};
  std::string content = {};
  std::vector<std::string> files = {};

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
    const Result<std::string> bytes = base::read_file(path);
    if (!bytes) return at_column(named(bytes.error()), part.column);
    Result<Polygons> polygons = read_mesh(path);
    if (!polygons) return at_column(named(polygons.error()), part.column);
    if (const Result<Mesh> mesh = Mesh::build(*polygons); !mesh)
      return at_column(Error{path + ": " + mesh.error().message, mesh.error().hint}, part.column);
    content += *bytes;
    files.push_back(path);
    arguments.mesh = std::make_shared<const Polygons>(*std::move(polygons));
    return Done{};
  }

  Status read_scheme_at(const Part& part) {
    const std::vector<std::string> shipped = shipped_schemes();
    const bool is_shipped = std::find(shipped.begin(), shipped.end(), part.text) != shipped.end();
    Result<Scheme> found =
        find_scheme(is_shipped ? std::string(part.text) : path_from(folder, part.text));
    if (!found) return at_column(named(found.error()), part.column);
    for (const SourceText& text : found->texts) content += text.text;
    for (std::string& file : scheme_files(*found)) files.push_back(std::move(file));
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
  quantity.files_ = std::move(reader.files);
  quantity.row_ = *row;
  quantity.arguments_ = std::move(reader.arguments);
  return quantity;
}

Result<double> Quantity::operator()(SchemeReading& scheme) const {
  const Result<double> value = row_->value(scheme, arguments_);
  if (!value || std::isfinite(*value)) return value;
  return Error{fmt::format("{} is not finite", text_)};
}

}  // namespace limn::search
