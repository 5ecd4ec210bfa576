#pragma once
/// The one place for parallel loops. Ranges are cut into chunks whose bounds depend on the
/// grain alone, never on the number of threads: a body that writes each element from its index
/// (or each chunk's sum to the chunk's own slot) gives the same bits however many threads run.

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>

#include "limn/base/budget.h"

namespace limn::base {

inline constexpr std::ptrdiff_t kDefaultGrain = 4096;

namespace detail {
/// Calls chunk(context, c) for c = 0 … count-1, each once, in any order, and waits.
void run_chunks(std::ptrdiff_t count, void (*chunk)(void* context, std::ptrdiff_t c),
                void* context);
}  // namespace detail

/// body(first, last) for the chunks [first, last) of [begin, end), at most `grain` long, that
/// start at begin + c * grain. The chunks may run at the same time and in any order; what a body
/// throws is thrown on, once. Without TBB: the same chunks, one after the other.
template <class I, class Body>
void parallel_for(std::type_identity_t<I> begin, I end, Body&& body,
                  std::ptrdiff_t grain = kDefaultGrain) {
  const auto length = static_cast<std::ptrdiff_t>(end) - static_cast<std::ptrdiff_t>(begin);
  if (length <= 0) return;
  struct Context {
    std::remove_reference_t<Body>* body;
    std::ptrdiff_t begin, end, grain;
  } context{std::addressof(body), static_cast<std::ptrdiff_t>(begin),
            static_cast<std::ptrdiff_t>(end), std::max<std::ptrdiff_t>(grain, 1)};
  const auto chunk = [](void* opaque, std::ptrdiff_t c) {
    const Context& in = *static_cast<const Context*>(opaque);
    const std::ptrdiff_t first = in.begin + c * in.grain;
    const std::ptrdiff_t last = in.end - first < in.grain ? in.end : first + in.grain;
    (*in.body)(static_cast<I>(first), static_cast<I>(last));
  };
  detail::run_chunks((length - 1) / context.grain + 1, chunk, &context);
}

/// body(i) for every i of [0, count).
template <class I, class Body>
void parallel_for_each(I count, Body&& body) {
  parallel_for(I{0}, count, [&body](I first, I last) {
    for (I i = first; i < last; ++i) body(i);
  });
}

}  // namespace limn::base
