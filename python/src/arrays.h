#pragma once
/// NumPy arrays in and out. What goes in is read in place where its layout allows; what comes out
/// owns the memory that the library made it in.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <utility>
#include <vector>

#include "limn/base/huge_array.h"
#include "limn/mesh/polygons.h"

namespace limn::python {

namespace py = pybind11;

/// An array of this shape over memory that `owner` holds; the array owns `owner`. `data` points
/// into it.
template <class T, class Owner>
py::array_t<T> array_over(std::unique_ptr<Owner> owner, const T* data,
                          std::vector<py::ssize_t> shape) {
  Owner* const held = owner.get();
  const py::capsule base(held, [](void* memory) { delete static_cast<Owner*>(memory); });
  static_cast<void>(owner.release());
  return py::array_t<T>(std::move(shape), data, base);
}

template <class T>
py::array_t<T> array_of(std::vector<T> values, std::vector<py::ssize_t> shape) {
  auto owner = std::make_unique<std::vector<T>>(std::move(values));
  const T* const data = owner->data();
  return array_over<T>(std::move(owner), data, std::move(shape));
}
template <class T>
py::array_t<T> array_of(std::vector<T> values) {
  const auto size = static_cast<py::ssize_t>(values.size());
  return array_of(std::move(values), {size});
}
template <class T>
py::array_t<T> array_of(base::HugeArray<T> values, std::vector<py::ssize_t> shape) {
  auto owner = std::make_unique<base::HugeArray<T>>(std::move(values));
  const T* const data = owner->data();
  return array_over<T>(std::move(owner), data, std::move(shape));
}

/// (n, 3) of float64, over the memory of the points.
[[nodiscard]] py::array_t<double> points_array(std::vector<Point3> points);

/// Faces as arrays of int32: (m, k) where all have k corners, else (corners, offsets), where face i
/// has the corners from offsets[i] to offsets[i + 1].
[[nodiscard]] py::object faces_object(std::vector<Index> face_begin, std::vector<Index> corners);
[[nodiscard]] py::object faces_object(const Polygons& polygons);

/// Faces as Python gives them: an (m, k) array of integers, k ≥ 3; a tuple (corners, offsets); or a
/// list of sequences. `positions` is left empty. Raises MeshError on anything else, and on numbers
/// beyond 2^31; whether corners are vertices is left to Mesh::build.
[[nodiscard]] Polygons faces_of(const py::object& faces);

/// One more than the largest corner; 0 without corners.
[[nodiscard]] Index least_vertex_count(const Polygons& polygons);

/// An (n, 3) array of numbers; others than float32 and float64 are converted. Raises MeshError
/// where it has another shape or is no array of numbers.
struct Positions {
  py::array array;  ///< contiguous; of float or of double
  bool is_float = false;

  explicit Positions(const py::object& object);
  [[nodiscard]] py::ssize_t count() const { return array.shape(0); }
  template <class Real>
  [[nodiscard]] std::span<const Real> numbers() const {
    return {static_cast<const Real*>(array.data()), static_cast<std::size_t>(3 * count())};
  }
  [[nodiscard]] std::vector<Point3> points() const;
  /// Raises MeshError that names the first vertex with a coordinate that is not finite.
  void check_finite() const;
};

/// Whole numbers in one dimension, or (n, width); others raise MeshError, which calls them `what`.
[[nodiscard]] std::vector<Index> indices_of(const py::object& object, py::ssize_t width,
                                            const char* what);

/// A number for each of `count`, or one for all. Infinite ones are allowed, NaN is not.
[[nodiscard]] std::vector<double> numbers_for(const py::object& object, std::size_t count,
                                              const char* what);

}  // namespace limn::python
