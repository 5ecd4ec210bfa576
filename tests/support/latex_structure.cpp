#include "support/latex_structure.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace limn::test {
namespace {

/// An open group: "{", "$", "\\[", "\\left", or the name of an environment.
struct Group {
  std::string opened;
  std::size_t columns = 0;              // of a table; 0: as many as its first row has
  std::vector<std::vector<bool>> rows;  // of a table: which cells have something in them
  [[nodiscard]] bool is_table() const {
    return opened == "array" || opened == "tabular" || opened == "align*";
  }
};

class Checker {
 public:
  explicit Checker(const std::string& text) : text_(text) {}

  std::string run() {
    open_.push_back({"text", 0, {}});
    while (at_ < text_.size() && fault_.empty()) step();
    if (fault_.empty() && open_.size() != 1) fault_ = "never closed: " + open_.back().opened;
    return fault_;
  }

 private:
  Group& inner() { return open_.back(); }

  [[nodiscard]] bool in_math() const {
    return std::any_of(open_.begin(), open_.end(), [](const Group& g) {
      return g.opened == "$" || g.opened == "\\[" || g.opened == "align*";
    });
  }

  void fill() {
    if (inner().is_table()) inner().rows.back().back() = true;
  }

  void open(std::string name, std::size_t columns = 0) {
    fill();
    open_.push_back({std::move(name), columns, {{false}}});
  }

  void close(const std::string& name) {
    if (inner().opened != name) {
      fault_ = name + " closes " + inner().opened;
      return;
    }
    if (inner().is_table()) check_table(inner());
    open_.pop_back();
  }

  void check_table(const Group& table) {
    const std::size_t columns = table.columns > 0 ? table.columns : table.rows.front().size();
    const auto& last = table.rows.back();
    if (std::find(last.begin(), last.end(), true) == last.end())
      fault_ = "a stray line break, or an empty table";
    std::vector<bool> used(columns, false);
    for (const auto& row : table.rows) {
      if (row.size() != columns)
        fault_ = "a row of " + std::to_string(row.size()) + " cells among " +
                 std::to_string(columns) + " columns";
      for (std::size_t i = 0; i < std::min(columns, row.size()); ++i) used[i] = used[i] || row[i];
    }
    if (fault_.empty() && std::find(used.begin(), used.end(), false) != used.end())
      fault_ = "a column that is empty in every row";
  }

  /// {…} here, without what is in it being looked at.
  std::string argument() {
    const std::size_t end = text_.find('}', at_);
    if (at_ >= text_.size() || text_[at_] != '{' || end == std::string::npos) {
      fault_ = "an argument is missing";
      return {};
    }
    std::string name = text_.substr(at_ + 1, end - at_ - 1);
    at_ = end + 1;
    return name;
  }

  void command() {
    std::string name = text_.substr(at_, 1);
    ++at_;
    if (std::isalpha(static_cast<unsigned char>(name[0])) != 0)
      while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0)
        name += text_[at_++];
    if (name == "begin") {
      const std::string environment = argument();
      const bool has_columns = environment == "array" || environment == "tabular";
      open(environment, has_columns ? argument().size() : 0);
    } else if (name == "end") {
      close(argument());
    } else if (name == "left") {
      open("\\left");
      ++at_;
    } else if (name == "right") {
      close("\\left");
      ++at_;
    } else if (name == "[") {
      open("\\[");
    } else if (name == "]") {
      close("\\[");
    } else if (name == "\\") {
      if (!inner().is_table())
        fault_ = "a line break in no table";
      else
        inner().rows.push_back({false});
    } else if (name != "hline") {
      fill();
    }
  }

  void step() {
    const char c = text_[at_++];
    if (c == '\n' || c == ' ') return;
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') {
      fault_ = "a control character";
    } else if (c == '%') {
      at_ = std::min(text_.find('\n', at_), text_.size());
    } else if (c == '\\') {
      command();
    } else if (c == '{') {
      open("{");
    } else if (c == '}') {
      close("{");
    } else if (c == '$') {
      if (inner().opened == "$")
        close("$");
      else
        open("$");
    } else if (c == '&') {
      if (!inner().is_table())
        fault_ = "& in no table";
      else
        inner().rows.back().push_back(false);
    } else if (c == '#' || ((c == '_' || c == '^') && !in_math())) {
      fault_ = std::string("a character that needs an escape: ") + c;
    } else {
      fill();
    }
  }

  const std::string& text_;
  std::size_t at_ = 0;
  std::string fault_;
  std::vector<Group> open_;
};

}  // namespace

std::string latex_fault(const std::string& text) { return Checker(text).run(); }

}  // namespace limn::test
