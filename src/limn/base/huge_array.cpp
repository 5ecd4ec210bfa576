#include "limn/base/huge_array.h"

#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace limn::detail {
namespace {

constexpr std::size_t kHugePage = std::size_t{2} << 20U;

}  // namespace

void* allocate_huge(std::size_t bytes) {
  const bool large = bytes >= 2 * kHugePage;
  const std::size_t unit = large ? kHugePage : 64;
  const std::size_t rounded = (bytes + unit - 1) / unit * unit;
  void* memory = std::aligned_alloc(unit, rounded == 0 ? unit : rounded);
  if (memory == nullptr) throw std::bad_alloc();
#ifdef __linux__
  // advice only: without huge pages the memory is as good, and slower at first touch
  if (large) (void)madvise(memory, rounded, MADV_HUGEPAGE);
#endif
  return memory;
}

void free_huge(void* memory) noexcept { std::free(memory); }

}  // namespace limn::detail
