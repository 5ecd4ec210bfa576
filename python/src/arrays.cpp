#include "arrays.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "errors.h"
#include "limn/mesh/mesh_limits.h"

namespace limn::python {
namespace {

[[noreturn]] void refuse(std::string message, std::string hint = {}) {
  raise({std::move(message), std::move(hint)}, Fault::mesh);
}

constexpr const char* kFacesHint =
    "an (m, k) array of integers, a tuple (corners, offsets), or a list of lists";

/// As an array of NumPy; what it cannot make one of is refused.
py::array as_array(const py::object& object, const std::string& what) {
  py::array array = py::array::ensure(object);
  if (!array) refuse(what + " are no array of numbers");
  return array;
}

bool is_integer(const py::array& array) {
  const char kind = array.dtype().kind();
  return kind == 'i' || kind == 'u';
}

/// The numbers in order, as indices.
std::vector<Index> to_indices(const py::array& array, const std::string& what) {
  if (array.size() == 0) return {};
  if (!is_integer(array))
    refuse(what + " are not whole numbers", "convert them by .astype('int32')");
  if (array.dtype().is(py::dtype::of<Index>())) {
    const auto plain = py::array_t<Index, py::array::c_style>::ensure(array);
    return {plain.data(), plain.data() + plain.size()};
  }
  if (array.dtype().kind() == 'u' && array.dtype().itemsize() == 8) {
    const auto wide = py::array_t<std::uint64_t, py::array::c_style>::ensure(array);
    for (py::ssize_t i = 0; i < wide.size(); ++i)
      if (wide.data()[i] > mesh::kMostElements) refuse(what + " have a number beyond 2^31");
  }
  const auto wide =
      py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>::ensure(array);
  std::vector<Index> result(static_cast<std::size_t>(wide.size()));
  for (py::ssize_t i = 0; i < wide.size(); ++i) {
    const std::int64_t value = wide.data()[i];
    if (value > std::numeric_limits<Index>::max() || value < std::numeric_limits<Index>::min())
      refuse(what + " have a number beyond 2^31");
    result[static_cast<std::size_t>(i)] = static_cast<Index>(value);
  }
  return result;
}

void check_size(std::size_t faces, std::size_t corners) {
  if (const auto fault = mesh::too_many(0, faces, corners)) raise(*fault, Fault::mesh);
}

Polygons uniform_faces(const py::array& array) {
  const auto degree = static_cast<std::size_t>(array.shape(1));
  const auto count = static_cast<std::size_t>(array.shape(0));
  check_size(count, static_cast<std::size_t>(array.size()));
  Polygons polygons;
  polygons.corners = to_indices(array, "faces");
  polygons.face_begin.resize(count + 1);
  for (std::size_t f = 0; f <= count; ++f) polygons.face_begin[f] = static_cast<Index>(f * degree);
  return polygons;
}

Polygons mixed_faces(const py::object& corners, const py::object& offsets) {
  Polygons polygons;
  polygons.corners = indices_of(corners, 0, "corners");
  polygons.face_begin = indices_of(offsets, 0, "offsets");
  const std::vector<Index>& begin = polygons.face_begin;
  check_size(begin.size(), polygons.corners.size());
  if (begin.empty() || begin.front() != 0 || !std::is_sorted(begin.begin(), begin.end()) ||
      static_cast<std::size_t>(begin.back()) != polygons.corners.size())
    refuse("offsets are not those of the corners",
           "they rise from 0 to the number of corners, one more than there are faces");
  return polygons;
}

Polygons listed_faces(const py::list& list) {
  Polygons polygons;
  for (const py::handle item : list) {
    const std::vector<Index> face =
        indices_of(py::reinterpret_borrow<py::object>(item), 0, "a face's corners");
    polygons.corners.insert(polygons.corners.end(), face.begin(), face.end());
    check_size(list.size(), polygons.corners.size());
    polygons.face_begin.push_back(static_cast<Index>(polygons.corners.size()));
  }
  return polygons;
}

}  // namespace

py::array_t<double> points_array(std::vector<Point3> points) {
  const auto size = static_cast<py::ssize_t>(points.size());
  auto owner = std::make_unique<std::vector<Point3>>(std::move(points));
  const double* const data = owner->empty() ? nullptr : &owner->front().x;
  return array_over<double>(std::move(owner), data, {size, 3});
}

py::object faces_object(std::vector<Index> face_begin, std::vector<Index> corners) {
  const auto faces = static_cast<py::ssize_t>(face_begin.size()) - 1;
  const Index degree = faces > 0 ? face_begin[1] : 3;
  bool uniform = true;
  for (std::size_t f = 0; f < face_begin.size() && uniform; ++f)
    uniform = face_begin[f] == static_cast<Index>(f) * degree;
  if (uniform) return array_of(std::move(corners), {faces, degree});
  return py::make_tuple(array_of(std::move(corners)), array_of(std::move(face_begin)));
}

py::object faces_object(const Polygons& polygons) {
  return faces_object(polygons.face_begin, polygons.corners);
}

Polygons faces_of(const py::object& faces) {
  if (py::isinstance<py::tuple>(faces)) {
    const auto pair = py::reinterpret_borrow<py::tuple>(faces);
    if (pair.size() == 2) return mixed_faces(pair[0], pair[1]);
  } else if (py::isinstance<py::list>(faces)) {
    return listed_faces(py::reinterpret_borrow<py::list>(faces));
  }
  const py::array array = as_array(faces, "faces");
  if (array.ndim() == 2 && array.shape(1) >= 3) return uniform_faces(array);
  refuse("faces are not in a shape that faces have", kFacesHint);
}

Index least_vertex_count(const Polygons& polygons) {
  Index most = -1;
  for (const Index v : polygons.corners) most = std::max(most, v);
  return most + 1;
}

Positions::Positions(const py::object& object) : array(as_array(object, "positions")) {
  if (array.ndim() != 2 || array.shape(1) != 3) {
    std::string shape;
    for (py::ssize_t i = 0; i < array.ndim(); ++i)
      shape += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
    refuse("positions are not an (n, 3) array but (" + shape + ")",
           "x, y, z of each vertex; put zeros for a coordinate that is not there");
  }
  const char kind = array.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u' && kind != 'b')
    refuse("positions are no real numbers");
  if (const auto fault = mesh::too_many(static_cast<std::size_t>(count()), 0, 0))
    raise(*fault, Fault::mesh);
  is_float = py::isinstance<py::array_t<float>>(array);
  if (is_float)
    array = py::array_t<float, py::array::c_style>::ensure(array);
  else
    array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(array);
  if (!array) throw py::error_already_set();
}

std::vector<Point3> Positions::points() const {
  std::vector<Point3> points(static_cast<std::size_t>(count()));
  const std::span<double> numbers_out = numbers_of(points);
  if (is_float)
    std::copy_n(numbers<float>().begin(), numbers_out.size(), numbers_out.begin());
  else
    std::copy_n(numbers<double>().begin(), numbers_out.size(), numbers_out.begin());
  return points;
}

void Positions::check_finite() const {
  const auto look = [](const auto numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (!std::isfinite(numbers[i]))
        refuse("vertex " + std::to_string(i / 3) + " has a coordinate that is not finite");
  };
  is_float ? look(numbers<float>()) : look(numbers<double>());
}

std::vector<Index> indices_of(const py::object& object, py::ssize_t width, const char* what) {
  const py::array array = as_array(object, what);
  const bool fits = width == 0 ? array.ndim() == 1 : (array.ndim() == 2 && array.shape(1) == width);
  if (!fits && array.size() > 0)
    refuse(std::string(what) + " are not in a shape of " +
           (width == 0 ? "one dimension" : "(n, " + std::to_string(width) + ")"));
  return to_indices(array, what);
}

std::vector<double> numbers_for(const py::object& object, std::size_t count, const char* what) {
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(object);
  if (!array) {
    PyErr_Clear();
    refuse(std::string(what) + " is no number");
  }
  const auto size = static_cast<std::size_t>(array.size());
  if (array.ndim() > 1 || (array.ndim() == 1 && size != count))
    refuse(std::string(what) + " is neither one number nor one for each");
  std::vector<double> numbers(count, array.ndim() == 0 ? *array.data() : 0);
  if (array.ndim() == 1) std::copy_n(array.data(), count, numbers.begin());
  for (const double number : numbers)
    if (std::isnan(number)) refuse(std::string(what) + " is not a number");
  return numbers;
}

}  // namespace limn::python
