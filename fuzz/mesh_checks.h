#pragma once
/// What the fuzzers of mesh files share.

#include <cstdio>
#include <cstdlib>
#include <string>

#include "limn/mesh/io/mesh_file.h"
#include "limn/mesh/mesh.h"
#include "limn/mesh/repair/repair.h"
#include "limn/mesh/repair/survey.h"

namespace limn::fuzz {

inline void check(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", what);
  std::abort();
}

/// The invariants that every reader promises.
inline void check_mesh(const Polygons& mesh) {
  check(mesh.vertex_count() > 0 && mesh.face_count() > 0, "not empty");
  check(mesh.face_begin.front() == 0 &&
            mesh.face_begin.back() == static_cast<Index>(mesh.corners.size()),
        "offsets span the corners");
  for (Index face = 0; face < mesh.face_count(); ++face)
    check(mesh.degree(face) >= 3, "three corners or more");
  for (const Index vertex : mesh.corners)
    check(vertex >= 0 && vertex < mesh.vertex_count(), "indices in range");
}

/// Read with its faults, a file is surveyed and repaired; repaired, it is a surface, unless corners
/// are no vertices.
inline void check_kept_faults(const std::string& content, const char* extension) {
  const Result<MeshFile> file = parse_mesh_file(content, extension, "kept", {.keep_faults = true});
  if (!file) return check(!file.error().message.empty(), "an error has a message");
  const mesh::MeshSurvey survey = mesh::survey_mesh(file->polygons);
  check(!survey.refinable || Mesh::build(file->polygons).ok(), "what is refinable is a surface");
  const Result<mesh::Repaired> repaired =
      mesh::repair(file->polygons, mesh::RepairOptions::everything());
  if (!repaired) return check(!repaired.error().message.empty(), "a refusal has a message");
  bool missing = false;
  for (const Index v : file->polygons.corners)
    missing = missing || v < 0 || v >= file->polygons.vertex_count();
  check(missing || Mesh::build(repaired->polygons).ok(), "what is repaired is a surface");
}

}  // namespace limn::fuzz
