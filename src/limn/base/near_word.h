#pragma once
/// What a user may have meant by a word that is not known.

#include <string>
#include <string_view>
#include <vector>

namespace limn::base {

/// The known words nearest to `word`, in their order: those that the fewest slips of the pen
/// (letters left out, put in, changed, or two neighbours exchanged) make of it, at most two, and
/// fewer in words of up to four letters; where there is none, those that hold it as a part, if it
/// has three letters or more. Capitals do not count. Cost: the product of the lengths, for each
/// known word.
[[nodiscard]] std::vector<std::string> near_words(std::string_view word,
                                                  const std::vector<std::string>& known);

/// "did you mean loop or loop-type?", or nothing where no word is near.
[[nodiscard]] std::string did_you_mean(std::string_view word,
                                       const std::vector<std::string>& known);

/// That question with what else is to be said: "did you mean ring? expected self or ring".
[[nodiscard]] std::string did_you_mean(std::string_view word, const std::vector<std::string>& known,
                                       const std::string& otherwise);

}  // namespace limn::base
