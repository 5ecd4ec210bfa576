// Proofs for steps that are sequences of averagings.

#include <gtest/gtest.h>

#include "limn/certify/certify.h"
#include "limn/number/ball.h"
#include "support/spline_scheme.h"

namespace limn::test {
namespace {

/// Proved, and shown again from the certificate alone.
TEST(StagedCertify, DegreesTwoAndThreeAreC1) {
  if (!number::Ball::is_available()) GTEST_SKIP() << "built without Arb";
  for (const int degree : {2, 3}) {
    const Scheme scheme = spline_of_degree(degree);
    const Result<certify::Certificate> found = certify::certify(scheme, {3, 4, 5, 6, 9});
    ASSERT_TRUE(found.ok()) << found.error().text();
    EXPECT_EQ(found->regular.c1, certify::Answer::proved)
        << degree << ": " << found->regular.reason;
    for (const certify::ValenceClaim& claim : found->valences)
      EXPECT_EQ(claim.c1, certify::Answer::proved)
          << degree << ", valence " << claim.valence << ": " << claim.reason;
    const Status checked = certify::check_certificate(*found);
    EXPECT_TRUE(checked.ok()) << checked.error().text();
  }
}

}  // namespace
}  // namespace limn::test
