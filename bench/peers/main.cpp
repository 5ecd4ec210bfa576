// limn beside CGAL, OpenMesh and OpenSubdiv: the same control meshes, the same run, in turns; the
// tables are Markdown.
//
// Full refinement is that of a mesh that the library has already read, up to the last level's
// connectivity and positions. Of repeated evaluation only the positions are made. Every measurement
// is a process of its own (measure.h); the tables have the least of all rounds.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "limn/base/parallel.h"
#include "limn/mesh/io/mesh_file.h"
#include "peers/control_meshes.h"
#include "races.h"
#include "tables.h"

namespace limn::peers {
namespace {

struct Settings {
  std::string mesh, scheme, part;
  int level = 0;  ///< 0: as deep as makes about three million vertices
  double sharp = 0.05;
  bool texture = true;
  int rounds = 1;
};

Control own_control(std::string name, int triangle_levels, int quad_levels, int level) {
  constexpr unsigned kSeed = 1;
  const auto sphere = [](int levels) {
    const int flips = 200 << (2 * (levels - 3));
    return random_sphere(levels, flips, 12, kSeed);
  };
  return {std::move(name), sphere(triangle_levels), cut_into_quads(sphere(quad_levels)), level};
}

std::vector<Control> controls(const Settings& settings) {
  std::vector<Control> all;
  if (settings.mesh.empty()) {
    all.push_back(own_control("sphere of 2562 vertices (quads: 3842)", 4, 3, 5));
    all.push_back(own_control("sphere of 40 962 vertices (quads: 61 442)", 6, 5, 3));
  } else {
    Result<Polygons> mesh = read_mesh(settings.mesh);
    if (!mesh) throw std::runtime_error(mesh.error().text());
    const std::string name = settings.mesh.substr(settings.mesh.rfind('/') + 1);
    int level = 1;
    while (mesh->vertex_count() * (1.0 * (1 << (2 * level))) < 1.6e6) ++level;
    all.push_back({fmt::format("{}, {} vertices", name, mesh->vertex_count()), triangulated(*mesh),
                   *mesh, level});
  }
  for (Control& control : all)
    if (settings.level > 0) control.level = settings.level;
  const std::size_t plain = all.size();
  for (std::size_t i = 0; i < plain && settings.sharp > 0; ++i)
    all.push_back(with_sharp_edges(all[i], settings.sharp));
  for (std::size_t i = 0; i < plain && settings.texture; ++i) all.push_back(with_texture(all[i]));
  return all;
}

/// All contenders in turns; both manners where the work is full refinement.
Outcome outcome_of(const Race& race, const Control& control, int rounds, bool full) {
  const std::vector<Contender> contenders =
      full ? full_refinement(race, control) : repeated_evaluation(race, control);
  Outcome outcome{race.name, race.steps(control.level), {}, {}, 0};
  Trial::Size size;
  for (const Contender& c : contenders)
    outcome.entries.push_back({c.name, c.ours, c.threads, {}, {}});
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      Entry& entry = outcome.entries[i];
      entry.warm.keep_least(measure(contenders[i], full ? Manner::warm : Manner::again));
      // after its own warm runs, so that all find the system's free pages in a like state
      if (full) entry.cold.keep_least(measure(contenders[i], Manner::cold));
      size.vertices = std::max(size.vertices, entry.warm.size.vertices);
      size.corners = std::max(size.corners, entry.warm.size.corners);
    }
  if (size.vertices == 0) return outcome;
  outcome.floor = measure(floor_of(size), Manner::again);
  outcome.floor_bytes = floor_bytes(size);
  return outcome;
}

void print_part(const Settings& settings, const std::vector<Race>& all, const Control& control,
                bool full, std::vector<Summary>& summaries) {
  Summary summary{fmt::format("{}, {}", full ? "Full refinement" : "Positions again", control.name),
                  {}};
  for (const Race& race : all) {
    Outcome outcome = outcome_of(race, control, settings.rounds, full);
    if (outcome.floor_bytes == 0) continue;  // nobody can do it
    if (summary.outcomes.empty()) (full ? print_full_head : print_again_head)(control.name);
    (full ? print_full : print_again)(outcome);
    std::fflush(stdout);
    summary.outcomes.push_back(std::move(outcome));
  }
  if (!summary.outcomes.empty()) summaries.push_back(std::move(summary));
}

void run(const Settings& settings) {
  print_machine();
  set_thread_limit(1);  // a process with other threads must not fork
  const std::vector<Race> all = races(settings.scheme);
  const std::vector<Control> meshes = controls(settings);
  std::vector<Summary> summaries;
  for (const bool full : {true, false})
    for (const Control& control : meshes)
      if (settings.part.empty() || (settings.part == "full") == full)
        print_part(settings, all, control, full, summaries);
  print_summaries(summaries);
}

int run_command(int argc, char** argv) {
  Settings settings;
  CLI::App app("limn beside CGAL, OpenMesh and OpenSubdiv");
  app.add_option("mesh", settings.mesh, "control mesh; without it, two are made");
  app.add_option("--level", settings.level,
                 "levels of refinement (sqrt3: one more); without it, to about 3 million vertices");
  app.add_option("--rounds", settings.rounds, "how often everything is measured")
      ->capture_default_str();
  app.add_option("--scheme", settings.scheme, "only this one; a scheme that is shipped, or a file");
  app.add_option("--sharp", settings.sharp,
                 "every control mesh again, with so large a share of its edges sharp; 0: not")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1.0));
  app.add_flag("--texture,!--no-texture", settings.texture,
               "every control mesh again, with texture coordinates that have seams");
  app.add_option("--only", settings.part,
                 "full: full refinement; again: positions, the topology being known")
      ->check(CLI::IsMember({"full", "again"}));
  app.add_option("--benchmark_filter", "for the other programs of ./dev bench; without effect")
      ->group("");
  CLI11_PARSE(app, argc, argv);
  run(settings);
  return 0;
}

}  // namespace
}  // namespace limn::peers

int main(int argc, char** argv) {
  try {
    return limn::peers::run_command(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
  } catch (...) {
    std::fputs("an unknown exception\n", stderr);
  }
  return 1;
}
