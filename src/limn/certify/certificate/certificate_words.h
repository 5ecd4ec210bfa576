#pragma once
/// Words that stand in several places of a certificate. Private to its JSON.

#include <initializer_list>
#include <string>
#include <vector>

#include "limn/certify/certificate/certificate.h"
#include "limn/certify/certificate/json_reader.h"

namespace limn::certify {

/// One of `all`, by its word.
template <class Enum>
Enum read_word(JsonReader& reader, const char* key, std::initializer_list<Enum> all) {
  const std::string text = reader.text(key);
  for (const Enum one : all)
    if (text == to_string(one)) return one;
  reader.fail(fmt::format("'{}' cannot be '{}'", key, text.substr(0, 40)));
  return *all.begin();
}

[[nodiscard]] inline Answer read_answer(JsonReader& reader, const char* key) {
  return read_word(reader, key, {Answer::undecided, Answer::proved, Answer::refuted});
}

/// Parts of a cell in one text, "-" the whole cell: "0 1 20 21".
[[nodiscard]] std::string parts_text(const std::vector<std::string>& parts);
/// Inverse; the reader's fault where the text is something else.
[[nodiscard]] std::vector<std::string> read_parts(JsonReader& reader, const std::string& text);

}  // namespace limn::certify
