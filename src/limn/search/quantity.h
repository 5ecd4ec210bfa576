#pragma once
/// The numbers of a scheme that a study can ask for: one table (quantities), a row each.
///
///     artifact(1/8, 0)      holder_lower()      cup_gap()      thin_plate(tripod.obj, 4)

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "limn/base/error.h"
#include "limn/mesh/polygons.h"
#include "limn/search/scheme_reading.h"

namespace limn::search {

/// The largest valence that a study may name.
inline constexpr int kLargestValence = 2000;

/// What stands between the parentheses, read and loaded.
struct QuantityArguments {
  std::vector<double> numbers;                ///< in order
  std::shared_ptr<const Polygons> mesh;       ///< the control mesh that is named, if one is
  std::shared_ptr<const Polygons> reference;  ///< limit surface of the scheme that is named
};

/// A row of the table.
struct QuantityRow {
  /// mesh: a file, from the study's folder; scheme: as in "scheme" of a study.
  enum class Kind { number, valence, levels, mesh, scheme };
  struct Argument {
    std::string_view name;
    Kind kind;
  };
  std::string_view name;
  std::vector<Argument> arguments;
  std::string_view meaning;
  std::string_view unit;
  std::string_view cost;  ///< in words, for a scheme of the usual width
  /// Fails where the scheme has no such number. Pure: the same bits for the same scheme.
  Result<double> (*value)(SchemeReading& scheme, const QuantityArguments& arguments);
};

/// All of them, in the order of listings. A new one is one more row in quantity.cpp.
[[nodiscard]] const std::vector<QuantityRow>& quantities();

/// A row with its arguments.
class Quantity {
 public:
  /// "name(argument, …)"; the arguments that are numbers are expressions without names. Files and
  /// schemes are looked for from `folder` on and loaded at once. Fails with the fault, and with its
  /// column in `text` where that is known.
  [[nodiscard]] static Result<Quantity> parse(std::string_view text, const std::string& folder);

  /// As it was written.
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] const QuantityRow& row() const { return *row_; }
  /// What the number depends on beside the scheme: the content of files. Empty for most.
  [[nodiscard]] const std::string& content() const { return content_; }
  /// The files that it names, by paths as they were opened.
  [[nodiscard]] const std::vector<std::string>& files() const { return files_; }
  /// Of a scheme. Fails where it has none, or none that is finite.
  [[nodiscard]] Result<double> operator()(SchemeReading& scheme) const;

 private:
  std::string text_, content_;
  std::vector<std::string> files_;
  const QuantityRow* row_ = nullptr;
  QuantityArguments arguments_;
};

}  // namespace limn::search
