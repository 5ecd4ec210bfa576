#include <cmath>
#include <numbers>

#include <fmt/core.h>

#include "limn/limit/characteristic_map.h"
#include "limn/spectrum/eigencomponents.h"
#include "papers/barthe_parts.h"

namespace limn::bgsk {
namespace {

constexpr int kValence = 5;

/// The paper's letters: B the first ring, D beyond it on the spokes, C between them.
char letter(const Orbit& orbit) {
  if (orbit.ring == 1) return 'B';
  return orbit.angle == 0 ? 'D' : 'C';
}

std::string index_text(double angle) {
  const int halves = static_cast<int>(std::lround(2 * angle));
  if (halves % 2 == 0) return fmt::format("{}", halves / 2);
  return halves == 1 ? "½" : fmt::format("{}½", halves / 2);
}

figure::PagePoint turned(const Point3& p, double angle, double scale) {
  return {scale * (p.x * std::cos(angle) - p.y * std::sin(angle)),
          scale * (p.x * std::sin(angle) + p.y * std::cos(angle))};
}

/// A step multiplies the characteristic map's net by the tangent's eigenvalue; √3 turns it too, by
/// half a sector.
Result<figure::NetPanel> label_panel(const Scheme& scheme, const FrequencyBlocks& blocks,
                                     const std::string& title) {
  const Result<CharacteristicMap> map = approx_characteristic_map(scheme, kValence, 1);
  if (!map) return map.error();
  const std::vector<StarPlace> places = star_places(blocks);
  const double turn = scheme.split->dilation.turns() ? 0.5 : 0;
  const figure::Colour fine{0.75, 0.1, 0.1, 1};
  figure::NetPanel panel;
  panel.title = title;
  panel.place_labels = true;
  panel.nets = {{.colour = figure::grey(0.45), .stroke = {.width = 0.8}, .dot = 2},
                {.colour = fine, .stroke = {.width = 0.5, .dash = {2, 1.5}}, .dot = 1.6}};
  for (int net = 0; net < 2; ++net) {
    const double sectors = net == 0 ? 0 : turn;
    const double angle = 2 * std::numbers::pi * sectors / kValence;
    for (std::size_t v = 0; v < places.size(); ++v) {
      const figure::PagePoint at =
          turned(map->net_points[v], angle, net == 0 ? 1 : map->eigenvalue);
      panel.nets[static_cast<std::size_t>(net)].vertices.push_back(at);
      const int orbit = places[v].row - 1;
      const char upper = orbit < 0 ? 'A' : letter(blocks.orbits[static_cast<std::size_t>(orbit)]);
      const char shown = net == 0 ? upper : static_cast<char>(upper - 'A' + 'a');
      std::string text = fmt::format("/{{{}}}", shown);
      if (orbit >= 0)
        text += fmt::format("_{{{}}}", index_text(std::fmod(places[v].angle + sectors, kValence)));
      panel.labels.push_back({at, text, {}, net == 0 ? figure::Colour{} : fine});
    }
    for (Index e = 0; e < map->net.edge_count(); ++e) {
      const Index h = map->net.halfedge_of_edge(e);
      const auto last = static_cast<Index>(places.size());
      if (map->net.origin(h) < last && map->net.target(h) < last)
        panel.nets[static_cast<std::size_t>(net)].edges.push_back(
            {map->net.origin(h), map->net.target(h)});
    }
  }
  return panel;
}

}  // namespace

Status add_labels(PaperPage& page) {
  figure::Figure figure(1, 400);  // wide enough for labels between the lines
  report::DescribedTable numbers{
      {{"refinement", "dyadic or √3"},
       {"letter", "of the orbit, old; in small letters of the new one"},
       {"ring", "edges between the orbit and the vertex"},
       {"angle_in_sectors", "rotational position of the orbit's first vertex [sectors of 2π/v]"}},
      {}};
  for (const auto& [name, title] : {std::pair{"loop", "dyadic"}, {"sqrt3", "√3"}}) {
    const Result<Scheme> scheme = find_scheme(name);
    if (!scheme) return scheme.error();
    const Result<FrequencyBlocks> blocks = FrequencyAnalysis(*scheme, 2).blocks(kValence);
    if (!blocks) return blocks.error();
    const Result<figure::NetPanel> panel = label_panel(*scheme, *blocks, title);
    if (!panel) return panel.error();
    figure.add(*panel);
    for (const Orbit& orbit : blocks->orbits)
      numbers.rows.push_back({std::string(title), std::string(1, letter(orbit)),
                              static_cast<double>(orbit.ring), orbit.angle});
  }
  return page.add_figure(
      {"Figure 2", "fig02"}, figure, numbers,
      "a 2-ring configuration round a vertex A: old vertices in capitals, new ones in small "
      "letters, "
      "indices by rotational position, for dyadic and √3 refinement.",
      "the same, from the orbits that limn finds; drawn on the nets of the characteristic maps at "
      "valence 5, where a step is a multiplication by the tangent's eigenvalue (and half a "
      "sector's turn "
      "for √3).");
}

}  // namespace limn::bgsk
