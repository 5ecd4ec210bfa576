#include "limn/refine/refine.h"

namespace limn::refine {

template Result<Refined<Point3>> refine<Point3, double>(const Scheme&, Mesh, std::vector<Point3>,
                                                        int, const RefineProgress&, Sharpness);

}  // namespace limn::refine
