#pragma once
/// What the names in a scheme's expressions mean; private to scheme/.

#include <set>
#include <string>

#include "limn/base/faults.h"
#include "limn/scheme/file/scheme_reader.h"

namespace limn::scheme {

/// Every name in every expression of the scheme, used or not, is n, k, a parameter or a let, and
/// no let or parameter is defined in terms of itself: each unknown name in each expression is a
/// fault, and so is a circle, the first one. Names in `unread` are known.
void check_names(const Scheme& scheme, const Unread& unread, base::Faults& faults);

/// The definitions whose value is not to be had: those in `unread`, and those that lead to them, to
/// unknown names or to themselves.
[[nodiscard]] std::set<std::string> valueless_names(const Scheme& scheme, const Unread& unread);

}  // namespace limn::scheme
