#include "limn/base/huge_array.h"

#include <cstdint>
#include <cstdlib>
#include <new>

#include "limn/base/large_vector.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace limn::base::detail {
namespace {

constexpr std::size_t kHugePage = std::size_t{2} << 20U;

/// Advice only: without huge pages the memory is as good, and slower at first touch.
void advise([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) noexcept {
#ifdef __linux__
  (void)madvise(memory, bytes, MADV_HUGEPAGE);
#endif
}

}  // namespace

void* allocate_huge(std::size_t bytes) {
  const bool large = bytes >= 2 * kHugePage;
  const std::size_t unit = large ? kHugePage : 64;
  const std::size_t rounded = (bytes + unit - 1) / unit * unit;
  void* memory = std::aligned_alloc(unit, rounded == 0 ? unit : rounded);
  if (memory == nullptr) throw std::bad_alloc();
  if (large) advise(memory, rounded);
  return memory;
}

void free_huge(void* memory) noexcept { std::free(memory); }

void advise_huge(void* memory, std::size_t bytes) noexcept {
  if (bytes < 2 * kHugePage) return;
  const std::size_t before = reinterpret_cast<std::uintptr_t>(memory) % kHugePage;
  const std::size_t skipped = before == 0 ? 0 : kHugePage - before;
  advise(static_cast<char*>(memory) + skipped, (bytes - skipped) / kHugePage * kHugePage);
}

}  // namespace limn::base::detail
