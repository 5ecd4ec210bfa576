#include "limn/scheme/lattice_schemes.h"

#include <vector>

#include <fmt/core.h>

#include "limn/scheme/stages.h"

namespace limn::scheme {
namespace {

Scheme on_lattice(const Scheme& scheme, Lattice lattice) {
  Scheme half = scheme;
  restrict_stages(half, lattice);
  half.split = split_of_stages(*half.stages);
  std::erase_if(half.facts, [&](const Fact& fact) { return fact.lattice != lattice; });
  return half;
}

}  // namespace

std::string_view lattice_name(Lattice lattice) {
  return lattice == Lattice::triangle ? "triangle" : "quad";
}

std::string label_on_lattice(const std::string& name, const Scheme& scheme) {
  if (!scheme.stages || !scheme.stages->only) return name;
  return fmt::format("{} on {}s", name, lattice_name(*scheme.stages->only));
}

std::vector<Scheme> lattice_schemes(const Scheme& scheme) {
  if (!scheme.split->mixed) return {scheme};
  return {on_lattice(scheme, Lattice::triangle), on_lattice(scheme, Lattice::quad)};
}

Status check_one_lattice(const Scheme& scheme) {
  if (!scheme.split->mixed) return Done{};
  return Error{fmt::format("scheme '{}' has no single lattice: its meshes have triangles and quads",
                           scheme.name),
               fmt::format("a scheme file of its own has what it is on one: extends = \"{}\" and "
                           "lattice = \"triangle\" or \"quad\"",
                           scheme.name)};
}

}  // namespace limn::scheme
