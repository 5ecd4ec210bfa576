#pragma once
/// Certificates as JSON: what `limn certify -o FILE` writes and `limn certify --check FILE` reads.

#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "limn/base/error.h"
#include "limn/certify/certificate/certificate.h"

namespace limn::certify {

/// All of it.
[[nodiscard]] nlohmann::ordered_json certificate_json(const Certificate& certificate);

/// What the answers are, without what shows them: {"scheme", "regular": {"c1", …}, "valences":
/// [{"valence", "c1", "curvature", "bits", "reason"}]}.
[[nodiscard]] nlohmann::ordered_json answers_json(const Certificate& certificate);

/// Inverse of certificate_json, of text from anywhere. Fails, with the place in it, on what is no
/// certificate: other keys are an error too, so that nothing in it goes unread.
[[nodiscard]] Result<Certificate> parse_certificate(std::string_view text);

}  // namespace limn::certify
