#include "limn/report/stencil_report.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace limn::report {
namespace {

using Place = study::RulePicture::Place;

bool same_place(const Place& a, const Place& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]) < 1e-6;
}

std::string heading(const study::RulePicture& picture) {
  std::string text(rule_name(picture.kind));
  if (picture.valence > 0) text += fmt::format(", n = {}", picture.valence);
  if (!picture.when.empty()) text += fmt::format(" (when {})", picture.when);
  return text;
}

/// Letters on a grid of cells.
class LetterGrid {
 public:
  /// With its middle there; where that would touch other letters, in the nearest row that has room.
  void put(double column, double row, const std::string& text) {
    const int width = static_cast<int>(text.size());
    const int first = static_cast<int>(std::lround(column - (width - 1) / 2.));
    const int wanted = static_cast<int>(std::lround(row));
    for (int away = 0;; ++away)
      for (const int at : {wanted + away, wanted - away}) {
        if (!is_free(at, first - 1, first + width + 1)) continue;
        for (int i = 0; i < width; ++i) rows_[at][first + i] = text[static_cast<std::size_t>(i)];
        return;
      }
  }
  /// The same for a mark that may be left out.
  void put_if_free(double column, double row, char mark) {
    const int first = static_cast<int>(std::lround(column)),
              at = static_cast<int>(std::lround(row));
    if (is_free(at, first, first + 1)) rows_[at][first] = mark;
  }

  [[nodiscard]] std::string text(int indent) const {
    int left = 0;
    bool any = false;
    for (const auto& [row, cells] : rows_) {
      left = any ? std::min(left, cells.begin()->first) : cells.begin()->first;
      any = true;
    }
    std::string result;
    for (int row = rows_.begin()->first; row <= rows_.rbegin()->first; ++row) {
      const auto found = rows_.find(row);
      if (found != rows_.end()) {
        std::string line(static_cast<std::size_t>(indent), ' ');
        int column = left;
        for (const auto& [at, letter] : found->second) {
          line.append(static_cast<std::size_t>(at - column), ' ');
          line += letter;
          column = at + 1;
        }
        result += line;
      }
      result += '\n';
    }
    return result;
  }

 private:
  [[nodiscard]] bool is_free(int row, int begin, int end) const {
    const auto found = rows_.find(row);
    if (found == rows_.end()) return true;
    const auto next = found->second.lower_bound(begin);
    return next == found->second.end() || next->first >= end;
  }

  std::map<int, std::map<int, char>> rows_;
};

std::string letters_of(const study::RulePicture& picture) {
  std::size_t widest = 3;
  for (const study::RulePicture::Spot& spot : picture.weights)
    widest = std::max(widest, spot.weight.size() + (spot.of_face ? 1 : 0));
  const double columns = static_cast<double>(widest) + 6, rows = std::max(2., columns / 2.6);
  LetterGrid grid;
  bool marked = false;
  for (const bool at_new : {true, false})  // the new vertex keeps its place
    for (const study::RulePicture::Spot& spot : picture.weights) {
      if (same_place(spot.at, picture.made) != at_new) continue;
      std::string text = (spot.of_face ? "F" : "") + spot.weight;
      if (at_new) text = "[" + text + "]";
      marked = marked || at_new;
      grid.put(columns * spot.at[0], -rows * spot.at[1], text);
    }
  if (!marked) grid.put(columns * picture.made[0], -rows * picture.made[1], "[ ]");
  for (const Place& vertex : picture.vertices)
    grid.put_if_free(columns * vertex[0], -rows * vertex[1], '.');
  return grid.text(4);
}

figure::NetPanel panel_of(const study::RulePicture& picture) {
  figure::NetPanel panel;
  panel.title = heading(picture);
  panel.place_labels = true;
  const auto net = [&](figure::Colour colour, double dot) {
    panel.nets.emplace_back();
    panel.nets.back().colour = colour;
    panel.nets.back().dot = dot;
    return panel.nets.size() - 1;
  };
  const std::size_t lines = net(figure::grey(0.7), 0), old = net({}, 1.6),
                    faces = net({0.1, 0.3, 0.8}, 1.6), made = net({0.85, 0.1, 0.1}, 2.6);
  panel.nets[lines].vertices = picture.vertices;
  panel.nets[lines].edges = picture.edges;
  for (const study::RulePicture::Spot& spot : picture.weights) {
    panel.nets[spot.of_face ? faces : old].vertices.push_back(spot.at);
    panel.labels.push_back({.at = spot.at, .text = spot.weight});
  }
  panel.nets[made].vertices = {picture.made};
  return panel;
}

}  // namespace

std::string stencils_text(const std::vector<study::RulePicture>& pictures) {
  std::string text =
      "\nstencils: weights where their vertices are, F that of a face's new vertex, "
      "[ ] the new vertex\n";
  for (const study::RulePicture& picture : pictures)
    text += fmt::format("\n  {}\n\n{}", heading(picture), letters_of(picture));
  return text;
}

nlohmann::ordered_json stencils_json(const std::vector<study::RulePicture>& pictures) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const study::RulePicture& picture : pictures) {
    Json weights = Json::array();
    for (const study::RulePicture::Spot& spot : picture.weights)
      weights.push_back({{"at", spot.at}, {"weight", spot.weight}, {"face", spot.of_face}});
    list.push_back({{"rule", rule_name(picture.kind)},
                    {"when", picture.when.empty() ? Json() : Json(picture.when)},
                    {"valence", picture.valence > 0 ? Json(picture.valence) : Json()},
                    {"new", picture.made},
                    {"weights", std::move(weights)}});
  }
  return list;
}

figure::Figure stencils_figure(const std::string& scheme,
                               const std::vector<study::RulePicture>& pictures) {
  constexpr int kColumns = 3;
  figure::Figure figure(std::clamp(static_cast<int>(pictures.size()), 1, kColumns));
  figure.title(fmt::format("Stencils of {}", scheme));
  for (const study::RulePicture& picture : pictures) figure.add(panel_of(picture));
  return figure;
}

}  // namespace limn::report
