#include "limn/base/sparse_array.h"

#include <cstdint>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#else
#include <cstdlib>
#endif

namespace limn::base {

#ifdef __linux__

SparseArray::SparseArray(std::size_t size, Pages pages) : size_(size) {
  if (size == 0) return;
  const std::size_t bytes = size * sizeof(double);
  void* const memory = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                              MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  (void)::madvise(memory, bytes, pages == Pages::huge ? MADV_HUGEPAGE : MADV_NOHUGEPAGE);
  data_ = static_cast<double*>(memory);
}

SparseArray::~SparseArray() {
  if (data_ != nullptr) (void)::munmap(data_, size_ * sizeof(double));
}

void SparseArray::prepare([[maybe_unused]] std::size_t first,
                          [[maybe_unused]] std::size_t count) noexcept {
#ifdef MADV_POPULATE_WRITE
  constexpr std::uintptr_t kPage = 4096;
  constexpr std::uintptr_t kFew = 4;  // as many faults cost as little
  const auto begin = reinterpret_cast<std::uintptr_t>(data_ + first) / kPage * kPage;
  const auto end = reinterpret_cast<std::uintptr_t>(data_ + first + count);
  if (end - begin < kFew * kPage) return;
  (void)::madvise(reinterpret_cast<void*>(begin), (end - begin + kPage - 1) / kPage * kPage,
                  MADV_POPULATE_WRITE);
#endif
}

void SparseArray::drop() noexcept {
  if (data_ != nullptr) (void)::madvise(data_, size_ * sizeof(double), MADV_DONTNEED);
}

#else

SparseArray::SparseArray(std::size_t size, Pages)
    : data_(size == 0 ? nullptr : static_cast<double*>(std::calloc(size, sizeof(double)))),
      size_(size) {
  if (size > 0 && data_ == nullptr) throw std::bad_alloc();
}

SparseArray::~SparseArray() { std::free(data_); }

void SparseArray::prepare(std::size_t, std::size_t) noexcept {}
void SparseArray::drop() noexcept {}

#endif

}  // namespace limn::base
