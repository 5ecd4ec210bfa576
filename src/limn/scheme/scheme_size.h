#pragma once
/// How large a scheme file may be. The largest that is shipped has a few thousand bytes.

#include <cstdint>

namespace limn::scheme {

inline constexpr std::uint64_t kMostSchemeBytes = std::uint64_t{1} << 18;

}  // namespace limn::scheme
