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

  Error() = default;  ///< nothing is known
  /// What is known; the rest may be left out.
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
  /// Success; implicit, so that a function returns its value as it is.
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  /// Failure; implicit, so that one function returns the error of another.
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  /// Whether there is a value.
  [[nodiscard]] bool ok() const { return state_.index() == 0; }
  /// ok(), for `if (result)`.
  explicit operator bool() const { return ok(); }

  ///@{
  /// The value. Precondition: ok(); else std::bad_variant_access is thrown. Of a temporary the
  /// value is moved out, so that `for (x : f().value())` does not outlive what it runs over.
  [[nodiscard]] T& value() & { return std::get<0>(state_); }
  [[nodiscard]] const T& value() const& { return std::get<0>(state_); }
  [[nodiscard]] T value() && { return std::get<0>(std::move(state_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  ///@}

  /// Why there is no value. Precondition: !ok(); else std::bad_variant_access is thrown.
  [[nodiscard]] const Error& error() const { return std::get<1>(state_); }
  /// The same, to add what the caller knows: the file, say.
  [[nodiscard]] Error& error() { return std::get<1>(state_); }

 private:
  std::variant<T, Error> state_;
};

struct Done {};               ///< the value of an action that returns nothing
using Status = Result<Done>;  ///< done, or why not

/// Remarks on input that was taken all the same, in the order in which they were met.
using Warnings = std::vector<Error>;

}  // namespace limn
