#pragma once
/// The memory that refinement takes together with what is asked of the limit surface.

#include "limn/refine/refine_estimate.h"
#include "limn/scheme/scheme.h"

namespace limn::surface {

struct LimitWork {
  bool quick = true;        ///< by the quick engine, where it can
  bool limit = false;       ///< limit points or normals
  bool curvatures = false;  ///< and a table of curvatures, written as text
  bool written = false;     ///< into a file while it is made (refined_file.h), where it can be
  int columns = 0;          ///< further points for each vertex, of attributes
};

/// What `levels` steps and the work on their result take at most, from counts alone: an upper bound
/// within about half of what was measured for loop, butterfly, sqrt3, catmull-clark and doo-sabin
/// (tests/command/memory_test.cpp). Small fixed costs are left out. Cost O(levels).
[[nodiscard]] refine::RefineEstimate estimate_with_limit(const Scheme& scheme, const Mesh& control,
                                                         int levels, const LimitWork& work);

}  // namespace limn::surface
