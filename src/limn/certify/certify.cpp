#include "limn/certify/certify.h"

#include <algorithm>

#include <fmt/core.h>

#include "limn/certify/ring/regular_rows.h"
#include "limn/certify/vertex/valence_proof.h"
#include "limn/regular/smoothness/regularity.h"
#include "limn/scheme/file/scheme_files.h"

namespace limn::certify {
namespace {

constexpr std::array<double, 4> kLeafNorms{0.1, 0.25, 0.5, 0.75};
constexpr int kLargestClaim = 1'000'000;  // products that a check is ready to make
constexpr int kLargestValence = 2000;
constexpr int kLeastBits = 32;
constexpr int kMostBits = 8192;
constexpr int kFirstValence = 3;
constexpr int kMostStarts = 4;     // of a proof for all valences
constexpr int kLatestStart = 200;  // valences below are proved one by one

/// The smaller the leaves' norms are, the better the bounds and the larger the tree; `first` of the
/// norms is tried first.
Result<Contraction> search_tree(const CellMatrices& cells, const CertifyOptions& options,
                                std::size_t first) {
  Error last;
  for (std::size_t i = first; i < kLeafNorms.size(); ++i) {
    Result<Contraction> found =
        enclose_contraction(cells, kLeafNorms[i], options.most_products, options.time.stop());
    if (found) return found;
    last = found.error();
  }
  return last;
}

Result<RegularProof> search_regular(const Scheme& scheme, const Mask& mask,
                                    const CertifyOptions& options) {
  Result<CellMatrices> cells = cell_matrices(mask);
  if (!cells) return cells.error();
  if (Status same = check_regular_rows(scheme, *cells); !same) return same.error();
  const Result<CellMatrices> wide = cell_matrices(mask, CellExtent::neighbours);
  if (!wide) return wide.error();
  Result<Contraction> continuity = search_tree(*wide, options, kLeafNorms.size() - 1);
  if (!continuity) return continuity.error();
  // all valences need the best bounds, for single ones they cost more than they spare
  Result<Contraction> contraction = search_tree(*cells, options, options.all ? 0 : 1);
  if (!contraction) return contraction.error();
  return RegularProof{std::move(*cells), std::move(*contraction), std::move(*continuity),
                      find_regular_part(mask)};
}

TreeClaim claim_of(const Contraction& found) {
  return {found.leaf_norm, found.products, found.longest};
}

RegularClaim claim_of(const RegularProof& proof) {
  return {Answer::proved,
          fmt::format("sum rules of order 2, and {} products of cell matrices of up to {} "
                      "refinements by {} contract",
                      proof.continuity.products, proof.continuity.longest, proof.cells.scale),
          claim_of(proof.continuity), claim_of(proof.contraction)};
}

/// The tree that is claimed, grown again.
Result<Contraction> check_tree(const CellMatrices& cells, const TreeClaim& claim) {
  if (std::find(kLeafNorms.begin(), kLeafNorms.end(), claim.leaf_norm) == kLeafNorms.end() ||
      claim.products > kLargestClaim)
    return Error{"the regular lattice: a norm of leaves that is not known, or too many products"};
  Result<Contraction> found = enclose_contraction(cells, claim.leaf_norm, claim.products);
  if (found && (found->products != claim.products || found->longest != claim.longest))
    return Error{"the regular lattice: products are not as claimed"};
  return found;
}

Result<RegularProof> check_regular(const Scheme& scheme, const Mask& mask,
                                   const RegularClaim& claim) {
  Result<CellMatrices> cells = cell_matrices(mask);
  if (!cells) return cells.error();
  if (Status same = check_regular_rows(scheme, *cells); !same) return same.error();
  const Result<CellMatrices> wide = cell_matrices(mask, CellExtent::neighbours);
  if (!wide) return wide.error();
  Result<Contraction> continuity = check_tree(*wide, claim.neighbours);
  if (!continuity) return continuity.error();
  Result<Contraction> contraction = check_tree(*cells, claim.cells);
  if (!contraction) return contraction.error();
  return RegularProof{std::move(*cells), std::move(*contraction), std::move(*continuity),
                      find_regular_part(mask)};
}

ValenceClaim undecided(int n, const std::string& reason) {
  ValenceClaim claim;
  claim.valence = n;
  claim.reason = reason;
  claim.curvature.reason = "C1 is undecided";
  return claim;
}

/// What the options know of a valence's C1, if they do.
const ValenceClaim* known_claim(const CertifyOptions& options, int n) {
  const auto known = std::find_if(options.known.begin(), options.known.end(),
                                  [n](const ValenceClaim& claim) { return claim.valence == n; });
  if (known == options.known.end() || known->c1 == Answer::undecided) return nullptr;
  return &*known;
}

/// Whether nothing is left to be looked for.
bool is_whole(const ValenceClaim& claim, const CertifyOptions& options) {
  return claim.c1 != Answer::proved || !options.curvature ||
         claim.curvature.answer != CurvatureAnswer::undecided;
}

Result<ValenceClaim> certify_valence(const Scheme& scheme, const RegularProof& regular,
                                     const CellSigns& signs, int n, const CertifyOptions& options) {
  const ValenceClaim* const known = known_claim(options, n);
  if (known != nullptr && (is_whole(*known, options) || options.time.ended())) return *known;
  if (options.time.ended()) return undecided(n, "the time ended before it was looked at");
  if (options.progress) options.progress(fmt::format("valence {}", n));
  ProofLimits limits{options.bits, options.most_parts, options.curvature, options.time.stop()};
  Result<SearchedValence> found = search_valence(scheme, regular, signs, n, limits);
  if (found && found->more_bits_may_help && !options.time.ended()) {
    limits.bits *= 2;
    Result<SearchedValence> again = search_valence(scheme, regular, signs, n, limits);
    if (again && again->claim.c1 != Answer::undecided) return std::move(again->claim);
  }
  if (!found) return found.error();
  if (known != nullptr && found->claim.c1 == Answer::undecided) return *known;
  return std::move(found->claim);
}

/// What is proved of all valences at once, beginning later where valences are left out.
AllValences search_together(const Scheme& scheme, const RegularProof& regular,
                            const CertifyOptions& options) {
  AllValences found;
  const Result<int> first = first_of_all_valences(scheme);
  if (!first) {
    found.reason = first.error().message;
    return found;
  }
  int from = *first;
  for (int round = 0; round < kMostStarts; ++round) {
    if (options.progress) options.progress(fmt::format("all valences from {} on", from));
    found =
        certify_all_valences(scheme, regular.cells, regular.contraction, from, options.time.stop());
    if (found.c1 == Truth::yes || found.uncovered.empty()) return found;
    long long last = 0;
    for (const UncoveredValences& some : found.uncovered) {
      if (some.last == 0) return found;
      last = std::max(last, some.last);
    }
    if (last >= kLatestStart) return found;
    from = static_cast<int>(last) + 1;
  }
  return found;
}

/// The claim's exceptions are what single valences below the common proof are.
std::vector<AllClaim::Exception> exceptions_of(const Certificate& certificate, int first, int end) {
  std::vector<AllClaim::Exception> result;
  for (const ValenceClaim& claim : certificate.valences)
    if (claim.valence >= first && claim.valence < end && claim.c1 != Answer::proved)
      result.push_back({claim.valence, claim.c1});
  return result;
}

AllClaim claim_of(AllValences proof) {
  AllClaim claim;
  claim.from = kFirstValence;
  if (proof.c1 == Truth::yes) {
    claim.c1 = Answer::proved;
    claim.reason =
        fmt::format("the valences from {} on together, those below one by one", proof.from);
    claim.proof = std::move(proof);
  } else {
    claim.reason = proof.reason;
  }
  return claim;
}

/// Fails where the claim on all valences is not shown by the proof and the single valences.
Status check_all(const Scheme& scheme, const RegularProof& regular,
                 const Certificate& certificate) {
  const AllClaim& claim = *certificate.all;
  if (claim.c1 == Answer::undecided) {
    if (claim.from == kFirstValence && claim.exceptions.empty()) return Done{};
    return Error{"all valences: something is said of a claim that is undecided"};
  }
  if (claim.c1 != Answer::proved || claim.from != kFirstValence || claim.proof.from > kLatestStart)
    return Error{"all valences: no such claim is known"};
  for (int n = claim.from; n < claim.proof.from; ++n)
    if (std::none_of(certificate.valences.begin(), certificate.valences.end(),
                     [n](const ValenceClaim& one) { return one.valence == n; }))
      return Error{fmt::format("all valences: nothing is said of {}", n)};
  const auto expected = exceptions_of(certificate, claim.from, claim.proof.from);
  if (!std::equal(
          expected.begin(), expected.end(), claim.exceptions.begin(), claim.exceptions.end(),
          [](const auto& a, const auto& b) { return a.valence == b.valence && a.c1 == b.c1; }))
    return Error{"all valences: the exceptions are not those of the single valences"};
  return check_all_valences(scheme, regular.cells, regular.contraction, claim.proof);
}

Result<Scheme> scheme_of(const Certificate& certificate) {
  Result<Scheme> scheme = parse_texts(certificate.texts);
  if (!scheme) return scheme;
  if (Status set = set_parameters(*scheme, certificate.parameters); !set) return set.error();
  if (scheme->name != certificate.scheme)
    return Error{fmt::format("it is called a certificate of '{}', and its text is that of '{}'",
                             certificate.scheme, scheme->name)};
  return scheme;
}

Error without_arb() {
  return {"limn was built without Arb, in whose ball arithmetic proofs are made",
          "build it where Arb and FLINT are installed (libflint-arb-dev, libflint-dev)"};
}

Error at_valence(int n, const Error& error) {
  return Error{fmt::format("valence {}: {}", n, error.message)};
}

}  // namespace

std::string_view to_string(Answer answer) {
  switch (answer) {
    case Answer::proved: return "proved";
    case Answer::refuted: return "refuted";
    case Answer::undecided: break;
  }
  return "undecided";
}

std::string_view to_string(CurvatureAnswer answer) {
  switch (answer) {
    case CurvatureAnswer::bounded: return "bounded";
    case CurvatureAnswer::unbounded: return "unbounded";
    case CurvatureAnswer::flat: return "flat";
    case CurvatureAnswer::undecided: break;
  }
  return "undecided";
}

std::vector<std::string> set_parameters_of(const Scheme& scheme) {
  std::vector<std::string> result;
  for (const Parameter& parameter : scheme.parameters)
    if (parameter.value.place.line == 0)
      result.push_back(parameter.name + "=" + parameter.value.expression.text());
  return result;
}

Result<Certificate> certify(const Scheme& scheme, const std::vector<int>& valences,
                            const CertifyOptions& options) {
  if (!number::Ball::is_available()) return without_arb();
  if (scheme.texts.empty())
    return Error{"the scheme was not read from a text, which it is to hold"};
  Certificate certificate;
  certificate.scheme = scheme.name;
  certificate.texts = scheme.texts;
  certificate.parameters = set_parameters_of(scheme);
  if (options.progress) options.progress("the regular lattice");
  const Result<Mask> mask = regular_mask(scheme);
  if (!mask) return mask.error();
  const Result<RegularProof> regular = search_regular(scheme, *mask, options);
  if (!regular) {
    certificate.regular.reason = regular.error().message;
    for (const int n : valences)
      certificate.valences.push_back(
          undecided(n, "C1 on the regular lattice is undecided: " + regular.error().message));
    if (options.all) {
      certificate.all = AllClaim{};
      certificate.all->reason = "C1 on the regular lattice is undecided";
    }
    return certificate;
  }
  certificate.regular = claim_of(*regular);
  const CellSigns signs(regular->cells, regular->contraction);
  std::vector<int> wanted = valences;
  if (options.all) {
    certificate.all = claim_of(search_together(scheme, *regular, options));
    for (int n = kFirstValence; n < certificate.all->proof.from; ++n) wanted.push_back(n);
    std::sort(wanted.begin(), wanted.end());
    wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  }
  for (const int n : wanted) {
    Result<ValenceClaim> claim = certify_valence(scheme, *regular, signs, n, options);
    if (!claim && !options.leave_out) return claim.error();
    certificate.valences.push_back(claim ? std::move(*claim) : undecided(n, claim.error().message));
  }
  if (certificate.all && certificate.all->c1 == Answer::proved)
    certificate.all->exceptions =
        exceptions_of(certificate, kFirstValence, certificate.all->proof.from);
  return certificate;
}

Status check_certificate(const Certificate& certificate,
                         const std::function<void(const std::string&)>& progress) {
  if (!number::Ball::is_available()) return without_arb();
  const Result<Scheme> scheme = scheme_of(certificate);
  if (!scheme) return scheme.error();
  const bool claims = std::any_of(certificate.valences.begin(), certificate.valences.end(),
                                  [](const ValenceClaim& c) { return c.c1 != Answer::undecided; });
  const RegularClaim& claimed = certificate.regular;
  if (claimed.c1 == Answer::undecided) {
    if (claims || (certificate.all && certificate.all->c1 != Answer::undecided))
      return Error{"C1 on the regular lattice is not shown, on which the claims rest"};
    return Done{};
  }
  if (claimed.c1 != Answer::proved) return Error{"the regular lattice: no such claim is known"};
  const Result<Mask> mask = regular_mask(*scheme);
  if (!mask) return mask.error();
  const Result<RegularProof> shown_regular = check_regular(*scheme, *mask, claimed);
  if (!shown_regular) return shown_regular.error();
  const RegularProof& regular = *shown_regular;
  const CellSigns signs(regular.cells, regular.contraction);
  int last = 0;
  for (const ValenceClaim& claim : certificate.valences) {
    if (claim.valence <= last) return at_valence(claim.valence, Error{"it is not in order"});
    last = claim.valence;
    if (claim.valence > kLargestValence)
      return at_valence(claim.valence, Error{"it is beyond those that are looked at"});
    if (claim.c1 != Answer::undecided && (claim.bits < kLeastBits || claim.bits > kMostBits))
      return at_valence(claim.valence, Error{"so few or many bits are of no use"});
    if (progress) progress(fmt::format("valence {}", claim.valence));
    if (Status shown = check_valence(*scheme, regular, signs, claim); !shown)
      return at_valence(claim.valence, shown.error());
  }
  if (!certificate.all) return Done{};
  if (progress) progress("all valences");
  return check_all(*scheme, regular, certificate);
}

}  // namespace limn::certify
