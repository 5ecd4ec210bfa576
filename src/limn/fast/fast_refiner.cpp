#include "limn/fast/fast_refiner.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <optional>

#include <fmt/core.h>

#include "limn/base/huge_array.h"
#include "limn/base/large_vector.h"
#include "limn/base/parallel.h"
#include "limn/fast/fast_estimate.h"
#include "limn/fast/kernel/patch_step.h"
#include "limn/fast/kernel/row_step.h"
#include "limn/fast/range.h"
#include "limn/fast/refiner_state.h"
#include "limn/refine/refine.h"

namespace limn {
namespace {

template <class T>
void make_room(base::HugeArray<T>& array, std::size_t size) {
  if (array.size() < size) array = base::HugeArray<T>(size);
}

template <class Real>
void multiply(std::span<Real> numbers, Real factor) {
  for (Real& number : numbers) number *= factor;
}

template <class Real>
std::vector<Real> with_room(std::span<const Real> numbers) {
  std::vector<Real> small(numbers.begin(), numbers.end());
  multiply<Real>(small, fast::kRoom<Real>);
  return small;
}

}  // namespace

bool has_fast_layout(const Scheme& scheme) {
  return !scheme.stages && fast::has_family(*scheme.split);
}

std::optional<std::string> why_no_fast_sharpness(const Scheme& scheme, const Mesh& control,
                                                 const Sharpness& sharpness) {
  return fast::why_no_family(scheme, control, sharpness);
}

Status FastRefiner::State::choose(const Scheme& scheme) {
  if (Status takes = refine::check_takes_sharpness(scheme, sharpness); !takes) return takes;
  if (const auto why = fast::why_no_family(scheme, control, sharpness))
    return Error{
        fmt::format("the quick engine cannot refine this mesh by {}: {}", scheme.name, *why),
        "use the plain engine"};
  constexpr double kUnlimited = std::numeric_limits<double>::infinity();
  // before anything is made that could be too large for an index
  if (Status status = refine::check_refinable(scheme, control, levels, sizeof(Point3), kUnlimited);
      !status)
    return status;
  family = fast::make_family(scheme, control, levels, sharpness);
  size = family->size(levels);
  return Done{};
}

Status FastRefiner::State::work_out(const Scheme& scheme) {
  const int first = family->plain_steps();
  Result<fast::PlainSteps> made = fast::PlainSteps::make(scheme, control, first, sharpness);
  if (!made) return made.error();
  plain.emplace(std::move(*made));
  plain->write_down(family->plain_order(plain->splits()));
  vertices.push_back(family->size(first).vertices);
  for (int level = first; level < levels; ++level) {
    fast::ReadyStep& step = steps.emplace_back();
    step.plan = family->plan(level);
    step.program = fast::make_patch_program(step.plan.patches.shape, step.plan.patches.stencils);
    vertices.push_back(family->size(level + 1).vertices);
  }
  return Done{};
}

template <class Real>
struct FastRefiner::Scratch<Real>::Arrays {
  base::HugeArray<Real> numbers;  // of the levels in between
  base::HugeArray<Real> refined;  // where the limit is evaluated
};

template <class Real>
FastRefiner::Scratch<Real>::Scratch() : arrays_(new Arrays) {}
template <class Real>
void FastRefiner::Scratch<Real>::Free::operator()(Arrays* arrays) const noexcept {
  delete arrays;
}
template <class Real>
std::span<const Real> FastRefiner::Scratch<Real>::refined() const {
  return arrays_->refined;
}
template class FastRefiner::Scratch<float>;
template class FastRefiner::Scratch<double>;

template <class Real>
void FastRefiner::State::evaluate(const Real* control_points, std::size_t count, Real* out,
                                  Scratch<Real>& scratch) const {
  if (count > 0) {
    // a point is read with the number after it
    const auto before = static_cast<std::size_t>(vertices[count - 1]);
    make_room(scratch.arrays_->numbers, 3 * before + 1);
  }
  // the levels take turns, so that the last one is made in `out`
  std::array<Real*, 2> places{out, scratch.arrays_->numbers.data()};
  if (count % 2 == 1) std::swap(places[0], places[1]);
  plain->evaluate(control_points, places[0]);
  for (std::size_t i = 0; i < count; ++i) {
    Real* in = places[i % 2];
    Real* to = places[(i + 1) % 2];
    in[3 * static_cast<std::size_t>(vertices[i])] = 0;
    const fast::ReadyStep& step = steps[i];
    fast::make_patches(step.plan.patches, step.program, in, to);
    for (const fast::RowPlan& rows : step.plan.rows) fast::make_rows(rows, in, to);
  }
}

FastRefiner::FastRefiner(std::unique_ptr<State> state) : state_(std::move(state)) {}
FastRefiner::FastRefiner(FastRefiner&&) noexcept = default;
FastRefiner& FastRefiner::operator=(FastRefiner&&) noexcept = default;
FastRefiner::~FastRefiner() = default;

Result<FastRefiner> FastRefiner::make(const Scheme& scheme, Mesh control, int levels,
                                      Sharpness sharpness) {
  assert(has_fast_layout(scheme));
  auto state = std::make_unique<State>(std::move(control), levels, std::move(sharpness));
  if (Status status = state->choose(scheme); !status) return status.error();
  const Mesh& mesh = state->control;
  if (state->is_plain())
    if (Status status =
            refine::check_refinable(scheme, mesh, levels, sizeof(Point3), base::available_memory());
        !status)
      return status.error();
  const double after = state->size.vertices, faces = state->size.faces;
  const refine::RefineEstimate needed{after, faces,
                                      fast::needed_bytes(after, faces, state->size.corners)};
  if (Status status = refine::check_memory(needed, levels, base::available_memory()); !status)
    return status.error();
  if (Status status = state->work_out(scheme); !status) return status.error();
  return FastRefiner(std::move(state));
}

Index FastRefiner::vertex_count() const { return state_->size.vertices; }
Index FastRefiner::face_count() const { return state_->size.faces; }
Index FastRefiner::corner_count() const { return state_->size.corners; }
Index FastRefiner::corners_per_face() const { return state_->family->corners_per_face(); }
int FastRefiner::plain_steps() const { return state_->plain->count(); }

template <class Real>
void FastRefiner::evaluate(std::span<const Real> control, std::span<Real> fine,
                           Scratch<Real>& scratch) const {
  assert(control.size() == 3 * static_cast<std::size_t>(state_->control.vertex_count()));
  assert(fine.size() == 3 * static_cast<std::size_t>(vertex_count()));
  if (fast::needs_room(control)) {
    state_->evaluate(with_room(control).data(), state_->steps.size(), fine.data(), scratch);
    return multiply(fine, 1 / fast::kRoom<Real>);
  }
  state_->evaluate(control.data(), state_->steps.size(), fine.data(), scratch);
}

FastRefiner::Limit::Limit(std::unique_ptr<const Plan> plan) : plan_(std::move(plan)) {}
FastRefiner::Limit::Limit(Limit&&) noexcept = default;
FastRefiner::Limit& FastRefiner::Limit::operator=(Limit&&) noexcept = default;
FastRefiner::Limit::~Limit() = default;
std::size_t FastRefiner::Limit::bytes() const { return bytes_of(plan_->step.plan); }

Result<std::optional<FastRefiner::Limit>> FastRefiner::limit(fast::LimitReader& reader) const {
  Result<std::optional<fast::StepPlan>> plan = state_->family->limit_plan(state_->levels, reader);
  if (!plan) return plan.error();
  if (!*plan) return std::optional<Limit>();
  fast::PatchProgram program =
      fast::make_patch_program((*plan)->patches.shape, (*plan)->patches.stencils, 3);
  auto made = std::make_unique<Limit::Plan>();
  made->step = {*std::move(*plan), std::move(program)};
  return std::optional<Limit>(Limit(std::move(made)));
}

template <class Real>
void FastRefiner::evaluate_limit(const Limit& limit, std::span<const Real> control,
                                 std::span<Real> positions, std::span<Real> normals,
                                 Scratch<Real>& scratch) const {
  const std::size_t numbers = 3 * static_cast<std::size_t>(vertex_count());
  assert(control.size() == 3 * static_cast<std::size_t>(state_->control.vertex_count()));
  assert(positions.size() == numbers && normals.size() == numbers);
  // a point is read with the number after it
  make_room(scratch.arrays_->refined, numbers + 1);
  Real* refined = scratch.arrays_->refined.data();
  const bool near_end = fast::needs_room(control);
  const std::vector<Real> small = near_end ? with_room(control) : std::vector<Real>();
  state_->evaluate(near_end ? small.data() : control.data(), state_->steps.size(), refined,
                   scratch);
  refined[numbers] = 0;
  const fast::ReadyStep& step = limit.plan_->step;
  fast::make_limit_patches<Real>(step.plan.patches, step.program, refined, positions.data(),
                                 normals.data());
  for (const fast::RowPlan& rows : step.plan.rows)
    fast::make_limit_rows<Real>(rows, refined, positions.data(), normals.data());
  if (!near_end) return;
  multiply<Real>({refined, numbers}, 1 / fast::kRoom<Real>);
  multiply(positions, 1 / fast::kRoom<Real>);
}

void FastRefiner::write_faces(std::span<Index> corners) const {
  assert(corners.size() == static_cast<std::size_t>(corner_count()));
  state_->family->write_faces(state_->levels, corners);
}

void FastRefiner::write_face_begin(std::span<Index> begin) const {
  assert(begin.size() == static_cast<std::size_t>(face_count()) + 1);
  const Index each = corners_per_face();
  if (each == 0) return state_->family->write_face_begin(state_->levels, begin);
  base::parallel_for(0, face_count() + 1, [&](Index first, Index last) {
    for (Index f = first; f < last; ++f) begin[static_cast<std::size_t>(f)] = each * f;
  });
}

SharpnessTags FastRefiner::sharp_tags() const {
  SharpnessTags tags = state_->family->sharp_tags(state_->levels);
  const CreaseMethod method = state_->sharpness.method;
  if (!tags.empty() && method != CreaseMethod::uniform) tags.method = method;
  return tags;
}

void FastRefiner::write_parents(std::span<Index> faces) const {
  assert(faces.size() == static_cast<std::size_t>(face_count()));
  // The faces of a control face follow one another: those of its grid, or where it is no face of
  // the lattice, those of the grids of its corners.
  const Mesh& mesh = state_->control;
  const bool whole = mesh.uniform_degree() > 0 || state_->levels == 0;
  const Index parts = whole ? mesh.face_count() : mesh.halfedge_count();
  const Index each = parts > 0 ? face_count() / parts : 0;
  base::parallel_for_each(mesh.face_count(), [&](Index f) {
    const Index first = whole ? f : mesh.face_begin(f);
    const Index last = whole ? f + 1 : mesh.face_begin(f + 1);
    for (Index i = first * each; i < last * each; ++i) faces[static_cast<std::size_t>(i)] = f;
  });
}

std::size_t FastRefiner::bytes() const {
  const State& state = *state_;
  const Mesh& mesh = state.control;
  const std::size_t indices = 3 * static_cast<std::size_t>(mesh.halfedge_count()) +
                              static_cast<std::size_t>(mesh.edge_count() + mesh.vertex_count());
  std::size_t bytes = indices * sizeof(Index) + state.plain->bytes();
  for (const fast::ReadyStep& step : state.steps) bytes += bytes_of(step.plan);
  return bytes;
}

template void FastRefiner::State::evaluate<float>(const float*, std::size_t, float*,
                                                  Scratch<float>&) const;
template void FastRefiner::State::evaluate<double>(const double*, std::size_t, double*,
                                                   Scratch<double>&) const;
template void FastRefiner::evaluate<float>(std::span<const float>, std::span<float>,
                                           Scratch<float>&) const;
template void FastRefiner::evaluate<double>(std::span<const double>, std::span<double>,
                                            Scratch<double>&) const;
template void FastRefiner::evaluate_limit<float>(const Limit&, std::span<const float>,
                                                 std::span<float>, std::span<float>,
                                                 Scratch<float>&) const;
template void FastRefiner::evaluate_limit<double>(const Limit&, std::span<const double>,
                                                  std::span<double>, std::span<double>,
                                                  Scratch<double>&) const;

Polygons refined_polygons(const FastRefiner& refiner, std::vector<Point3> positions) {
  Polygons polygons;
  polygons.positions = std::move(positions);
  polygons.corners = base::large_vector<Index>(static_cast<std::size_t>(refiner.corner_count()));
  refiner.write_faces(polygons.corners);
  polygons.face_begin =
      base::large_vector<Index>(static_cast<std::size_t>(refiner.face_count()) + 1);
  refiner.write_face_begin(polygons.face_begin);
  return polygons;
}

Result<Polygons> fast_refine(const Scheme& scheme, Mesh control,
                             const std::vector<Point3>& positions, int levels) {
  Result<FastRefiner> refiner = FastRefiner::make(scheme, std::move(control), levels);
  if (!refiner) return refiner.error();
  std::vector<Point3> fine =
      base::large_vector<Point3>(static_cast<std::size_t>(refiner->vertex_count()));
  refiner->evaluate<double>(numbers_of(positions), numbers_of(fine));
  return refined_polygons(*refiner, std::move(fine));
}

}  // namespace limn
