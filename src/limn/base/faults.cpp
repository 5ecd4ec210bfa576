#include "limn/base/faults.h"

#include <algorithm>
#include <tuple>

#include "limn/base/fault_order.h"
#include "limn/base/printable.h"

namespace limn::base {
namespace {

constexpr std::size_t kMostKept = 2000;
constexpr std::size_t kMostShown = 20;

}  // namespace

void Faults::add(Error fault) {
  const auto same = [&](const Error& other) {
    return other.line == fault.line && other.column == fault.column &&
           other.message == fault.message;
  };
  if (std::any_of(faults_.begin(), faults_.end(), same)) return;
  if (faults_.size() == kMostKept)
    ++uncounted_;
  else
    faults_.push_back(std::move(fault));
}

std::vector<Error> by_place(std::vector<Error> faults) {
  std::stable_sort(faults.begin(), faults.end(), [](const Error& a, const Error& b) {
    return std::tie(a.line, a.column) < std::tie(b.line, b.column);
  });
  return faults;
}

Error Faults::joined() const {
  const std::vector<Error> faults = by_place(faults_);
  Error first = faults.front();
  if (faults.size() == 1) return first;
  first.message = printable(first.message);
  if (!first.hint.empty()) first.message += " (" + printable(first.hint) + ")";
  first.hint.clear();
  const std::size_t shown = std::min(faults.size(), kMostShown);
  for (std::size_t i = 1; i < shown; ++i) first.message += "\n" + faults[i].text();
  if (count() > shown) first.message += "\nand " + std::to_string(count() - shown) + " more faults";
  return first;
}

}  // namespace limn::base
