#pragma once
/// Content of many like parts, made block by block on all threads: no more than a few blocks are in
/// memory at once, and they stay in the caches.

#include <algorithm>
#include <array>
#include <string>

#include "limn/base/files/file.h"
#include "limn/base/parallel.h"
#include "limn/mesh/polygons.h"

namespace limn::io {

/// Gives `sink`, in order, what `format(first, last, out)` appends to the empty string `out` for
/// consecutive blocks [first, last) of [0, count).
template <class Format>
void write_blocks(Index count, const base::Sink& sink, const Format& format) {
  constexpr std::ptrdiff_t kBlock = 4096;  // vertices or faces: some 100 kB
  std::array<std::string, 16> blocks;
  constexpr auto kBatch = static_cast<std::ptrdiff_t>(blocks.size()) * kBlock;
  for (std::ptrdiff_t begin = 0; begin < count; begin += kBatch) {
    const auto end = static_cast<Index>(std::min<std::ptrdiff_t>(begin + kBatch, count));
    base::parallel_for(
        static_cast<Index>(begin), end,
        [&](Index first, Index last) {
          std::string& out = blocks[static_cast<std::size_t>((first - begin) / kBlock)];
          out.clear();
          format(first, last, out);
        },
        kBlock);
    for (std::ptrdiff_t b = 0; begin + b * kBlock < end; ++b)
      sink(blocks[static_cast<std::size_t>(b)]);
  }
}

}  // namespace limn::io
