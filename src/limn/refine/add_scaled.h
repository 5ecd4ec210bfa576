#pragma once
/// What refinement asks of a value type.

#include "limn/mesh/polygons.h"

namespace limn::refine {

/// sum += weight · value. Overload it for a value type that has a quicker way.
template <class Number, class Value>
void add_scaled(Value& sum, const Number& weight, const Value& value) {
  sum += weight * value;
}
inline void add_scaled(Point3& sum, double weight, const Point3& value) {
  sum.x += weight * value.x;
  sum.y += weight * value.y;
  sum.z += weight * value.z;
}

}  // namespace limn::refine
