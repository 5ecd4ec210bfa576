#include "limn/search/scheme_reading.h"

#include <utility>

#include "limn/certify/certify.h"
#include "limn/regular/regular_mask.h"
#include "limn/regular/smoothness/regularity.h"

namespace limn::search {
namespace {

Result<ArtifactAnalysis> artifacts_of(const Result<Mask>& mask) {
  if (!mask) return mask.error();
  Result<ArtifactAnalysis> analysis = ArtifactAnalysis::of(*mask);
  if (!analysis) return analysis;
  if (!analysis->limit_status()) return analysis->limit_status().error();
  if (!analysis->energy_status()) return analysis->energy_status().error();
  return analysis;
}

}  // namespace

SchemeReading::SchemeReading(Scheme scheme, std::vector<int> valences, const Effort& effort,
                             certify::CertifyOptions proofs)
    : scheme_(std::move(scheme)),
      valences_(std::move(valences)),
      effort_(effort),
      proofs_(std::move(proofs)),
      frequencies_(scheme_) {}

const Result<Mask>& SchemeReading::mask() {
  if (!mask_) mask_ = regular_mask(scheme_);
  return *mask_;
}

const Result<ArtifactAnalysis>& SchemeReading::artifacts() {
  if (!artifacts_) artifacts_ = artifacts_of(mask());
  return *artifacts_;
}

const Result<Regularity>& SchemeReading::regularity() {
  if (regularity_) return *regularity_;
  RegularityOptions options;
  options.budget = effort_.regularity;
  options.tolerance = effort_.tolerance;
  options.most_steps = 0;  // the bracket is what is asked for
  regularity_ = mask() ? enclose_regularity(*mask(), options) : Result<Regularity>(mask().error());
  return *regularity_;
}

const RegularPart& SchemeReading::regular_part() {
  if (!regular_part_)
    regular_part_ =
        mask() ? find_regular_part(*mask()) : RegularPart{Truth::undecided, mask().error().message};
  return *regular_part_;
}

const Result<Eigencomponents>& SchemeReading::components(int n) {
  const auto found = components_.find(n);
  if (found != components_.end()) return found->second;
  const Result<FrequencyBlocks> blocks = frequencies_.blocks(n);
  return components_
      .emplace(n, blocks ? Result<Eigencomponents>(approx_eigencomponents(*blocks))
                         : Result<Eigencomponents>(blocks.error()))
      .first->second;
}

const Result<certify::Certificate>& SchemeReading::certificate() {
  if (certificate_) return *certificate_;
  certify::CertifyOptions options = proofs_;
  options.leave_out = true;
  certificate_ = certify::certify(scheme_, valences_, options);
  return *certificate_;
}

}  // namespace limn::search
