#include "limn/surface/refined_file.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>

#include "limn/base/parallel.h"
#include "limn/fast/fast_pieces.h"

namespace limn::surface {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// What a thread works in.
struct Memory {
  fast::StepPiece vertices;
  fast::FacePiece faces;
  std::string bytes;
};

/// Hands memory out, and takes it back for the next piece.
class MemoryPool {
 public:
  std::unique_ptr<Memory> take() {
    const std::lock_guard<std::mutex> guard(lock_);
    if (free_.empty()) return std::make_unique<Memory>();
    std::unique_ptr<Memory> memory = std::move(free_.back());
    free_.pop_back();
    return memory;
  }
  void give_back(std::unique_ptr<Memory> memory) {
    const std::lock_guard<std::mutex> guard(lock_);
    free_.push_back(std::move(memory));
  }

 private:
  std::mutex lock_;
  std::vector<std::unique_ptr<Memory>> free_;
};

/// Makes the pieces and writes them.
class PieceWriter {
 public:
  PieceWriter(fast::FastPieces& pieces, bool normals) : pieces_(pieces), normals_(normals) {
    if (pieces.corners_per_face() == 0) make_all_faces();
  }

  [[nodiscard]] mesh::MeshCounts counts() const {
    return {static_cast<std::size_t>(pieces_.vertex_count()),
            static_cast<std::size_t>(pieces_.face_count()), pieces_.corners_per_face(),
            std::max(largest_, pieces_.corners_per_face()), normals_};
  }

  void write(mesh::MeshPieceSink& sink) {
    const Clock::time_point start = Clock::now();
    for (Index group = 0; group < pieces_.groups(); ++group) {
      const Clock::time_point entered = Clock::now();
      const fast::FastPieces::Range range = pieces_.enter(group);
      making_ += (Clock::now() - entered).count();
      for_pieces(range.first, range.last,
                 [&](Index piece, Memory& memory) { write_vertices(piece, memory, sink); });
    }
    if (pieces_.face_pieces() == 1) {
      write_all_faces(sink);
    } else {
      for_pieces(0, pieces_.face_pieces(),
                 [&](Index piece, Memory& memory) { write_faces(piece, memory, sink); });
    }
    // how long the last step would take without writing, by the shares of all threads
    const double making = static_cast<double>(making_.load());
    const double all = making + static_cast<double>(writing_.load());
    seconds_ = all > 0 ? seconds_since(start) * making / all : 0;
  }

  [[nodiscard]] double refinement_seconds() const { return seconds_; }

  /// The vertices without a normal, ascending.
  std::vector<Index> without_normal() {
    std::sort(without_normal_.begin(), without_normal_.end());
    return std::move(without_normal_);
  }

 private:
  template <class Work>
  void for_pieces(Index begin, Index end, const Work& work) {
    base::parallel_for(
        begin, end,
        [&](Index first, Index last) {
          std::unique_ptr<Memory> memory = pool_.take();
          for (Index piece = first; piece < last; ++piece) work(piece, *memory);
          pool_.give_back(std::move(memory));
        },
        1);
  }

  void note(Clock::time_point start, Clock::time_point made) {
    making_ += (made - start).count();
    writing_ += (Clock::now() - made).count();
  }

  void write_vertices(Index piece, Memory& memory, mesh::MeshPieceSink& sink) {
    const Clock::time_point start = Clock::now();
    pieces_.make_vertices(piece, memory.vertices);
    const Clock::time_point made = Clock::now();
    const double* positions = memory.vertices.positions.data();
    const double* normals = normals_ ? memory.vertices.normals.data() : nullptr;
    for (const fast::Extent& extent : memory.vertices.extents) {
      const auto count = static_cast<std::size_t>(extent.count);
      sink.put_vertices(static_cast<std::size_t>(extent.first), count, positions, normals,
                        memory.bytes);
      positions += 3 * count;
      if (normals_) {
        find_gaps(extent, normals);
        normals += 3 * count;
      }
    }
    note(start, made);
  }

  void find_gaps(const fast::Extent& extent, const double* normals) {
    for (Index v = 0; v < extent.count; ++v, normals += 3) {
      if (normals[0] != 0 || normals[1] != 0 || normals[2] != 0) continue;
      const std::lock_guard<std::mutex> guard(lock_);
      without_normal_.push_back(extent.first + v);
    }
  }

  void write_faces(Index piece, Memory& memory, mesh::MeshPieceSink& sink) {
    const Clock::time_point start = Clock::now();
    pieces_.make_faces(piece, memory.faces);
    const Clock::time_point made = Clock::now();
    const auto first = static_cast<std::size_t>(memory.faces.first);
    sink.put_faces(first, static_cast<std::size_t>(memory.faces.count),
                   first * static_cast<std::size_t>(pieces_.corners_per_face()),
                   memory.faces.corners.data(), nullptr, memory.bytes);
    note(start, made);
  }

  /// Faces that differ, or fall into no pieces, are made together and written in parts.
  void make_all_faces() {
    pieces_.make_faces(0, all_faces_);
    for (std::size_t f = 0; f + 1 < all_faces_.begin.size(); ++f)
      largest_ = std::max(largest_, all_faces_.begin[f + 1] - all_faces_.begin[f]);
  }

  void write_all_faces(mesh::MeshPieceSink& sink) {
    if (pieces_.corners_per_face() > 0) make_all_faces();
    constexpr std::ptrdiff_t kFaces = 16384;
    base::parallel_for(
        Index{0}, all_faces_.count,
        [&](Index first, Index last) {
          std::unique_ptr<Memory> memory = pool_.take();
          const Index* const begin =
              all_faces_.begin.empty() ? nullptr : all_faces_.begin.data() + first;
          const auto at = static_cast<std::size_t>(first);
          const std::size_t corner =
              begin != nullptr ? static_cast<std::size_t>(*begin)
                               : at * static_cast<std::size_t>(pieces_.corners_per_face());
          sink.put_faces(at, static_cast<std::size_t>(last - first), corner,
                         all_faces_.corners.data() + corner, begin, memory->bytes);
          pool_.give_back(std::move(memory));
        },
        kFaces);
  }

  fast::FastPieces& pieces_;
  bool normals_;
  fast::FacePiece all_faces_;
  Index largest_ = 0;
  MemoryPool pool_;
  std::atomic<Clock::rep> making_ = 0, writing_ = 0;  // of all threads together
  double seconds_ = 0;
  std::mutex lock_;  // of what follows
  std::vector<Index> without_normal_;
};

}  // namespace

bool may_write_refined(const Scheme& scheme, const SurfaceOptions& options, const std::string& path,
                       const std::string& extension) {
  return options.engine == SurfaceOptions::Engine::quick && has_fast_layout(scheme) &&
         !options.curvatures && !options.connectivity && !options.has_sharpness() &&
         (options.attributes == nullptr || options.attributes->empty()) &&
         mesh::takes_mesh_pieces(path, extension);
}

Result<std::optional<RefinedFile>> write_refined(const Scheme& scheme, const Mesh& control,
                                                 const std::vector<Point3>& points,
                                                 const SurfaceOptions& options,
                                                 const std::string& path) {
  const Clock::time_point start = Clock::now();
  const fast::FastPieces::Wanted wanted{options.limit, options.normals};
  Result<std::optional<fast::FastPieces>> pieces =
      fast::FastPieces::make(scheme, control, numbers_of(points), options.levels, wanted);
  // where there is no limit somewhere, the plain way knows where, and gives the rest
  if (!pieces && options.of_limit() && options.partial) return std::optional<RefinedFile>();
  if (!pieces) return pieces.error();
  if (!*pieces) return std::optional<RefinedFile>();
  const double prepared = seconds_since(start);
  if (options.progress) options.progress("writing " + path);
  PieceWriter writer(**pieces, options.normals);
  const mesh::MeshCounts counts = writer.counts();
  if (Status status = mesh::write_mesh_pieces(
          path, counts, [&](mesh::MeshPieceSink& sink) { writer.write(sink); });
      !status)
    return status.error();
  RefinedFile file;
  file.vertices = counts.vertices;
  file.faces = counts.faces;
  file.gaps.normals = writer.without_normal();
  file.refinement_seconds = prepared + writer.refinement_seconds();
  return std::optional<RefinedFile>(std::move(file));
}

}  // namespace limn::surface
