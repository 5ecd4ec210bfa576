#pragma once
/// Bad input is a value, not an exception: a function that can meet it returns a
/// `Result`, whose `Error` names the place, the fault and the remedy. The library
/// prints nothing and never exits. A broken precondition of ours is an assert.

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace limn {

/// A fault in something the user gave us (or, in a list of warnings, a remark on it).
struct Error {
  std::string message;  ///< what is wrong and what was expected, one sentence, lower case
  std::string hint;     ///< the remedy, one sentence; may be empty
  std::string file;     ///< path as the user gave it; empty: no file is involved
  int line = 0;         ///< 1-based; 0: unknown or not applicable (binary file)
  int column = 0;       ///< 1-based, in bytes; 0: unknown

  Error() = default;
  Error(std::string what, std::string remedy = {}, std::string where = {}, int at_line = 0,
        int at_column = 0)
      : message(std::move(what)),
        hint(std::move(remedy)),
        file(std::move(where)),
        line(at_line),
        column(at_column) {}

  /// "file:line:column: message (hint)", with the parts that are known.
  [[nodiscard]] std::string text() const;
};

/// Either a value or the error that kept it from being made.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  [[nodiscard]] bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  /// Precondition of these: `ok()`.
  [[nodiscard]] T& value() & { return std::get<0>(state_); }
  [[nodiscard]] const T& value() const& { return std::get<0>(state_); }
  // by value, so that `for (x : f().value())` does not outlive what it runs over
  [[nodiscard]] T value() && { return std::get<0>(std::move(state_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  /// Precondition: `!ok()`.
  [[nodiscard]] const Error& error() const { return std::get<1>(state_); }
  [[nodiscard]] Error& error() { return std::get<1>(state_); }

 private:
  std::variant<T, Error> state_;
};

struct Done {};               ///< the value of an action that returns nothing
using Status = Result<Done>;  ///< done, or why not

using Warnings = std::vector<Error>;

}  // namespace limn
