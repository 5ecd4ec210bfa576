#include "limn/base/near_word.h"

#include <algorithm>
#include <cctype>

namespace limn::base {
namespace {

constexpr std::size_t kLongestWord = 100;  // what is longer is no slip of the pen

std::string lower(std::string_view word) {
  std::string result(word);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// Slips of the pen between two words; no letter is touched twice.
std::size_t slips(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), row(b.size() + 1), next(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    next[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      next[j] =
          std::min({row[j] + 1, next[j - 1] + 1, row[j - 1] + (a[i - 1] != b[j - 1] ? 1U : 0U)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        next[j] = std::min(next[j], before[j - 2] + 1);
    }
    std::swap(before, row);
    std::swap(row, next);
  }
  return row.back();
}

}  // namespace

std::vector<std::string> near_words(std::string_view word, const std::vector<std::string>& known) {
  const std::string wanted = lower(word);
  std::vector<std::string> near;
  if (wanted.size() > kLongestWord) return near;
  std::size_t fewest = 2;
  for (const std::string& one : known) {
    const auto [shorter, longer] = std::minmax({wanted.size(), one.size()});
    // every letter is one slip from every other
    const std::size_t most = std::min<std::size_t>(fewest, longer < 2 ? 0 : shorter < 5 ? 1 : 2);
    const std::size_t count = slips(wanted, lower(one));
    if (count > most) continue;
    if (count < fewest) near.clear();
    fewest = count;
    near.push_back(one);
  }
  if (!near.empty() || wanted.size() < 3) return near;
  for (const std::string& one : known)
    if (lower(one).find(wanted) != std::string::npos) near.push_back(one);
  return near;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  std::string text;
  for (const std::string& near : near_words(word, known))
    text += (text.empty() ? "did you mean " : " or ") + near;
  return text.empty() ? text : text + "?";
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known,
                         const std::string& otherwise) {
  const std::string question = did_you_mean(word, known);
  return question.empty() ? otherwise : question + " " + otherwise;
}

}  // namespace limn::base
