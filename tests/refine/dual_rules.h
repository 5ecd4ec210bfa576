#pragma once
/// Rules of dual splits that look beyond their face.

namespace limn::test {

/// Its neighbours, for few corners and for many.
inline constexpr const char* kWider = R"toml(
[roles.corner]
past = "fevfev"
opposite = "efev"

[[corner]]
when = "n < 5"
round = "((k == 0)*n + 3 + 2*cos(2*pi*k/n))/(4*n) - (k == 0)/16"
past = "1/32"
opposite = "1/64"

[[corner]]
round = "((k == 0)*n + 3 + 2*cos(2*pi*k/n))/(4*n) - (k == 0)/16"
past = "1/16"
)toml";

/// One vertex farther.
inline constexpr const char* kFar = R"toml(
[roles.corner]
straight = "vefev"
outward = "fevefev"
skew = "vefevev"

[corner]
round = "((k == 0)*n + 3 + 2*cos(2*pi*k/n))/(4*n) - (k == 0)*3/32"
straight = "1/64"
outward = "1/64"
skew = "1/64"
)toml";

}  // namespace limn::test
