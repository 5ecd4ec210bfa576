#pragma once
/// Colours for numbers, and for series that must be told apart.

#include <vector>

#include "limn/figure/canvas/canvas.h"

namespace limn::figure {

/// A sequence from dark blue to yellow in which equal steps look equal, to the colour-blind and in
/// grey too: viridis, by Nathaniel Smith and Stéfan van der Walt, published under CC0 with
/// matplotlib 1.5 (2015), through 16 of its 256 colours. `t` is clamped to [0, 1].
[[nodiscard]] Colour viridis(double t);

/// The same sequence, `n` ≥ 1 colours at equal steps, each lightened towards white by `lighten` in
/// [0, 1], so that black lines show on the darkest of them.
[[nodiscard]] std::vector<Colour> viridis_bands(int n, double lighten = 0);

/// For signed numbers: blue for negative, near white at 0, red for positive `t` in [−1, 1], which
/// is clamped; equal amounts are equally dark, and the colour-blind tell the signs apart. Through
/// the colours of RdBu by Cynthia Brewer, colorbrewer2.org.
[[nodiscard]] Colour diverging(double t);

/// `colour` mixed with white: 0 gives it back, 1 gives white.
[[nodiscard]] Colour lightened(Colour colour, double amount);

/// Colours that the colour-blind tell apart, for `index` = 0, 1, …: black and then those of Okabe
/// and Ito, "Color Universal Design" (2008), but for the yellow, which is too light for lines.
[[nodiscard]] Colour series_colour(int index);

/// A dash for the series, so that they differ in grey too; the first is solid.
[[nodiscard]] std::vector<double> series_dash(int index);

}  // namespace limn::figure
