/// Proofs that surfaces are C1, and their certificates.

#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "call.h"
#include "errors.h"
#include "json_objects.h"
#include "limn/certify/certificate/certificate_json.h"
#include "limn/certify/certify.h"
#include "limn/report/certificate_report.h"
#include "module.h"

namespace limn::python {
namespace {

/// The answers, the certificate as a file has it, and both as text for people.
py::tuple certify_scheme(const Scheme& scheme, const std::vector<int>& valences, int bits, bool all,
                         bool curvature, double seconds) {
  const Result<certify::Certificate> found = without_gil([&] {
    certify::CertifyOptions options;
    options.bits = bits;
    options.all = all;
    options.curvature = curvature;
    options.time = TimeBudget(seconds);
    options.progress = on_progress;
    return certify::certify(scheme, valences, options);
  });
  if (!found) raise(in_file(found.error(), scheme.file), Fault::scheme);
  return py::make_tuple(to_python(certify::answers_json(*found)),
                        to_str(certify::certificate_json(*found).dump(1) + "\n"),
                        to_str(report::certificate_text(*found)),
                        to_str(report::certificate_latex(*found)));
}

/// The answers of a certificate that was verified.
py::object check_certificate(const std::string& text, const std::string& file) {
  const Result<certify::Certificate> found = without_gil([&]() -> Result<certify::Certificate> {
    Result<certify::Certificate> read = certify::parse_certificate(text);
    if (!read) return read;
    if (Status shown = certify::check_certificate(*read, on_progress); !shown) {
      Error error = shown.error();
      error.message = "refused: " + error.message;
      return error;
    }
    return read;
  });
  if (!found) raise(in_file(found.error(), file), Fault::other);
  return to_python(certify::answers_json(*found));
}

}  // namespace

void bind_proofs(py::module_& module) {
  module.def("certify", &certify_scheme, py::arg("scheme"), py::arg("valences"), py::arg("bits"),
             py::arg("all"), py::arg("curvature"), py::arg("seconds"));
  module.def("check_certificate", &check_certificate, py::arg("text"), py::arg("file"));
}

}  // namespace limn::python
