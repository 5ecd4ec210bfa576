#pragma once
/// All of limn's public headers. Each can be included by itself, too.
///
/// A scheme is read from text and is plain data (scheme/scheme.h). The rest are functions of it:
///
///     limn::Result<limn::Scheme> scheme = limn::find_scheme("loop");        // or a file's path
///     limn::Result<limn::Polygons> polygons = limn::read_mesh("mesh.obj");
///     limn::Result<limn::Mesh> mesh = limn::Mesh::build(*polygons);
///     auto surface = limn::refine_surface(*scheme, *mesh, polygons->positions, {.levels = 4});
///     limn::Status written = limn::write_mesh("fine.ply", surface->polygons);
///
/// What a user can get wrong is a value (`Result`, base/error.h), never an exception; what cannot
/// be decided is `Truth::undecided`, with a reason. A name says what a function guarantees:
/// `approx_` is double precision, `enclose_` a bracket that is proved. Functions may be called from
/// several threads at once unless their comments say otherwise.

// Errors, truth values, bounds on time and threads.
#include "limn/base/budget.h"
#include "limn/base/error.h"
#include "limn/base/truth.h"
// Meshes and their files.
#include "limn/mesh/io/mesh_file.h"
#include "limn/mesh/mesh.h"
#include "limn/mesh/polygons.h"
#include "limn/mesh/split/split.h"
// Schemes.
#include "limn/scheme/file/scheme_files.h"
#include "limn/scheme/scheme.h"
// Refined meshes, limit surfaces.
#include "limn/fast/fast_refiner.h"
#include "limn/limit/limit_points.h"
#include "limn/limit/limit_stencil.h"
#include "limn/surface/refine_surface.h"
// The regular lattice: masks, factors, artifacts, smoothness.
#include "limn/regular/artifacts.h"
#include "limn/regular/regular_mask.h"
#include "limn/regular/smoothness/regularity.h"
// Extraordinary vertices: eigenvalues, verdicts, formulas, characteristic maps.
#include "limn/limit/characteristic_map.h"
#include "limn/spectrum/eigen_formula.h"
#include "limn/spectrum/eigencomponents.h"
#include "limn/spectrum/frequency_blocks.h"
// How fair surfaces are.
#include "limn/fairness/energy.h"
// Parameters solved for.
#include "limn/tune/freed_scheme.h"
#include "limn/tune/solve.h"
