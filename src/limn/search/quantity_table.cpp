#include "limn/search/quantity_table.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "limn/mesh/mesh.h"
#include "limn/mesh/surface_distance.h"
#include "limn/regular/artifacts.h"
#include "limn/study/compare_record.h"
#include "limn/study/fairness_record.h"
#include "limn/surface/refine_surface.h"

namespace limn::search {
namespace {

using Kind = QuantityRow::Kind;
using Arguments = QuantityArguments;

// ------------------------------------------------------------------------------ the lattice

Result<double> artifact(SchemeReading& scheme, const Arguments& at) {
  if (!scheme.artifacts()) return scheme.artifacts().error();
  return scheme.artifacts()->in_limit({at.numbers[0], at.numbers[1]}).percent_of_signal();
}

Result<double> artifact_energy(SchemeReading& scheme, const Arguments& at) {
  if (!scheme.artifacts()) return scheme.artifacts().error();
  return scheme.artifacts()->energy_percent({at.numbers[0], at.numbers[1]});
}

Result<double> worst_artifact(SchemeReading& scheme, const Arguments& at) {
  if (!scheme.artifacts()) return scheme.artifacts().error();
  if (!(at.numbers[0] > 0)) return Error{"a wave has more than 0 edges"};
  return study::wave_artifacts(*scheme.artifacts(), at.numbers[0]).worst;
}

Result<double> density(SchemeReading& scheme, const Arguments& at) {
  if (!scheme.artifacts()) return scheme.artifacts().error();
  const Result<SamplingDensity> found =
      sampling_density(*scheme.artifacts(), at.numbers[0], ArtifactMeasure::total_energy);
  if (!found) return found.error();
  return found->worst.edges_per_wavelength;
}

Result<double> holder_lower(SchemeReading& scheme, const Arguments&) {
  if (!scheme.regularity()) return scheme.regularity().error();
  return scheme.regularity()->holder.lower;
}

Result<double> holder_upper(SchemeReading& scheme, const Arguments&) {
  if (!scheme.regularity()) return scheme.regularity().error();
  const HolderBracket& holder = scheme.regularity()->holder;
  if (holder.upper) return *holder.upper;
  if (!holder.exact.empty()) return holder.lower;  // of a box spline
  return Error{"the Hölder exponent has no upper bound: shifts are not proved stable"};
}

Result<double> sum_rules(SchemeReading& scheme, const Arguments&) {
  if (!scheme.regularity()) return scheme.regularity().error();
  return scheme.regularity()->orders.sum_rules;
}

// ----------------------------------------------------------------------------- the vertices

Result<double> component(SchemeReading& scheme, int n, std::optional<double> Eigencomponents::*one,
                         std::string_view name) {
  const Result<Eigencomponents>& found = scheme.components(n);
  if (!found) return found.error();
  if ((*found).*one) return *((*found).*one);
  return Error{fmt::format("there is no {} at valence {}", name, n)};
}

int valence_of(const Arguments& at) { return static_cast<int>(at.numbers[0]); }

Result<double> tangent(SchemeReading& scheme, const Arguments& at) {
  return component(scheme, valence_of(at), &Eigencomponents::tangent, "tangent");
}

Result<double> cup(SchemeReading& scheme, const Arguments& at) {
  return component(scheme, valence_of(at), &Eigencomponents::cup, "cup");
}

Result<double> saddle(SchemeReading& scheme, const Arguments& at) {
  return component(scheme, valence_of(at), &Eigencomponents::saddle, "saddle");
}

/// The largest |one − tangent²| over the valences that have it.
Result<double> largest_gap(SchemeReading& scheme, std::optional<double> Eigencomponents::*one,
                           std::string_view name, int least_valence) {
  double largest = 0;
  for (const int n : scheme.valences()) {
    if (n < least_valence) continue;
    const Result<double> value = component(scheme, n, one, name);
    const Result<double> slope = component(scheme, n, &Eigencomponents::tangent, "tangent");
    if (!value) return value;
    if (!slope) return slope;
    largest = std::max(largest, std::abs(*value - *slope * *slope));
  }
  return largest;
}

constexpr int kFirstSaddle = 4;  // valence 3 has no frequency 2 of its own

Result<double> cup_gap(SchemeReading& scheme, const Arguments&) {
  return largest_gap(scheme, &Eigencomponents::cup, "cup", 3);
}

Result<double> saddle_gap(SchemeReading& scheme, const Arguments&) {
  return largest_gap(scheme, &Eigencomponents::saddle, "saddle", kFirstSaddle);
}

// ----------------------------------------------------------------------------- the surfaces

Result<study::FairnessLevel> fairness(SchemeReading& scheme, const Arguments& at) {
  Result<Mesh> mesh = Mesh::build(*at.mesh);
  if (!mesh) return mesh.error();
  study::FairnessOptions options;
  options.levels = static_cast<int>(at.numbers[0]);
  const Result<study::FairnessRecord> record =
      study::approx_fairness({}, scheme.scheme(), *mesh, at.mesh->positions, options);
  if (!record) return record.error();
  return record->last();
}

Result<double> thin_plate(SchemeReading& scheme, const Arguments& at) {
  const Result<study::FairnessLevel> level = fairness(scheme, at);
  if (!level) return level.error();
  return level->energies.thin_plate;
}

Result<double> curvature_variation(SchemeReading& scheme, const Arguments& at) {
  const Result<study::FairnessLevel> level = fairness(scheme, at);
  if (!level) return level.error();
  return level->energies.curvature_variation;
}

}  // namespace

Result<Polygons> limit_surface(const Scheme& scheme, const Polygons& control, int levels) {
  Result<Mesh> mesh = Mesh::build(control);
  if (!mesh) return mesh.error();
  SurfaceOptions options;
  options.levels = levels;
  options.limit = true;
  Result<RefinedSurface> surface =
      refine_surface(scheme, *std::move(mesh), control.positions, options);
  if (!surface) return surface.error();
  surface->polygons.positions = std::move(surface->limit);
  return std::move(surface->polygons);
}

namespace {

Result<double> distance(SchemeReading& scheme, const Arguments& at) {
  const Result<Polygons> own =
      limit_surface(scheme.scheme(), *at.mesh, static_cast<int>(at.numbers[0]));
  if (!own) return own.error();
  const Result<mesh::SurfaceDistance> apart = mesh::approx_surface_distance(*own, *at.reference);
  if (!apart) return apart.error();
  return 100 * apart->largest / apart->diagonal;
}

std::vector<QuantityRow> make_quantities() {
  const QuantityRow::Argument fx{"fx", Kind::number}, fy{"fy", Kind::number};
  const QuantityRow::Argument n{"n", Kind::valence}, mesh{"mesh", Kind::mesh};
  const QuantityRow::Argument levels{"levels", Kind::levels};
  return {
      {"artifact",
       {fx, fy},
       "artifacts of the wave (fx, fy) in the limit, by ADS's mean energy",
       "% of the signal",
       "milliseconds",
       artifact},
      {"artifact_energy",
       {fx, fy},
       "all waves that the limit of the wave (fx, fy) has beside it",
       "% of the signal",
       "milliseconds",
       artifact_energy},
      {"worst_artifact",
       {{"edges", Kind::number}},
       "artifact_energy of waves of so many control edges in their worst direction",
       "% of the signal",
       "milliseconds",
       worst_artifact},
      {"sampling_density",
       {{"percent", Kind::number}},
       "control edges a wavelength that keep artifact_energy below so many percent in every "
       "direction",
       "edges",
       "tenths of a second",
       density},
      {"holder_lower",
       {},
       "proved lower bound of the Hölder exponent on the regular lattice",
       "",
       "milliseconds to seconds",
       holder_lower},
      {"holder_upper",
       {},
       "proved upper bound of the same",
       "",
       "milliseconds to seconds",
       holder_upper},
      {"sum_rules", {}, "order of the sum rules", "", "milliseconds to seconds", sum_rules},
      {"tangent",
       {n},
       "eigenvalue that leads frequency 1 at valence n",
       "",
       "milliseconds",
       tangent},
      {"cup", {n}, "second eigenvalue of frequency 0 at valence n", "", "milliseconds", cup},
      {"saddle", {n}, "eigenvalue that leads frequency 2 at valence n", "", "milliseconds", saddle},
      {"cup_gap",
       {},
       "the largest |cup - tangent^2| over the study's valences",
       "",
       "milliseconds a valence",
       cup_gap},
      {"saddle_gap",
       {},
       "the largest |saddle - tangent^2| over the study's valences from 4 on",
       "",
       "milliseconds a valence",
       saddle_gap},
      {"thin_plate",
       {mesh, levels},
       "integral of k1^2 + k2^2 over the limit surface of a mesh",
       "",
       "microseconds a vertex",
       thin_plate},
      {"curvature_variation",
       {mesh, levels},
       "integral of the squared derivative of the second fundamental form",
       "1/length^2",
       "microseconds a vertex",
       curvature_variation},
      {"distance",
       {{"scheme", Kind::scheme}, mesh, levels},
       "largest distance to the limit surface of another scheme",
       "% of the mesh's diagonal",
       "microseconds a vertex",
       distance},
  };
}

}  // namespace

const std::vector<QuantityRow>& quantities() {
  static const std::vector<QuantityRow> rows = make_quantities();
  return rows;
}

}  // namespace limn::search
