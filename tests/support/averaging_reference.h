#pragma once
/// Lane and Riesenfeld's averaging on any mesh, typed a second time on lists of faces: nothing of
/// scheme/ or refine/ is used, and of the mesh only which vertices, edges and faces it has.

#include <vector>

#include "limn/mesh/mesh.h"

namespace limn::test {

/// One step of degree `degree` ≥ 1: the mesh is cut by quads, its values bilinearly, and then
/// averaged degree - 1 times [ZorinSchroeder2001]. `stam` 1: of two averagings together an inner
/// vertex of n edges gets (n-3)/n, its neighbours 2/n² and opposite corners 1/n² [Stam2001];
/// between 0 and 1 a blend. Odd degrees: values at old vertices, then edges, then faces; even ones:
/// at the corners (half-edges), then at isolated vertices.
[[nodiscard]] std::vector<double> averaging_reference_step(int degree, double stam,
                                                           const Mesh& mesh,
                                                           const std::vector<double>& old);

}  // namespace limn::test
