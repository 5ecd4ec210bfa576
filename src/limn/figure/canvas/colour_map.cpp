#include "limn/figure/canvas/colour_map.h"

#include <algorithm>
#include <cmath>

namespace limn::figure {
namespace {

constexpr Colour from_bytes(int red, int green, int blue) {
  return {red / 255.0, green / 255.0, blue / 255.0, 1};
}

constexpr std::array kViridis = {
    from_bytes(68, 1, 84),    from_bytes(72, 26, 108),  from_bytes(71, 47, 125),
    from_bytes(65, 68, 135),  from_bytes(57, 86, 140),  from_bytes(49, 104, 142),
    from_bytes(42, 120, 142), from_bytes(35, 136, 142), from_bytes(31, 152, 139),
    from_bytes(34, 168, 132), from_bytes(53, 183, 121), from_bytes(83, 198, 105),
    from_bytes(122, 209, 81), from_bytes(165, 219, 54), from_bytes(210, 226, 27),
    from_bytes(253, 231, 37)};

constexpr std::array kDiverging = {
    from_bytes(33, 102, 172),  from_bytes(67, 147, 195),  from_bytes(146, 197, 222),
    from_bytes(209, 229, 240), from_bytes(247, 247, 247), from_bytes(253, 219, 199),
    from_bytes(244, 165, 130), from_bytes(214, 96, 77),   from_bytes(178, 24, 43)};

constexpr std::array kSeries = {from_bytes(0, 0, 0),       from_bytes(0, 114, 178),
                                from_bytes(213, 94, 0),    from_bytes(0, 158, 115),
                                from_bytes(204, 121, 167), from_bytes(230, 159, 0),
                                from_bytes(86, 180, 233)};

Colour mixed(const Colour& a, const Colour& b, double t) {
  const auto mix = [t](double x, double y) { return x + t * (y - x); };
  return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue), mix(a.alpha, b.alpha)};
}

/// At t in [0, 1] of a sequence of colours.
template <std::size_t n>
Colour along(const std::array<Colour, n>& colours, double t) {
  const double at = (std::isnan(t) ? 0 : std::clamp(t, 0.0, 1.0)) * (n - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(at), n - 2);
  return mixed(colours[i], colours[i + 1], at - static_cast<double>(i));
}

}  // namespace

Colour viridis(double t) { return along(kViridis, t); }

Colour diverging(double t) { return along(kDiverging, std::isnan(t) ? 0.5 : (t + 1) / 2); }

std::vector<Colour> viridis_bands(int n, double lighten) {
  std::vector<Colour> bands;
  bands.reserve(static_cast<std::size_t>(std::max(n, 0)));
  for (int i = 0; i < n; ++i)
    bands.push_back(lightened(viridis(n == 1 ? 0.5 : i / (n - 1.0)), lighten));
  return bands;
}

Colour lightened(Colour colour, double amount) {
  return mixed(colour, {1, 1, 1, colour.alpha}, amount);
}

Colour series_colour(int index) {
  return kSeries[static_cast<std::size_t>(index) % kSeries.size()];
}

std::vector<double> series_dash(int index) {
  // Caps are round and add the line's width to each dash.
  static const std::vector<std::vector<double>> dashes = {
      {}, {4, 2.2}, {0.1, 1.9}, {5, 2, 0.1, 2}, {2, 2.2}, {6, 2, 0.1, 2, 0.1, 2}};
  return dashes[static_cast<std::size_t>(index) % dashes.size()];
}

}  // namespace limn::figure
