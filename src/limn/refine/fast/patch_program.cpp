#include "limn/refine/fast/patch_program.h"

namespace limn::fast {
namespace {

/// Points first, first + step, … of the finer grid.
PatchRun make_run(const PatchProgram& program, Offset first, Offset step, Index count) {
  PatchRun run;
  for (const Index t : {0, 1}) {
    const Index x = first.a + t * step.a, y = first.b + t * step.b;
    run.classes[static_cast<std::size_t>(t)] = class_of(x, y);
    run.anchors[static_cast<std::size_t>(t)] = program.slot(x >> 1, y >> 1);
  }
  run.anchor_step = program.slot_step(step);
  run.count = count;
  return run;
}

}  // namespace

PatchProgram make_patch_program(Index n, Index halo) {
  PatchProgram program;
  program.n = n;
  program.halo = halo;
  program.pitch = n + 2 * halo + 1;
  program.slots = program.pitch * program.pitch;
  const Index fine = 2 * n;
  program.sides = {make_run(program, {1, 0}, {1, 0}, fine - 1),
                   make_run(program, {fine - 1, 1}, {-1, 1}, fine - 1),
                   make_run(program, {0, fine - 1}, {0, -1}, fine - 1)};
  for (Index y = 1; y + 1 < fine; ++y)
    program.rows.push_back(make_run(program, {1, y}, {1, 0}, fine - 1 - y));
  return program;
}

}  // namespace limn::fast
