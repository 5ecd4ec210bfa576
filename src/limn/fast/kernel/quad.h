#pragma once
/// Four numbers that are worked on at once.

namespace limn::fast {

/// Four numbers at once: a point and what comes after it.
template <class Real>
struct Quad {
  typedef Real Type __attribute__((vector_size(4 * sizeof(Real))));
};

}  // namespace limn::fast
