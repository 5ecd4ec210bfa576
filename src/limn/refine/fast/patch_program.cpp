#include "limn/refine/fast/patch_program.h"

#include <algorithm>

namespace limn::fast {
namespace {

constexpr Index kBlockPoints = 256;  // so that a line stays in the nearest cache

class ProgramMaker {
 public:
  ProgramMaker(Index n, Index halo) {
    program_.n = n;
    program_.halo = halo;
    program_.pitch = n + 2 * halo + 1;
    program_.slots = program_.pitch * program_.pitch;
  }

  PatchProgram make() {
    for (Index y = 1; y < program_.n; ++y)
      for (Index x = 1; x + y < program_.n; ++x)
        program_.inner_slots.push_back(program_.slot(x, y));
    add_sides();
    add_rows();
    return std::move(program_);
  }

 private:
  void add(Index x, Index y) {
    ClassPoints& points = program_.blocks.back().classes[class_of(x, y)];
    points.anchors.push_back(program_.slot(x / 2, y / 2));
    points.places.push_back(used_++);
    program_.line = std::max(program_.line, used_);
  }

  void add_sides() {
    const Index fine = 2 * program_.n;
    program_.blocks.emplace_back().side = fine - 1;
    for (Index t = 1; t < fine; ++t) add(t, 0);
    for (Index t = 1; t < fine; ++t) add(fine - t, t);
    for (Index t = 1; t < fine; ++t) add(0, fine - t);
  }

  void add_rows() {
    const Index fine = 2 * program_.n;
    for (Index y = 1; y + 1 < fine; ++y) {
      if (used_ >= kBlockPoints) {
        program_.blocks.emplace_back();
        used_ = 0;
      }
      for (Index x = 1; x + y < fine; ++x) add(x, y);
      program_.blocks.back().inner += fine - 1 - y;
    }
  }

  PatchProgram program_;
  Index used_ = 0;  // of the line
};

}  // namespace

PatchProgram make_patch_program(Index n, Index halo) { return ProgramMaker(n, halo).make(); }

}  // namespace limn::fast
