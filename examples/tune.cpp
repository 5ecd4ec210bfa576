// Finds the weights for which a scheme has bounded curvature at a vertex: tune
#include <cstdio>

#include "limn/limn.h"

namespace {

int fail(const limn::Error& error) {
  std::fprintf(stderr, "%s\n", error.text().c_str());
  return 2;
}

}  // namespace

int main() {
  const limn::Result<limn::Scheme> scheme = limn::find_scheme("loop");
  if (!scheme) return fail(scheme.error());
  limn::Result<limn::FreedScheme> freed = limn::FreedScheme::make(*scheme, "beta");
  if (!freed) return fail(freed.error());
  const limn::Result<limn::Requirement> requirement =
      limn::Requirement::parse("cup = tangent^2", *scheme);
  if (!requirement) return fail(requirement.error());
  for (int n = 5; n <= 9; ++n) {
    const limn::Result<limn::ValenceSolutions> found = limn::solve_at(*freed, *requirement, n);
    if (!found) return fail(found.error());
    for (const limn::Solution& one : found->solutions)
      if (one.holds == limn::Truth::yes)
        std::printf("valence %d: beta = %.12f (residual %.1g)\n", n, one.value, one.residual);
  }
  return 0;
}
