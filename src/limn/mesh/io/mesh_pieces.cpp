#include "limn/mesh/io/mesh_pieces.h"

#include <atomic>
#include <cassert>
#include <cmath>
#include <limits>
#include <mutex>

#include "limn/mesh/io/bytes.h"
#include "limn/mesh/io/formats.h"
#include "limn/mesh/io/ply_records.h"

namespace limn::mesh {
namespace {

/// Whether all numbers are at most so large; without a branch, for vectors.
bool are_within(const double* numbers, std::size_t count, double largest) {
  int beyond = 0;
  for (std::size_t i = 0; i < count; ++i) beyond |= std::abs(numbers[i]) <= largest ? 0 : 1;
  return beyond == 0;
}

/// The first vertex that has a fault, of those that were seen.
struct FirstFault {
  std::size_t vertex = std::numeric_limits<std::size_t>::max();
  io::Fault fault;

  template <class FaultOf>
  void look(std::size_t first, std::size_t count, const double* numbers, const FaultOf& fault_of) {
    for (std::size_t v = first; v < first + count && v < vertex; ++v, numbers += 3) {
      io::Fault found = fault_of(v, Point3{numbers[0], numbers[1], numbers[2]});
      if (found.message.empty()) continue;
      vertex = v;
      fault = std::move(found);
    }
  }
};

}  // namespace

struct MeshPieceSink::State {
  State(const MeshCounts& counts, const base::PlacedSink& to)
      : records{counts.vertices, counts.faces, counts.normals, counts.largest_face > 255},
        corners_per_face(counts.corners_per_face),
        sink(to) {}

  const io::PlyRecords records;
  const Index corners_per_face;
  const base::PlacedSink& sink;
  std::size_t vertices_at = 0, faces_at = 0;  // bytes from the beginning
  std::atomic<bool> failed = false;           // nothing more need be written
  std::mutex lock;                            // of what follows
  FirstFault position, normal;
};

MeshPieceSink::MeshPieceSink(const MeshCounts& counts, const base::PlacedSink& sink)
    : state_(std::make_unique<State>(counts, sink)) {
  const std::string header = state_->records.header();
  state_->vertices_at = header.size();
  state_->faces_at = header.size() + counts.vertices * state_->records.vertex_bytes();
  sink(0, header);
}

MeshPieceSink::~MeshPieceSink() = default;

void MeshPieceSink::put_vertices(std::size_t first, std::size_t count, const double* positions,
                                 const double* normals, std::string& memory) {
  State& state = *state_;
  assert((normals != nullptr) == state.records.normals);
  const bool good =
      are_within(positions, 3 * count, std::numeric_limits<double>::max()) &&
      (normals == nullptr || are_within(normals, 3 * count, std::numeric_limits<float>::max()));
  if (!good) {
    const std::lock_guard<std::mutex> guard(state.lock);
    state.failed = true;
    state.position.look(first, count, positions, io::position_fault);
    if (normals != nullptr) state.normal.look(first, count, normals, io::normal_fault);
  }
  if (state.failed) return;
  const std::size_t at = state.vertices_at + first * state.records.vertex_bytes();
  const std::size_t bytes = count * state.records.vertex_bytes();
  if (normals == nullptr && io::kLittleEndianHost) {  // they are the file's bytes
    state.sink(at, {reinterpret_cast<const char*>(positions), bytes});
    return;
  }
  memory.resize(bytes);
  io::put_ply_vertices(memory.data(), count, positions, normals);
  state.sink(at, memory);
}

void MeshPieceSink::put_faces(std::size_t first, std::size_t count, std::size_t first_corner,
                              const Index* corners, const Index* begin, std::string& memory) {
  const State& state = *state_;
  if (state.failed || count == 0) return;
  const Index each = state.corners_per_face;
  const std::size_t all = each > 0 ? count * static_cast<std::size_t>(each)
                                   : static_cast<std::size_t>(begin[count] - begin[0]);
  memory.resize(state.records.face_bytes(count, all));
  io::put_ply_faces(memory.data(), count, corners, each, begin, state.records.wide);
  state.sink(state.faces_at + state.records.face_bytes(first, first_corner), memory);
}

Status MeshPieceSink::status() const {
  for (const FirstFault* first : {&state_->position, &state_->normal})
    if (!first->fault.message.empty()) return io::error_of(first->fault, "");
  return Done{};
}

bool takes_mesh_pieces(const std::string& path, std::string_view extension) {
  return io::is_extension(extension, "ply") && base::takes_places(path);
}

Status write_mesh_pieces(const std::string& path, const MeshCounts& counts,
                         const std::function<void(MeshPieceSink&)>& fill) {
  return base::write_file_at_places(path, [&](const base::PlacedSink& sink) -> Status {
    MeshPieceSink pieces(counts, sink);
    fill(pieces);
    return pieces.status();
  });
}

}  // namespace limn::mesh
