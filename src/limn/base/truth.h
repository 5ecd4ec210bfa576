#pragma once
/// Answers to questions of mathematics: undecided is one of them.

#include <string_view>

namespace limn {

/// The answer to a question of mathematics. `undecided` comes with a reason, in a field beside it.
enum class Truth { no, yes, undecided };

/// "yes", "no" or "undecided"; zero-terminated.
[[nodiscard]] constexpr std::string_view to_string(Truth truth) {
  return truth == Truth::yes ? "yes" : truth == Truth::no ? "no" : "undecided";
}

/// Both hold.
[[nodiscard]] constexpr Truth operator&&(Truth a, Truth b) {
  if (a == Truth::no || b == Truth::no) return Truth::no;
  return a == Truth::yes && b == Truth::yes ? Truth::yes : Truth::undecided;
}

}  // namespace limn
