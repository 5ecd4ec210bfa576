// Analyses a scheme that is given as text: analyse
#include <cstdio>

#include "limn/limn.h"

namespace {

// Loop's scheme with Warren's weight, which is 1/16 at n = 6 as well. The second argument of
// parse_scheme is the name that messages have.
constexpr const char* kScheme = R"toml(
split  = "triangle-dyadic"
let.beta = "3/(8*n)"
vertex = { self = "1 - n*beta", ring = "beta" }
edge   = { end = "3/8", wing = "1/8" }
)toml";

int fail(const limn::Error& error) {
  std::fprintf(stderr, "%s\n", error.text().c_str());
  return 2;
}

const char* word(limn::Truth truth) { return limn::to_string(truth).data(); }

}  // namespace

int main() {
  const limn::Result<limn::Scheme> scheme = limn::parse_scheme(kScheme, "analyse.toml");
  if (!scheme) return fail(scheme.error());

  const limn::Result<limn::Mask> mask = limn::regular_mask(*scheme);
  if (!mask) return fail(mask.error());
  const limn::Result<limn::Regularity> lattice = limn::enclose_regularity(*mask);
  if (!lattice) return fail(lattice.error());
  std::printf("regular lattice: Hölder exponent at least %.4f\n", lattice->holder.lower);
  for (std::size_t r = 0; r < lattice->smoothness.size(); ++r)
    std::printf("  C%zu: %s\n", r, word(lattice->smoothness[r].verdict));

  limn::FrequencyAnalysis analysis(*scheme);
  const limn::RegularPart regular = limn::find_regular_part(*scheme);
  for (int n = 3; n <= 8; ++n) {
    const limn::Result<limn::FrequencyBlocks> blocks = analysis.blocks(n);
    if (!blocks) return fail(blocks.error());
    const limn::Eigencomponents found = limn::approx_eigencomponents(*blocks, regular);
    std::printf("valence %d: tangent %.6f, C1 necessary: %s, curvature bounded: %s\n", n,
                found.tangent.value_or(0), word(found.verdict.c1_necessary),
                word(found.verdict.bounded_curvature));
  }
  return 0;
}
