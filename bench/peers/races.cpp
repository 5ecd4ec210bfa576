#include "races.h"

#include <array>
#include <cstring>
#include <functional>
#include <random>
#include <stdexcept>
#include <utility>

#include <fmt/core.h>

#include "limn/base/huge_array.h"
#include "limn/base/parallel.h"
#include "limn/fast/fast_refiner.h"
#include "limn/mesh/sharpness/sharpness.h"
#include "limn/refine/refine.h"
#include "limn/surface/refine_surface.h"
#include "peers/repeated_peer.h"

namespace limn::peers {
namespace {

template <class T>
T value_or_throw(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().text());
  return *std::move(result);
}

Sharpness sharpness_of(const Mesh& mesh, const PeerTags& tags) {
  SharpnessTags ours;
  for (std::size_t i = 0; i < tags.edges.size(); ++i)
    ours.creases.push_back(
        {{tags.edges[i][0], tags.edges[i][1]}, {double(tags.edge_sharpness[i])}});
  Sharpness sharpness;
  if (Status status = apply_tags(mesh, {}, ours, sharpness); !status)
    throw std::runtime_error(status.error().text());
  return sharpness;
}

PeerTags sharp_edges(const Polygons& control, double share) {
  const Mesh mesh = value_or_throw(Mesh::build(control));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  PeerTags tags;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    if (unit(random) >= share) continue;
    const Index h = mesh.halfedge_of_edge(e);
    tags.edges.push_back({mesh.origin(h), mesh.target(h)});
    const bool stays = unit(random) < 0.2;
    tags.edge_sharpness.push_back(stays ? 10 : 0.5F * static_cast<float>(1 + random() % 8));
  }
  return tags;
}

class PlainTrial final : public Trial {
 public:
  PlainTrial(const Scheme& scheme, const Polygons& control, int steps, const PeerTags& tags)
      : scheme_(scheme),
        steps_(steps),
        result_{value_or_throw(Mesh::build(control)), control.positions},
        sharpness_(sharpness_of(result_.mesh, tags)) {}

  void run() override {
    result_ =
        value_or_throw(refine::refine(scheme_, std::move(result_.mesh), std::move(result_.values),
                                      steps_, {}, std::move(sharpness_)));
  }
  [[nodiscard]] Size size() const override {
    return {double(result_.mesh.vertex_count()), double(result_.mesh.halfedge_count())};
  }

 private:
  const Scheme& scheme_;
  int steps_;
  refine::Refined<Point3> result_;
  Sharpness sharpness_;
};

template <class Real>
std::vector<Real> numbers_of(const std::vector<Point3>& points) {
  std::vector<Real> numbers;
  for (const Point3& p : points)
    for (const double c : {p.x, p.y, p.z}) numbers.push_back(static_cast<Real>(c));
  return numbers;
}

template <class Real>
base::HugeArray<Real> fine_positions(const FastRefiner& refiner) {
  return base::HugeArray<Real>(3 * static_cast<std::size_t>(refiner.vertex_count()));
}

/// The fast engine, all of it, as for the others: reading the tables counts.
template <class Real>
class QuickTrial final : public Trial {
 public:
  QuickTrial(const Scheme& scheme, const Polygons& control, int steps, const PeerTags& tags)
      : scheme_(scheme),
        steps_(steps),
        control_(value_or_throw(Mesh::build(control))),
        sharpness_(sharpness_of(control_, tags)),
        points_(numbers_of<Real>(control.positions)) {}

  void run() override {
    const FastRefiner refiner =
        value_or_throw(FastRefiner::make(scheme_, std::move(control_), steps_, sharpness_));
    fine_ = fine_positions<Real>(refiner);
    corners_ = base::HugeArray<Index>(static_cast<std::size_t>(refiner.corner_count()));
    refiner.template evaluate<Real>(points_, fine_);
    refiner.write_faces(corners_);
    if (refiner.corners_per_face() > 0) return;
    face_begin_ = base::HugeArray<Index>(static_cast<std::size_t>(refiner.face_count()) + 1);
    refiner.write_face_begin(face_begin_);
  }
  [[nodiscard]] Size size() const override {
    return {double(fine_.size()) / 3, double(corners_.size())};
  }

 private:
  const Scheme& scheme_;
  int steps_;
  Mesh control_;
  Sharpness sharpness_;
  std::vector<Real> points_;
  base::HugeArray<Real> fine_;
  base::HugeArray<Index> corners_, face_begin_;
};

template <class Real>
class QuickAgain final : public Trial {
 public:
  QuickAgain(const Scheme& scheme, const Polygons& control, int steps, const PeerTags& tags)
      : refiner_(refiner_of(scheme, value_or_throw(Mesh::build(control)), steps, tags)),
        points_(numbers_of<Real>(control.positions)),
        fine_(fine_positions<Real>(refiner_)) {}

  void run() override { refiner_.template evaluate<Real>(points_, fine_, scratch_); }
  [[nodiscard]] Size size() const override { return {double(fine_.size()) / 3, 0}; }

 private:
  static FastRefiner refiner_of(const Scheme& scheme, Mesh mesh, int steps, const PeerTags& tags) {
    Sharpness sharpness = sharpness_of(mesh, tags);
    return value_or_throw(FastRefiner::make(scheme, std::move(mesh), steps, std::move(sharpness)));
  }

  FastRefiner refiner_;
  std::vector<Real> points_;
  base::HugeArray<Real> fine_;
  typename FastRefiner::Scratch<Real> scratch_;
};

PeerTexture octants(const Polygons& control) {
  PeerTexture texture;
  std::vector<std::array<Index, 8>> point(control.positions.size());
  for (auto& of_vertex : point) of_vertex.fill(kNone);
  for (Index f = 0; f < control.face_count(); ++f) {
    const auto begin = static_cast<std::size_t>(control.face_begin[static_cast<std::size_t>(f)]);
    const auto end = begin + static_cast<std::size_t>(control.degree(f));
    Point3 sum;
    for (std::size_t c = begin; c < end; ++c)
      sum = sum + control.positions[static_cast<std::size_t>(control.corners[c])];
    const std::size_t chart = (sum.x > 0 ? 1U : 0U) + (sum.y > 0 ? 2U : 0U) + (sum.z > 0 ? 4U : 0U);
    for (std::size_t c = begin; c < end; ++c) {
      const auto v = static_cast<std::size_t>(control.corners[c]);
      Index& of_chart = point[v][chart];
      if (of_chart == kNone) {
        of_chart = static_cast<Index>(texture.points.size());
        const Point3& p = control.positions[v];
        texture.points.push_back({p.x + 3 * static_cast<double>(chart), p.y - p.z});
      }
      texture.of_corner.push_back(of_chart);
    }
  }
  return texture;
}

class TexturedTrial final : public Trial {
 public:
  TexturedTrial(const Scheme& scheme, const Polygons& control, int steps,
                const PeerTexture& texture, SurfaceOptions::Engine engine)
      : scheme_(scheme),
        control_(value_or_throw(Mesh::build(control))),
        points_(control.positions) {
    options_.levels = steps;
    options_.engine = engine;
    options_.attributes = &attributes_;
    for (const auto& [u, v] : texture.points) attributes_.texture.points.push_back({u, v});
    attributes_.texture.of_corner = texture.of_corner;
  }

  void run() override {
    fine_ =
        value_or_throw(refine_surface(scheme_, std::move(control_), std::move(points_), options_));
  }
  [[nodiscard]] Size size() const override {
    return {double(fine_.polygons.positions.size()), double(fine_.polygons.corners.size())};
  }

 private:
  const Scheme& scheme_;
  Mesh control_;
  std::vector<Point3> points_;
  MeshAttributes attributes_;
  SurfaceOptions options_;
  RefinedSurface fine_;
};

class PeerTrial final : public Trial {
 public:
  PeerTrial(std::unique_ptr<Peer> peer, int steps) : peer_(std::move(peer)), steps_(steps) {}
  void run() override { peer_->refine(steps_); }
  [[nodiscard]] Size size() const override { return {double(peer_->vertex_count()), 0}; }

 private:
  std::unique_ptr<Peer> peer_;
  int steps_;
};

class PeerAgain final : public Trial {
 public:
  explicit PeerAgain(std::unique_ptr<RepeatedPeer> peer) : peer_(std::move(peer)) {}
  void run() override { peer_->evaluate(); }
  [[nodiscard]] Size size() const override { return {double(peer_->vertex_count()), 0}; }

 private:
  std::unique_ptr<RepeatedPeer> peer_;
};

class FloorTrial final : public Trial {
 public:
  explicit FloorTrial(Size size) : size_(size) {
    const auto bytes = static_cast<std::size_t>(floor_bytes(size));
    do {
      results_.emplace_back(bytes);
      std::memset(results_.back().data(), 0, bytes);
    } while (results_.size() * bytes < kMoreThanCaches);
  }

  /// In turns, so that no cache holds what is written.
  void run() override {
    base::HugeArray<char>& result = results_[next_++ % results_.size()];
    std::memset(result.data(), 1, result.size());
    asm volatile("" : : "r"(result.data()) : "memory");  // somebody might read it
  }
  [[nodiscard]] Size size() const override { return size_; }

 private:
  static constexpr std::size_t kMoreThanCaches = std::size_t{512} << 20U;
  Size size_;
  std::vector<base::HugeArray<char>> results_;
  std::size_t next_ = 0;
};

/// A contender of ours: a trial of type T, made from these arguments, on so many threads.
template <class T>
Contender of_ours(std::string name, int threads, const Race& race, const Control& control) {
  return {std::move(name), true, threads, [&race, &control, threads] {
            set_thread_limit(threads);
            return std::make_unique<T>(race.scheme, control.of(race), race.steps(control.level),
                                       control.tags_of(race));
          }};
}

std::vector<Contender> textured_refinement(const Race& race, const Control& control) {
  std::vector<Contender> all;
  const auto ours = [&](const std::string& name, int threads, SurfaceOptions::Engine engine) {
    all.push_back({name, true, threads, [&race, &control, threads, engine] {
                     set_thread_limit(threads);
                     return std::make_unique<TexturedTrial>(race.scheme, control.of(race),
                                                            race.steps(control.level),
                                                            control.texture_of(race), engine);
                   }});
  };
  ours("limn plain", 1, SurfaceOptions::Engine::plain);
  ours("limn quick", 1, SurfaceOptions::Engine::quick);
  ours("limn quick, 2 threads", 2, SurfaceOptions::Engine::quick);
  if (!race.method) return all;
  all.push_back({"OpenSubdiv, float", false, 1, [&race, &control]() -> std::unique_ptr<Trial> {
                   std::unique_ptr<Peer> peer = opensubdiv_textured_peer(
                       *race.method, control.of(race), control.texture_of(race));
                   if (!peer) return nullptr;
                   return std::make_unique<PeerTrial>(std::move(peer), race.steps(control.level));
                 }});
  return all;
}

/// On one thread and on two.
template <class T>
void add_ours(std::vector<Contender>& all, const std::string& name, const Race& race,
              const Control& control) {
  all.push_back(of_ours<T>(name, 1, race, control));
  all.push_back(of_ours<T>(name + ", 2 threads", 2, race, control));
}

template <class Make>
Contender of_theirs(std::string name, const Race& race, const Control& control, Make make) {
  return {std::move(name), false, 1, [&race, &control, make]() -> std::unique_ptr<Trial> {
            std::unique_ptr<Peer> peer =
                make(*race.method, control.of(race), control.tags_of(race));
            if (!peer) return nullptr;
            return std::make_unique<PeerTrial>(std::move(peer), race.steps(control.level));
          }};
}

template <class Make>
Contender of_theirs_again(std::string name, int threads, const Race& race, const Control& control,
                          Make make) {
  return {std::move(name), false, threads,
          [&race, &control, threads, make]() -> std::unique_ptr<Trial> {
            set_thread_limit(threads);
            std::unique_ptr<RepeatedPeer> peer =
                make(*race.method, control.of(race), race.steps(control.level),
                     Precision::single_float, control.tags_of(race));
            return peer ? std::make_unique<PeerAgain>(std::move(peer)) : nullptr;
          }};
}

}  // namespace

Control with_sharp_edges(Control control, double share) {
  control.name += fmt::format(", {:.0f} % of the edges sharp", 100 * share);
  control.triangle_tags = sharp_edges(control.triangles, share);
  control.polygon_tags = sharp_edges(control.polygons, share);
  return control;
}

Control with_texture(Control control) {
  control.name += ", textured";
  control.triangle_texture = octants(control.triangles);
  control.polygon_texture = octants(control.polygons);
  return control;
}

int Race::steps(int level) const { return level + (scheme.split->dilation.growth() == 3 ? 1 : 0); }

std::vector<Race> races(const std::string& only) {
  const std::vector<std::pair<std::string, std::optional<Method>>> known{
      {"loop", Method::loop},
      {"catmull-clark", Method::catmull_clark},
      {"sqrt3", Method::sqrt3},
      {"doo-sabin", Method::doo_sabin},
      {"butterfly-modified", Method::modified_butterfly},
      {"laplacian-butterfly", std::nullopt}};
  std::vector<Race> all;
  for (const auto& [name, method] : known)
    if (only.empty() || only == name)
      all.push_back({name, value_or_throw(find_scheme(name)), method});
  if (all.empty()) all.push_back({only, value_or_throw(find_scheme(only)), std::nullopt});
  return all;
}

std::vector<Contender> full_refinement(const Race& race, const Control& control) {
  if (!control.texture_of(race).of_corner.empty()) return textured_refinement(race, control);
  std::vector<Contender> all;
  add_ours<PlainTrial>(all, "limn plain", race, control);
  if (has_fast_layout(race.scheme)) {
    add_ours<QuickTrial<double>>(all, "limn quick", race, control);
    add_ours<QuickTrial<float>>(all, "limn quick, float", race, control);
  }
  if (!race.method) return all;
  using Tags = PeerTags;
  all.push_back(of_theirs("OpenSubdiv, float", race, control,
                          [](Method method, const Polygons& mesh, const Tags& tags) {
                            return opensubdiv_peer(method, mesh, tags, Precision::single_float);
                          }));
  if (!control.tags_of(race).edges.empty()) return all;  // others have no sharpness
  all.push_back(of_theirs("CGAL", race, control,
                          [](Method method, const Polygons& mesh, const Tags& /*tags*/) {
                            return cgal_peer(method, mesh);
                          }));
  all.push_back(of_theirs("OpenMesh, float", race, control,
                          [](Method method, const Polygons& mesh, const Tags& /*tags*/) {
                            return openmesh_peer(method, mesh, Precision::single_float);
                          }));
  return all;
}

std::vector<Contender> repeated_evaluation(const Race& race, const Control& control) {
  std::vector<Contender> all;
  if (!control.texture_of(race).of_corner.empty()) return all;  // that is one more column
  if (has_fast_layout(race.scheme)) {
    add_ours<QuickAgain<float>>(all, "limn quick, float", race, control);
    add_ours<QuickAgain<double>>(all, "limn quick", race, control);
  }
  if (!race.method) return all;
  const std::string name = "OpenSubdiv StencilTable, float";
  all.push_back(of_theirs_again(name, 1, race, control, opensubdiv_stencils));
  all.push_back(of_theirs_again(name + ", 2 threads", 2, race, control, opensubdiv_stencils));
  all.push_back(
      of_theirs_again("OpenSubdiv PrimvarRefiner, float", 1, race, control, opensubdiv_primvars));
  return all;
}

double floor_bytes(Trial::Size size) {
  return 3 * sizeof(float) * size.vertices + sizeof(Index) * size.corners;
}

Contender floor_of(Trial::Size size) {
  return {"floor", true, 1, [size] { return std::make_unique<FloorTrial>(size); }};
}

}  // namespace limn::peers
