#include "limn/study/c1_answers.h"

#include <numeric>

#include <fmt/core.h>

#include "limn/certify/certify.h"

namespace limn {
namespace {

constexpr int kMostParts = 8000;

/// "3 … 7, 9"
std::string runs(const std::vector<int>& list) {
  std::string text;
  for (std::size_t i = 0; i < list.size();) {
    std::size_t end = i;
    while (end + 1 < list.size() && list[end + 1] == list[end] + 1) ++end;
    if (!text.empty()) text += ", ";
    text += end > i ? fmt::format("{} … {}", list[i], list[end]) : fmt::format("{}", list[i]);
    i = end + 1;
  }
  return text;
}

}  // namespace

std::vector<certify::Answer> c1_answers(const Scheme& scheme, int first, int last) {
  std::vector<int> valences(static_cast<std::size_t>(last - first + 1));
  std::iota(valences.begin(), valences.end(), first);
  std::vector<certify::Answer> answers(valences.size(), certify::Answer::undecided);
  certify::CertifyOptions options;
  options.most_parts = kMostParts;
  if (const auto all = certify::certify(scheme, valences, options)) {
    for (std::size_t i = 0; i < answers.size(); ++i) answers[i] = all->valences[i].c1;
    return answers;
  }
  // one by one where a rule is missing at some
  for (std::size_t i = 0; i < valences.size(); ++i)
    if (const auto one = certify::certify(scheme, {valences[i]}, options))
      answers[i] = one->valences.front().c1;
  return answers;
}

std::string c1_answers_text(const std::vector<certify::Answer>& answers, int first) {
  std::vector<int> proved;
  std::vector<int> refuted;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const int n = first + static_cast<int>(i);
    if (answers[i] == certify::Answer::proved) proved.push_back(n);
    if (answers[i] == certify::Answer::refuted) refuted.push_back(n);
  }
  std::string text = proved.empty() ? "none" : runs(proved);
  if (!refuted.empty()) text += "; refuted " + runs(refuted);
  return text;
}

}  // namespace limn
