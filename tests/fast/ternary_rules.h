#pragma once
/// Rules of the engine's tests on splits that cut edges in three.

namespace limn::test {

/// Rules on thirds that look as far as two rings, at edges' ends too, and differ by valence.
inline constexpr const char* kWideTernary = R"toml(
[roles.vertex]
straight = "vefefev"

[roles.face]
outer = "fvev"

[roles.edge-third]
over = "evefefev"

[[vertex]]
when = "n == 5"
self = "1/2"
ring = "1/(4*n)"
across = "1/(4*n)"

[[vertex]]
self = "5/8 - 1/16"
ring = "3/(8*n)"
straight = "1/(16*n)"

[edge-third]
near = "5/8"
far = "1/4"
wing = "1/16"
far-outer = "1/64"
over = "-1/64"

[[edge-end]]
when = "n == 7 or n == 6"
self = "3/4"
ring = "(1/4)/n + cos(2*pi*k/n)/(2*n)"

[face]
corner = "3/8"
beyond = "1/96"
outer = "-5/96"

[[boundary.vertex]]
when = "n < 4"
self = "7/8"
next = "1/16"

[[boundary.vertex]]
self = "3/4"
next = "1/8"

[boundary.edge-end]
near = "3/4"
far = "3/8"
beyond = "-1/8"
)toml";

/// The cubic B-spline in both directions, cut in three.
inline constexpr const char* kTernaryQuads = R"toml(
[roles.edge-third]
behind-wing = "efvev"

[roles.corner]
behind = "efev"
beside = "efvev"
opposite = "efefvev"

[vertex]
self = "361/729"
ring = "304/(729*n)"
diagonal = "64/(729*n)"

[edge-third]
near = "304/729"
far = "190/729"
opposite = "19/729"
wing = "64/729"
far-wing = "40/729"
behind-wing = "4/729"

[[edge-end]]
when = "n == 5"
self = "3/4"
ring = "(1/4)/n + cos(2*pi*k/n)/(2*n)"

[corner]
round = "((k == 0)*256 + (k == 1 or k == 3)*160 + (k == 2)*100)/729"
behind = "16/729"
beside = "10/729"
opposite = "1/729"

[boundary.vertex]
self = "19/27"
next = "4/27"

[boundary.edge-end]
near = "16/27"
far = "10/27"
beyond = "1/27"
)toml";

}  // namespace limn::test
