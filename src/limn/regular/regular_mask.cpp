#include "limn/regular/regular_mask.h"

#include <algorithm>

#include <fmt/core.h>

#include "limn/mesh/lattice.h"
#include "limn/number/exact.h"
#include "limn/refine/linear_form.h"
#include "limn/refine/refine_values.h"
#include "limn/scheme/lattice_schemes.h"
#include "limn/scheme/mask_rules.h"

namespace limn {
namespace {

constexpr Index kSide = 16;  // of the torus; twice what the widest stencils reach

/// Adds the coefficients that one new vertex's form tells.
Status collect(const Scheme& scheme, mesh::Twelfths birth,
               const refine::LinearForm<number::Exact>& form, Mask& mask) {
  for (const auto& [vertex, value] : form.terms) {
    if (value.is_zero()) continue;
    if (!value.is_rational())
      return Error{fmt::format("the regular mask of '{}' is not rational", scheme.name),
                   {},
                   scheme.file,
                   0,
                   0};
    const mesh::Twelfths old{12 * (vertex % kSide), 12 * (vertex / kSide)};
    const auto offset =
        scheme::mask_offset(mask.dilation, mesh::torus_difference(old, birth, kSide, kSide));
    mask.coefficients.insert_or_assign(offset, value.rational());
  }
  return Done{};
}

}  // namespace

Result<Mask> regular_mask(const Scheme& scheme) {
  if (Status status = scheme::check_one_lattice(scheme); !status) return status.error();
  const Split& split = *scheme.split;
  if (scheme.mask) return scheme::mask_from_rows(scheme, *scheme.mask);
  if (scheme.factors) return scheme::mask_from_factors(scheme, *scheme.factors);
  const Mesh mesh = mesh::torus(split.lattice, kSide, kSide);
  const SplitResult fine = split.apply(mesh, 0);
  refine::RuleTables<number::Exact> tables(scheme);
  if (Status status = tables.prepare(mesh, fine.births); !status) return status.error();
  const std::vector<refine::LinearForm<number::Exact>> forms = refine::refine_values(
      scheme, mesh, fine.births, tables, refine::unit_forms<number::Exact>(mesh.vertex_count()));
  Mask mask{split.lattice, split.dilation, {}};
  for (Index v = 0; v < fine.mesh.vertex_count(); ++v) {
    const mesh::Twelfths birth = mesh::torus_birth_place(mesh, kSide, kSide, fine.births, v);
    if (Status status = collect(scheme, birth, forms[v], mask); !status) return status.error();
  }
  return mask;
}

std::string to_string(const Mask& mask) {
  Integer common = 1;
  int reach = 0;
  for (const auto& [offset, value] : mask.coefficients) {
    common = lcm(common, denominator(value));
    reach = std::max({reach, std::abs(offset[0]), std::abs(offset[1]),
                      mask.lattice == Lattice::triangle ? std::abs(offset[0] - offset[1]) : 0});
  }
  const auto entry = [&](int a, int b) {
    const auto found = mask.coefficients.find({a, b});
    const Rational value = found == mask.coefficients.end() ? Rational(0) : found->second;
    return to_string(Rational(value * Rational(common)));
  };
  std::size_t width = 1;
  for (const auto& [offset, value] : mask.coefficients)
    width = std::max(width, entry(offset[0], offset[1]).size());
  width += width % 2 == 0 ? 2 : 1;  // odd cell + blank, so that half a cell is whole
  std::string text;
  for (int b = reach; b >= -reach; b -= 2) {
    const bool triangles = mask.lattice == Lattice::triangle;
    const int first = triangles ? std::max(-reach, b - reach) : -reach;
    const int last = triangles ? std::min(reach, b + reach) : reach;
    std::string line(triangles ? static_cast<std::size_t>(std::abs(b)) / 2 * width / 2 : 0, ' ');
    for (int a = first; a <= last; a += 2) line += fmt::format("{:>{}}", entry(a, b), width);
    text += line + '\n';
  }
  if (common != 1) text = fmt::format("1/{} ×\n", common.str()) + text;
  return text;
}

}  // namespace limn
