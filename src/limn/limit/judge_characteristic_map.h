#pragma once
/// What samples of a characteristic map say.

#include "limn/limit/characteristic_map.h"

namespace limn::limit {

/// Sets all but the net, the image and the eigenvalue, from these; turns back what is turned over.
void judge_characteristic_map(CharacteristicMap& map);

}  // namespace limn::limit
