/// Topology worked out once, positions evaluated often.

#include <fmt/core.h>
#include <pybind11/stl.h>

#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "arrays.h"
#include "call.h"
#include "errors.h"
#include "limn/base/memory.h"
#include "limn/fast/fast_estimate.h"
#include "limn/fast/fast_refiner.h"
#include "limn/refine/crease_step.h"
#include "limn/surface/refine_surface.h"
#include "module.h"
#include "refined_faces.h"
#include "tags.h"

namespace limn::python {
namespace {

class Refiner {
 public:
  /// `tags`: as tags_of (tags.h) takes them.
  Refiner(std::shared_ptr<Scheme> scheme, const py::object& faces, int levels,
          std::optional<Index> vertices, const py::dict& tags);

  /// pybind11 asks for memory where a method is called of an object whose __init__ never ran, and
  /// nothing would be constructed in it. `make` asks elsewhere.
  static void* operator new(std::size_t /*size*/) {
    throw py::type_error("limn.Refiner: __init__ was not called");
  }
  static std::unique_ptr<Refiner> make(std::shared_ptr<Scheme> scheme, const py::object& faces,
                                       int levels, std::optional<Index> vertices,
                                       const py::dict& tags) {
    return std::unique_ptr<Refiner>(
        ::new Refiner(std::move(scheme), faces, levels, vertices, tags));
  }

  /// The refined points, in `out` or an array of their own.
  py::object evaluate(const py::object& values, const py::object& out);
  /// (P, N).
  py::tuple evaluate_limit(const py::object& vertices);

  [[nodiscard]] py::object faces() const { return faces_; }
  [[nodiscard]] py::object control_faces() const { return faces_object(control_); }
  [[nodiscard]] Index control_count() const { return control_.vertex_count(); }
  [[nodiscard]] Index vertex_count() const { return vertices_; }
  [[nodiscard]] const std::shared_ptr<Scheme>& scheme() const { return scheme_; }
  [[nodiscard]] int levels() const { return levels_; }
  [[nodiscard]] bool is_fast() const { return fast_.has_value(); }
  [[nodiscard]] std::size_t bytes() const { return fast_ ? fast_->bytes() : 0; }
  [[nodiscard]] py::dict tags() const { return tags_dict(tags_); }
  [[nodiscard]] py::dict control_tags() const { return tags_dict(control_tags_); }

 private:
  template <class Real>
  struct Memory {
    FastRefiner::Scratch<Real> scratch;
    std::mutex in_use;
  };
  template <class Real>
  Memory<Real>& memory() {
    if constexpr (std::is_same_v<Real, float>)
      return *floats_;
    else
      return *doubles_;
  }

  /// use(scratch): the one that is kept, or where another thread has it a new one.
  template <class Real, class Use>
  void with_scratch(Use use) {
    Memory<Real>& kept = memory<Real>();
    if (const std::unique_lock<std::mutex> lock(kept.in_use, std::try_to_lock); lock.owns_lock()) {
      use(kept.scratch);
      return;
    }
    FastRefiner::Scratch<Real> own;
    use(own);
  }

  void take_tags(const Mesh& mesh, const SharpnessTags& tags);
  void make_fast(Mesh mesh);
  void take_surface();

  /// make(points), points of the fast engine; of them `fine` gets those that are no hole's.
  template <class Real, class Make>
  void without_holes_of(std::span<Real> fine, Make make) const {
    if (!sharpness_.has_holes()) return make(fine);
    base::HugeArray<Real> all(3 * static_cast<std::size_t>(fast_->vertex_count()));
    make(std::span<Real>(all));
    for (std::size_t i = 0; i < kept_.size(); ++i)
      std::copy_n(all.data() + 3 * static_cast<std::size_t>(kept_[i]), 3, fine.data() + 3 * i);
  }
  template <class Real>
  void sum(std::span<const Real> control, std::span<Real> fine);
  template <class Real>
  py::object evaluate_columns(const py::array& values, bool flat);
  template <class Real>
  py::object evaluate_points(const py::array& values, const py::object& out);
  RefinedSurface surface(std::vector<Point3> points, bool limit) const;
  const FastRefiner::Limit* fast_limit();
  void check_count(py::ssize_t count) const;

  std::shared_ptr<Scheme> scheme_;
  std::shared_ptr<const Scheme> rules_;  // with those for smooth triangles, where asked for
  Polygons control_;                     // positions: all 0
  int levels_;
  Sharpness sharpness_;
  SharpnessTags control_tags_, tags_;  // of the control mesh, and what is still sharp
  std::vector<Index> kept_;  // where there are holes: the vertices of fast_ that are no hole's
  std::optional<FastRefiner> fast_;  // nothing where the split has no fast engine
  std::mutex making_limit_;
  bool limit_known_ = false;
  std::optional<FastRefiner::Limit> limit_;
  Index vertices_ = 0;
  py::object faces_;
  std::unique_ptr<Memory<float>> floats_ = std::make_unique<Memory<float>>();
  std::unique_ptr<Memory<double>> doubles_ = std::make_unique<Memory<double>>();
};

/// What is shared by all who ask for it must not be written.
py::object read_only(py::object faces) {
  if (py::isinstance<py::tuple>(faces)) {
    for (const py::handle part : faces) part.attr("setflags")(py::arg("write") = false);
  } else {
    faces.attr("setflags")(py::arg("write") = false);
  }
  return faces;
}

Refiner::Refiner(std::shared_ptr<Scheme> scheme, const py::object& faces, int levels,
                 std::optional<Index> vertices, const py::dict& tags)
    : scheme_(std::move(scheme)), rules_(scheme_), control_(faces_of(faces)), levels_(levels) {
  if (levels < 0 || levels > 64) raise({"levels is not from 0 to 64"}, Fault::other);
  const Index least = least_vertex_count(control_);
  if (vertices && *vertices < least)
    raise({"a face has the vertex " + std::to_string(least - 1) + ", and there are " +
           std::to_string(*vertices)},
          Fault::mesh);
  const Index count = vertices.value_or(least);
  constexpr double kLeastBytes = 2 * sizeof(Point3);  // a vertex: where it is, and where it goes
  if (const double memory = base::available_memory(); kLeastBytes * count > memory)
    raise({fmt::format("{} vertices need {:.1f} GB of memory at least; {:.1f} GB are available",
                       count, kLeastBytes * count / 1e9, memory / 1e9)},
          Fault::mesh);
  control_.positions.resize(static_cast<std::size_t>(count));
  Mesh mesh = value_of(without_gil([&] { return Mesh::build(control_); }), Fault::mesh);
  take_tags(mesh, tags_of(tags));
  if (has_fast_layout(*rules_)) make_fast(std::move(mesh));
  if (!fast_ || sharpness_.has_holes()) take_surface();
}

/// What is sharp; raises where only the plain engine refines it.
void Refiner::take_tags(const Mesh& mesh, const SharpnessTags& tags) {
  if (std::optional<Scheme> smooth = smoothed(*scheme_, tags))
    rules_ = std::make_shared<const Scheme>(*std::move(smooth));
  sharpness_ = sharpness_of(mesh, tags);
  check(refine::check_takes_sharpness(*rules_, sharpness_), Fault::other);
  if (const auto why = why_no_fast_sharpness(*rules_, mesh, sharpness_))
    raise({"a Refiner cannot evaluate this mesh by " + rules_->name + ": " + *why,
           "Scheme.refine refines it, by the plain engine"},
          Fault::other);
  control_tags_ = limn::tags_of(mesh, sharpness_);
  if (tags.smooth_triangles.value_or(false)) control_tags_.smooth_triangles = true;
}

void Refiner::make_fast(Mesh mesh) {
  const refine::RefineEstimate needed = fast::estimate_fast(*rules_->split, mesh, levels_);
  check(refine::check_memory(needed, levels_, base::available_memory()), Fault::mesh);
  fast_.emplace(value_of(
      without_gil([&] { return FastRefiner::make(*rules_, std::move(mesh), levels_, sharpness_); }),
      Fault::other));
  vertices_ = fast_->vertex_count();
  tags_ = fast_->sharp_tags();
  faces_ = read_only(faces_of_refiner(*fast_));
}

/// Faces and tags as `refine` gives them: without holes, or where there is no fast engine.
void Refiner::take_surface() {
  if (fast_) {
    std::vector<Index> face_of(static_cast<std::size_t>(fast_->face_count()));
    fast_->write_parents(face_of);
    std::vector<bool> holes;
    holes.reserve(face_of.size());
    for (const Index f : face_of) holes.push_back(sharpness_.holes[static_cast<std::size_t>(f)]);
    const auto all = static_cast<std::size_t>(fast_->vertex_count());
    static_cast<void>(
        without_holes(refined_polygons(*fast_, std::vector<Point3>(all)), holes, kept_));
  }
  RefinedSurface made = surface(control_.positions, false);
  vertices_ = made.polygons.vertex_count();
  tags_ = std::move(made.sharp);
  faces_ = read_only(
      faces_object(std::move(made.polygons.face_begin), std::move(made.polygons.corners)));
}

/// The whole work anew, as `refine` does it.
RefinedSurface Refiner::surface(std::vector<Point3> points, bool limit) const {
  const SurfaceOptions options{
      .levels = levels_,
      .limit = limit,
      .normals = limit,
      .partial = true,
      .sharpness = sharpness_,
      .engine = fast_ ? SurfaceOptions::Engine::quick : SurfaceOptions::Engine::plain,
      .progress = on_progress};
  return value_of(without_gil([&]() -> Result<RefinedSurface> {
                    Result<Mesh> mesh = Mesh::build(control_);
                    if (!mesh) return mesh.error();
                    return refine_surface(*rules_, *std::move(mesh), std::move(points), options);
                  }),
                  Fault::other);
}

void Refiner::check_count(py::ssize_t count) const {
  if (count != control_count())
    raise({"there are values of " + std::to_string(count) + " vertices, and the control mesh has " +
           std::to_string(control_count())},
          Fault::mesh);
}

template <class Real>
void Refiner::sum(std::span<const Real> control, std::span<Real> fine) {
  if (fast_) {
    without_gil([&] {
      with_scratch<Real>([&](auto& scratch) {
        without_holes_of(
            fine, [&](const std::span<Real> all) { fast_->evaluate<Real>(control, all, scratch); });
      });
    });
    return;
  }
  std::vector<Point3> points(control.size() / 3);
  std::copy(control.begin(), control.end(), numbers_of(points).begin());
  const RefinedSurface made = surface(std::move(points), false);
  const std::span<const double> numbers = numbers_of(made.polygons.positions);
  std::transform(numbers.begin(), numbers.end(), fine.begin(),
                 [](double x) { return static_cast<Real>(x); });
}

template <class Real>
py::object Refiner::evaluate_points(const py::array& values, const py::object& out) {
  const std::span<const Real> control(static_cast<const Real*>(values.data()),
                                      static_cast<std::size_t>(values.size()));
  const std::size_t size = 3 * static_cast<std::size_t>(vertices_);
  if (out.is_none()) {
    base::HugeArray<Real> fine(size);
    sum<Real>(control, fine);
    return array_of(std::move(fine), {vertices_, 3});
  }
  if (!py::isinstance<py::array_t<Real, py::array::c_style>>(out))
    raise({"out is no contiguous array of the type of the values"}, Fault::mesh);
  auto array = py::reinterpret_borrow<py::array_t<Real, py::array::c_style>>(out);
  if (array.ndim() != 2 || array.shape(0) != vertices_ || array.shape(1) != 3 || !array.writeable())
    raise({"out is no (" + std::to_string(vertices_) + ", 3) array that can be written"},
          Fault::mesh);
  Real* const fine = array.mutable_data();
  if (fine < control.data() + control.size() && control.data() < fine + size)
    raise({"out overlaps the values"}, Fault::mesh);
  sum<Real>(control, {fine, size});
  return out;
}

/// Any number of columns, three at a time.
template <class Real>
py::object Refiner::evaluate_columns(const py::array& values, bool flat) {
  const std::size_t columns = flat ? 1 : static_cast<std::size_t>(values.shape(1));
  const auto count = static_cast<std::size_t>(control_count());
  const auto fine_count = static_cast<std::size_t>(vertices_);
  const Real* const from = static_cast<const Real*>(values.data());
  base::HugeArray<Real> result(fine_count * columns);
  std::vector<Real> three(3 * count), fine(3 * fine_count);
  for (std::size_t first = 0; first < columns; first += 3) {
    const std::size_t width = std::min<std::size_t>(3, columns - first);
    for (std::size_t v = 0; v < count; ++v)
      for (std::size_t c = 0; c < width; ++c) three[3 * v + c] = from[v * columns + first + c];
    sum<Real>(three, fine);
    for (std::size_t v = 0; v < fine_count; ++v)
      for (std::size_t c = 0; c < width; ++c) result[v * columns + first + c] = fine[3 * v + c];
  }
  if (flat) return array_of(std::move(result), {vertices_});
  return array_of(std::move(result), {vertices_, static_cast<py::ssize_t>(columns)});
}

py::object Refiner::evaluate(const py::object& values, const py::object& out) {
  const bool is_float = py::isinstance<py::array_t<float>>(values);
  py::array array;
  if (!is_float && !py::isinstance<py::array_t<double>>(values))
    if (const py::array given = py::array::ensure(values); given && given.dtype().kind() == 'c')
      raise({"the values are complex", "evaluate their real and imaginary parts as columns"},
            Fault::mesh);
  if (is_float)
    array = py::array_t<float, py::array::c_style>::ensure(values);
  else
    array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(values);
  if (!array) {
    PyErr_Clear();
    raise({"the values are no array of numbers"}, Fault::mesh);
  }
  if (array.ndim() != 1 && array.ndim() != 2)
    raise({"the values are not an (n, 3), an (n, k) or an (n) array"}, Fault::mesh);
  check_count(array.shape(0));
  if (array.ndim() == 2 && array.shape(1) == 3)
    return is_float ? evaluate_points<float>(array, out) : evaluate_points<double>(array, out);
  if (!out.is_none()) raise({"out is for (n, 3) arrays"}, Fault::mesh);
  const bool flat = array.ndim() == 1;
  return is_float ? evaluate_columns<float>(array, flat) : evaluate_columns<double>(array, flat);
}

/// Made when it is first asked for; nullptr where there is none.
const FastRefiner::Limit* Refiner::fast_limit() {
  const py::gil_scoped_release release;
  const std::lock_guard<std::mutex> lock(making_limit_);
  if (!limit_known_ && fast_) {
    Result<std::optional<FastRefiner::Limit>> made = approx_fast_limit(*rules_, *fast_);
    if (made) limit_ = *std::move(made);
    limit_known_ = true;
  }
  return limit_ ? &*limit_ : nullptr;
}

py::tuple Refiner::evaluate_limit(const py::object& vertices) {
  const Positions positions(vertices);
  check_count(positions.count());
  const FastRefiner::Limit* const limit = fast_limit();
  if (limit == nullptr) {
    positions.check_finite();
    RefinedSurface made = surface(positions.points(), true);
    return py::make_tuple(points_array(std::move(made.limit)),
                          points_array(std::move(made.normals)));
  }
  std::vector<Point3> held;
  if (positions.is_float) held = positions.points();  // floats lose half a digit a level
  const std::span<const double> control =
      positions.is_float ? std::span<const double>(numbers_of(std::as_const(held)))
                         : positions.numbers<double>();
  const std::size_t size = 3 * static_cast<std::size_t>(vertices_);
  base::HugeArray<double> points(size), normals(size);
  without_gil([&] {
    with_scratch<double>([&](auto& scratch) {
      without_holes_of<double>(points, [&](const std::span<double> all_points) {
        without_holes_of<double>(normals, [&](const std::span<double> all_normals) {
          fast_->evaluate_limit<double>(*limit, control, all_points, all_normals, scratch);
        });
      });
    });
  });
  return py::make_tuple(array_of(std::move(points), {vertices_, 3}),
                        array_of(std::move(normals), {vertices_, 3}));
}

}  // namespace

void bind_refiner(py::module_& module) {
  py::class_<Refiner>(module, "RefinerData")
      .def(py::init(&Refiner::make), py::arg("scheme"), py::arg("faces"), py::arg("levels"),
           py::arg("vertices"), py::arg("tags"))
      .def("evaluate", &Refiner::evaluate, py::arg("values"), py::arg("out") = py::none(),
           R"(The refined values from those of the control vertices.

values: (n, 3) positions; or (n, k) or (n,) of whatever is to be refined by the same rules. float32
gives float32, all else float64. out: a contiguous (vertex_count, 3) array of the same type that
takes the result and is returned. NaN passes through.)")
      .def("evaluate_limit", &Refiner::evaluate_limit, py::arg("vertices"),
           R"((P, N): the refined vertices on the limit surface and its unit normals, of float64.

vertices: (n, 3) positions. P and N are (vertex_count, 3). A normal is zero where the surface has
none, and at vertices on creases, which have one on each side: Scheme.refine gives these.)")
      .def_property_readonly(
          "faces", &Refiner::faces,
          "The refined faces, as Scheme.refine gives them; they cannot be written.")
      .def_property_readonly("control_faces", &Refiner::control_faces,
                             "The faces that it was made of.")
      .def_property_readonly("control_count", &Refiner::control_count,
                             "The number of control vertices.")
      .def_property_readonly("vertex_count", &Refiner::vertex_count,
                             "The number of refined vertices.")
      .def_property_readonly("tags", &Refiner::tags,
                             "What is still sharp of the refined mesh, as Scheme.refine takes it.")
      .def_property_readonly("control_tags", &Refiner::control_tags,
                             "What is sharp of the control mesh, as Scheme.refine takes it.")
      .def_property_readonly("scheme_data", &Refiner::scheme)
      .def_property_readonly("levels", &Refiner::levels, "The number of steps.")
      .def_property_readonly("is_fast", &Refiner::is_fast,
                             "Whether the fast engine evaluates; else the plain one refines anew "
                             "each time.")
      .def_property_readonly("bytes", &Refiner::bytes, "What the fast engine holds.");
}

}  // namespace limn::python
