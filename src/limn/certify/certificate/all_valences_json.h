#pragma once
/// The part of a certificate that speaks of all valences, as JSON. Private to certificate_json.

#include "limn/certify/certificate/certificate.h"
#include "limn/certify/certificate/json_reader.h"

namespace limn::certify {

/// {"from", "c1", "exceptions": [{"valence", "c1"}], "reason"}
[[nodiscard]] Json all_answer_json(const AllClaim& claim);
/// The same, and what shows it.
[[nodiscard]] Json all_valences_json(const AllClaim& claim);
/// Inverse; `fault` is set where it is something else.
[[nodiscard]] AllClaim read_all_valences(const Json& json, const std::string& place,
                                         std::optional<Error>& fault);

}  // namespace limn::certify
