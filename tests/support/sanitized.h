#pragma once
/// Sanitizers reserve terabytes of addresses, keep what is freed and widen every stack frame: what
/// a test says of memory is not to be measured while they watch.

#include <string>

namespace limn::test {

// LIMN_SANITIZED: the programs that the tests start are, whether or not the tests are themselves.
#if defined(LIMN_SANITIZED) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

/// Words of a shell that bound the stack of what follows. Frames with sanitizers are some times as
/// large.
inline std::string stack_of(int kibibytes) {
  return "ulimit -s " + std::to_string(kSanitized ? 8 * kibibytes : kibibytes) + ";";
}

}  // namespace limn::test

/// Ends a test that measures or bounds memory, where sanitizers watch.
#define LIMN_SKIP_IF_SANITIZED() \
  if (limn::test::kSanitized) GTEST_SKIP() << "sanitizers take memory of their own"
