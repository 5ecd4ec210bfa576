#include "limn/study/c1_answers.h"

#include <numeric>

#include "limn/certify/certify.h"

namespace limn::study {
namespace {

constexpr int kMostParts = 20'000;

}  // namespace

std::vector<certify::Answer> c1_answers(const Scheme& scheme, int first, int last) {
  std::vector<int> valences(static_cast<std::size_t>(last - first + 1));
  std::iota(valences.begin(), valences.end(), first);
  std::vector<certify::Answer> answers(valences.size(), certify::Answer::undecided);
  certify::CertifyOptions options;
  options.most_parts = kMostParts;
  options.leave_out = true;
  if (const auto all = certify::certify(scheme, valences, options))
    for (std::size_t i = 0; i < answers.size(); ++i) answers[i] = all->valences[i].c1;
  return answers;
}

}  // namespace limn::study
