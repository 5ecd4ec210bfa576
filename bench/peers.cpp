// limn beside CGAL, OpenMesh and OpenSubdiv: the same control mesh, the same run, in turns.
//
// What is timed is the refinement of a mesh that the library has already read, up to the last
// level's connectivity and positions. Every measurement is a process of its own:
// - cold: the first refinement of a fresh process, default malloc, so page faults count;
// - warm: the best of several in a process that keeps its memory from one to the next.
// The tables have the least of all rounds. On one thread the time is that of the processor, which
// other programs on the machine hardly change; on two it is that of the clock, which they do.
// Compare only within one run.

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "limn/base/parallel.h"
#include "limn/mesh/io/mesh_file.h"
#include "limn/refine/fast/fast_refiner.h"
#include "limn/refine/refine.h"
#include "peers/control_meshes.h"
#include "peers/peer.h"

namespace limn::peers {
namespace {

/// limn behind the peers' interface.
class LimnPeer final : public Peer {
 public:
  LimnPeer(const std::string& scheme, const Polygons& control)
      : scheme_(find_scheme(scheme).value()),
        result_{Mesh::build(control).value(), control.positions} {}

  void refine(int levels) override {
    Result<Refined<Point3>> result =
        limn::refine(scheme_, std::move(result_.mesh), std::move(result_.values), levels);
    if (!result) throw std::runtime_error(result.error().text());
    result_ = *std::move(result);
  }
  [[nodiscard]] std::size_t vertex_count() const override { return result_.values.size(); }
  [[nodiscard]] Polygons polygons() const override { return result_.mesh.polygons(result_.values); }

 private:
  Scheme scheme_;
  Refined<Point3> result_;
};

/// The quick engine: arrays of numbers and of corners, no mesh.
template <class Real>
class QuickPeer final : public Peer {
 public:
  QuickPeer(Scheme scheme, const Polygons& control)
      : scheme_(std::move(scheme)), control_(Mesh::build(control).value()) {
    for (const Point3& p : control.positions)
      for (const double c : {p.x, p.y, p.z}) points_.push_back(static_cast<Real>(c));
  }

  /// All of it, as for the others: reading the tables counts.
  void refine(int levels) override {
    const Result<FastRefiner> refiner = FastRefiner::make(scheme_, std::move(control_), levels);
    if (!refiner) throw std::runtime_error(refiner.error().text());
    fine_ = HugeArray<Real>(3 * static_cast<std::size_t>(refiner->vertex_count()));
    corners_ = HugeArray<Index>(static_cast<std::size_t>(refiner->corner_count()));
    face_begin_ = HugeArray<Index>(static_cast<std::size_t>(refiner->face_count()) + 1);
    refiner->template evaluate<Real>(points_, fine_);
    refiner->write_faces(corners_);
    refiner->write_face_begin(face_begin_);
  }
  [[nodiscard]] std::size_t vertex_count() const override { return fine_.size() / 3; }
  [[nodiscard]] Polygons polygons() const override {
    Polygons polygons;
    for (std::size_t i = 0; i < fine_.size(); i += 3)
      polygons.positions.push_back({double(fine_[i]), double(fine_[i + 1]), double(fine_[i + 2])});
    polygons.corners.assign(corners_.begin(), corners_.end());
    polygons.face_begin.assign(face_begin_.begin(), face_begin_.end());
    return polygons;
  }

 private:
  Scheme scheme_;
  Mesh control_;
  std::vector<Real> points_;
  HugeArray<Real> fine_;
  HugeArray<Index> corners_, face_begin_;
};

/// nullptr where the scheme has no quick engine.
template <class Real>
std::unique_ptr<Peer> quick_peer(const std::string& name, int threads, const Polygons& control) {
  set_thread_limit(threads);
  Scheme scheme = find_scheme(name).value();
  if (!has_fast_layout(*scheme.split)) return nullptr;
  return std::make_unique<QuickPeer<Real>>(std::move(scheme), control);
}

struct Contender {
  std::string name;
  std::function<std::unique_ptr<Peer>(const Polygons&)> make;
  bool one_thread = true;
};

struct Race {
  Method method;
  std::string scheme;
  int extra_levels;  ///< √3 grows by 3 where the others grow by 4
  bool triangles;
};

const std::vector<Race>& races() {
  static const std::vector<Race> all{{Method::loop, "loop", 0, true},
                                     {Method::catmull_clark, "catmull-clark", 0, false},
                                     {Method::sqrt3, "sqrt3", 1, true},
                                     {Method::modified_butterfly, "butterfly-modified", 0, true},
                                     {Method::doo_sabin, "doo-sabin", 0, false}};
  return all;
}

constexpr int kOurs = 5, kQuick = 2;  // contenders of ours come first, among them that one

std::vector<Contender> contenders(const Race& race) {
  const auto limn = [race](int threads) {
    return [race, threads](const Polygons& control) {
      set_thread_limit(threads);
      return std::make_unique<LimnPeer>(race.scheme, control);
    };
  };
  const auto quick = [race](int threads) {
    return
        [race, threads](const Polygons& c) { return quick_peer<double>(race.scheme, threads, c); };
  };
  const auto openmesh = [race](Precision precision) {
    return [=](const Polygons& c) { return openmesh_peer(race.method, c, precision); };
  };
  return {{"limn", limn(1)},
          {"limn, 2 threads", limn(2), false},
          {"limn quick", quick(1)},
          {"limn quick, 2 threads", quick(2), false},
          {"limn quick float",
           [race](const Polygons& c) { return quick_peer<float>(race.scheme, 1, c); }},
          {"OpenMesh", openmesh(Precision::double_float)},
          {"OpenMesh float", openmesh(Precision::single_float)},
          {"CGAL", [=](const Polygons& c) { return cgal_peer(race.method, c); }},
          {"OpenSubdiv float", [=](const Polygons& c) {
             return opensubdiv_peer(race.method, c, Precision::single_float);
           }}};
}

constexpr double kNever = std::numeric_limits<double>::infinity();

struct Measurement {
  double ns_per_vertex = kNever;
  double bytes_per_vertex = kNever;  ///< at the peak, beyond what the process held before
  double vertices = 0;
};

void keep_least(Measurement& best, const Measurement& other) {
  best.ns_per_vertex = std::min(best.ns_per_vertex, other.ns_per_vertex);
  best.bytes_per_vertex = std::min(best.bytes_per_vertex, other.bytes_per_vertex);
  best.vertices = std::max(best.vertices, other.vertices);
}

double resident_bytes() {
  std::ifstream statm("/proc/self/statm");
  double total = 0, resident = 0;
  statm >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

double nanoseconds(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

Measurement refine_once(const Contender& contender, const Polygons& control, int levels) {
  const std::unique_ptr<Peer> peer = contender.make(control);
  if (!peer) return {};
  const double before = resident_bytes();
  const clockid_t clock = contender.one_thread ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC;
  const double start = nanoseconds(clock);
  peer->refine(levels);
  const double time = nanoseconds(clock) - start;
  const auto vertices = static_cast<double>(peer->vertex_count());
  return {time / vertices, (peak_bytes() - before) / vertices, vertices};
}

Measurement measure(const Contender& contender, const Polygons& control, int levels, bool warm) {
  if (!warm) return refine_once(contender, control, levels);
  constexpr int kRuns = 3;
  mallopt(M_MMAP_MAX, 0);         // all from the heap,
  mallopt(M_TRIM_THRESHOLD, -1);  // which never shrinks
  mallopt(M_ARENA_MAX, 1);
  refine_once(contender, control, levels);
  Measurement best;
  for (int i = 0; i < kRuns; ++i) keep_least(best, refine_once(contender, control, levels));
  return best;
}

/// `measure` in a process of its own; nothing measured where that ends badly.
Measurement measure_apart(const Contender& contender, const Polygons& control, int levels,
                          bool warm) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    const Measurement result = measure(contender, control, levels, warm);
    const bool written = write(ends[1], &result, sizeof result) == sizeof result;
    _exit(written ? 0 : 1);
  }
  close(ends[1]);
  Measurement result;
  if (read(ends[0], &result, sizeof result) != sizeof result) result = {};
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return result;
}

std::string cell(double value, int digits = 0) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "-";
}

void print_header(const std::vector<Contender>& all, const std::string& title) {
  fmt::print("\n{}\n{:<20}{:>6}{:>10}", title, "scheme", "level", "vertices");
  for (const Contender& contender : all) fmt::print("{:>23}", contender.name);
  fmt::print("{:>12}{:>12}\n", "÷ OpenMesh", "÷ best peer");
}

void print_row(const Race& race, int levels, const std::vector<double>& values, double vertices) {
  fmt::print("{:<20}{:>6}{:>10}", race.scheme, levels, vertices);
  for (const double value : values) fmt::print("{:>23}", cell(value));
  const double openmesh = std::min(values[kOurs], values[kOurs + 1]);
  const double best = *std::min_element(values.begin() + kOurs, values.end());
  const double ours = std::min(values[0], values[kQuick]);  // of two that keep doubles
  fmt::print("{:>12}{:>12}\n", std::isfinite(openmesh) ? cell(ours / openmesh, 2) : "-",
             cell(ours / best, 2));
}

struct Settings {
  std::string mesh, scheme;
  int level = 4;
  int rounds = 3;
};

struct Controls {
  Polygons triangles, polygons;
};

Controls controls(const Settings& settings) {
  constexpr unsigned kSeed = 1;
  if (settings.mesh.empty())
    return {random_sphere(4, 800, 12, kSeed), cut_into_quads(random_sphere(3, 200, 12, kSeed))};
  Result<Polygons> mesh = read_mesh(settings.mesh);
  if (!mesh) throw std::runtime_error(mesh.error().text());
  return {triangulated(*mesh), *mesh};
}

void print_machine() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  std::string line, model = "unknown";
  while (std::getline(cpuinfo, line))
    if (line.starts_with("model name")) model = line.substr(line.find(':') + 2);
#if defined(__clang__)
  const char* compiler = "clang " __clang_version__;
#else
  const char* compiler = "g++ " __VERSION__;
#endif
  fmt::print("{}, {} processors; {}{}\n", model, sysconf(_SC_NPROCESSORS_ONLN), compiler,
#if defined(NDEBUG)
             ""
#else
             "; NOT OPTIMISED: assertions are on"
#endif
  );
}

/// One row of each table: cold, warm, memory.
void run_race(const Race& race, const Settings& settings, const Controls& meshes,
              std::vector<std::function<void()>> (&rows)[3]) {
  const std::vector<Contender> all = contenders(race);
  const Polygons& control = race.triangles ? meshes.triangles : meshes.polygons;
  const int levels = settings.level + race.extra_levels;
  std::vector<Measurement> cold(all.size()), warm(all.size());
  for (int round = 0; round < settings.rounds; ++round)
    for (std::size_t i = 0; i < all.size(); ++i) {
      keep_least(cold[i], measure_apart(all[i], control, levels, false));
      keep_least(warm[i], measure_apart(all[i], control, levels, true));
    }
  std::vector<double> columns[3];
  for (std::size_t i = 0; i < all.size(); ++i) {
    columns[0].push_back(cold[i].ns_per_vertex);
    columns[1].push_back(warm[i].ns_per_vertex);
    columns[2].push_back(cold[i].bytes_per_vertex);
  }
  for (int table = 0; table < 3; ++table)
    rows[table].push_back([=, values = columns[table], vertices = cold[0].vertices] {
      print_row(race, levels, values, vertices);
    });
}

void run(const Settings& settings) {
  print_machine();
  set_thread_limit(1);  // a process with other threads must not fork
  const Controls meshes = controls(settings);
  std::vector<std::function<void()>> rows[3];
  for (const Race& race : races())
    if (settings.scheme.empty() || settings.scheme == race.scheme)
      run_race(race, settings, meshes, rows);
  const char* titles[3] = {"cold, ns/vertex", "warm, ns/vertex", "peak memory, bytes/vertex"};
  for (int table = 0; table < 3; ++table) {
    print_header(contenders(races()[0]), titles[table]);
    for (const auto& row : rows[table]) row();
  }
}

}  // namespace
}  // namespace limn::peers

int main(int argc, char** argv) {
  limn::peers::Settings settings;
  CLI::App app("limn beside CGAL, OpenMesh and OpenSubdiv");
  app.add_option("mesh", settings.mesh, "control mesh; without it, one is made");
  app.add_option("--level", settings.level, "levels of refinement (sqrt3: one more)");
  app.add_option("--rounds", settings.rounds, "how often everything is measured");
  app.add_option("--scheme", settings.scheme, "only this one");
  app.add_option("--benchmark_filter", "for the other programs of ./dev bench; without effect")
      ->group("");
  CLI11_PARSE(app, argc, argv);
  try {
    limn::peers::run(settings);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
