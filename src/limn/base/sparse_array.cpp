#include "limn/base/sparse_array.h"

#include <new>

#ifdef __linux__
#include <sys/mman.h>
#else
#include <cstdlib>
#endif

namespace limn {

#ifdef __linux__

SparseArray::SparseArray(std::size_t size) : size_(size) {
  if (size == 0) return;
  const std::size_t bytes = size * sizeof(double);
  void* const memory = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                              MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  // a huge page would bring far more than what is written
  (void)::madvise(memory, bytes, MADV_NOHUGEPAGE);
  data_ = static_cast<double*>(memory);
}

SparseArray::~SparseArray() {
  if (data_ != nullptr) (void)::munmap(data_, size_ * sizeof(double));
}

void SparseArray::drop() noexcept {
  if (data_ != nullptr) (void)::madvise(data_, size_ * sizeof(double), MADV_DONTNEED);
}

#else

SparseArray::SparseArray(std::size_t size)
    : data_(size == 0 ? nullptr : static_cast<double*>(std::calloc(size, sizeof(double)))),
      size_(size) {
  if (size > 0 && data_ == nullptr) throw std::bad_alloc();
}

SparseArray::~SparseArray() { std::free(data_); }

void SparseArray::drop() noexcept {}

#endif

}  // namespace limn
