#include "limn/scheme/lattice_schemes.h"

#include <algorithm>
#include <cassert>

#include <fmt/core.h>

#include "limn/scheme/check.h"
#include "limn/scheme/stages.h"

namespace limn {
namespace {

Scheme on_lattice(const Scheme& scheme, Lattice lattice) {
  Scheme half = scheme;
  half.stages->only = lattice;
  half.split = split_of_stages(*half.stages);
  const std::string_view quads = lattice == Lattice::triangle ? "0" : "n";
  half.lets.emplace_back(kQuads, Formula{Expression::parse(quads).value(), {}});
  std::erase_if(half.facts, [&](const Fact& fact) { return fact.lattice != lattice; });
  return half;
}

}  // namespace

std::string_view lattice_name(Lattice lattice) {
  return lattice == Lattice::triangle ? "triangle" : "quad";
}

std::vector<Scheme> lattice_schemes(const Scheme& scheme) {
  if (!scheme.split->mixed) return {scheme};
  return {on_lattice(scheme, Lattice::triangle), on_lattice(scheme, Lattice::quad)};
}

Status check_one_lattice(const Scheme& scheme) {
  if (!scheme.split->mixed) return Done{};
  return Error{fmt::format("scheme '{}' has no single lattice: its meshes have triangles and quads",
                           scheme.name),
               "limn eigen, regularity, artifacts, show and compare tell of either; --faces of a "
               "vertex where both meet"};
}

}  // namespace limn
