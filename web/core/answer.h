#pragma once
/// What the page's core answers: JSON with "ok", and what keeps anything from escaping it.

#include <exception>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "limn/base/error.h"

namespace limn::page {

using Json = nlohmann::ordered_json;

/// The text of an answer; bytes that are not UTF-8 are replaced, as by the command.
[[nodiscard]] std::string text_of(const Json& json);

/// {"ok": true, …}
[[nodiscard]] Json accepted(const Json& rest = Json::object());

/// {"ok": false, "errors": [{"line", "column", "message", "hint"}]}: one for each fault that the
/// library has joined in one error. Line and column are 0 where none is known.
[[nodiscard]] Json refused(const Error& error);

/// [{"line", "column", "message", "hint"}]
[[nodiscard]] Json errors_json(const Warnings& errors);

/// What `make` returns, a Result<Json> with what is added to {"ok": true}, as text. What is thrown
/// (memory that there is not, a fault of ours) is an answer, too.
template <class Make>
[[nodiscard]] std::string answer(Make make) {
  Error failure;
  try {
    const Result<Json> made = make();
    return text_of(made ? accepted(*made) : refused(made.error()));
  } catch (const std::bad_alloc&) {
    failure = {"there is not enough memory for this", "take fewer levels, or a smaller mesh"};
  } catch (const std::exception& fault) {
    failure = {std::string("a fault of limn: ") + fault.what(), "please report it"};
  }
  return text_of(refused(failure));
}

}  // namespace limn::page
