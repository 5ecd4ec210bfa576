#pragma once
/// Turns by angles that are anywhere in an interval, in coordinates that have a limit as the angle
/// tends to 0.
///
/// A sector's turn θ is given by w = θ², of which all that is needed is a smooth function: in the
/// coordinates (p, q/θ) (real_blocks.h) the turn by x sectors is
///   cos xθ,   sin(xθ)/θ = x sinc(x²w),   θ sin xθ = w x sinc(x²w),   sinc(y²) = sin(y)/y.

#include "limn/certify/blocks/real_blocks.h"
#include "limn/number/ball.h"

namespace limn::certify {

/// cos √u and sin √u/√u for all u ≥ 0 in the ball; what a ball around 0 holds below 0 by rounding
/// is enclosed too. To about the square of the ball's radius the result is as narrow as can be.
[[nodiscard]] number::Ball enclose_cosine(const number::Ball& u);
[[nodiscard]] number::Ball enclose_sinc(const number::Ball& u);
/// Derivatives by u.
[[nodiscard]] number::Ball enclose_cosine_slope(const number::Ball& u);
[[nodiscard]] number::Ball enclose_sinc_slope(const number::Ball& u);

/// Turns by sectors of θ² = w, in coordinates (p, q/θ).
[[nodiscard]] Phase<number::Ball> turns_of(const number::Ball& w);
/// Their derivatives by w.
[[nodiscard]] Phase<number::Ball> turn_slopes_of(const number::Ball& w);
/// (1 - turn)/w in the row of p: of the others nothing, 0.
[[nodiscard]] Phase<number::Ball> turn_losses_of(const number::Ball& w);

}  // namespace limn::certify
