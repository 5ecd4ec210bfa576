#include "refined_faces.h"

#include "arrays.h"
#include "call.h"

namespace limn::python {

py::object faces_of_refiner(const FastRefiner& refiner) {
  base::HugeArray<Index> corners(static_cast<std::size_t>(refiner.corner_count()));
  without_gil([&] { refiner.write_faces(corners); });
  const py::ssize_t faces = refiner.face_count();
  if (const Index degree = refiner.corners_per_face(); degree > 0)
    return array_of(std::move(corners), {faces, degree});
  base::HugeArray<Index> begin(static_cast<std::size_t>(faces) + 1);
  without_gil([&] { refiner.write_face_begin(begin); });
  const auto count = static_cast<py::ssize_t>(corners.size());
  return py::make_tuple(array_of(std::move(corners), {count}),
                        array_of(std::move(begin), {faces + 1}));
}

}  // namespace limn::python
