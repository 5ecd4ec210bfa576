#include <algorithm>
#include <memory>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "limn/base/files/file.h"
#include "limn/base/progress.h"
#include "limn/certify/certificate/certificate_json.h"
#include "limn/certify/certify.h"
#include "limn/report/certificate_report.h"
#include "options/number_option.h"
#include "options/time_option.h"
#include "options/valences.h"

namespace limn::app {
namespace {

constexpr int kLeastValence = 3;
constexpr int kMostBits = 4096;
constexpr double kSecondsToCertify = 600;
constexpr std::uint64_t kMostBytes = 1ULL << 30;  // of a certificate that is read

struct CertifyCommand {
  SchemeOptions scheme;
  std::string valence = "3..12";
  bool valence_given = false;
  int bits = 128;
  double seconds = kSecondsToCertify;
  std::string output, resume, check;
  bool json = false;
  bool latex = false;
  bool all = false;
  bool c1_only = false;
};

Result<certify::Certificate> read_certificate(const std::string& path) {
  const Result<std::string> text = base::read_file(path, {.bytes = kMostBytes, .pipes = true});
  if (!text) return text.error();
  Result<certify::Certificate> certificate = certify::parse_certificate(*text);
  if (!certificate) certificate.error().file = path;
  return certificate;
}

/// Reads a certificate and checks it.
Result<certify::Certificate> checked_certificate(const std::string& path,
                                                 base::ProgressLine& line) {
  Result<certify::Certificate> certificate = read_certificate(path);
  if (!certificate) return certificate;
  Status shown = certify::check_certificate(
      *certificate, [&line](const std::string& what) { line.show("checking " + what); });
  if (shown) return certificate;
  Error error = shown.error();
  error.file = path;
  error.message = "refused: " + error.message;
  return error;
}

int check(const CertifyCommand& command) {
  base::ProgressLine line;
  const Result<certify::Certificate> certificate = checked_certificate(command.check, line);
  if (!certificate) return report(certificate.error());
  const Result<Scheme> shipped = find_scheme(certificate->scheme);
  const auto same_text = [](const SourceText& a, const SourceText& b) { return a.text == b.text; };
  const bool same = shipped.ok() && certificate->parameters.empty() &&
                    std::equal(shipped->texts.begin(), shipped->texts.end(),
                               certificate->texts.begin(), certificate->texts.end(), same_text);
  if (command.json) {
    nlohmann::ordered_json json = certify::answers_json(*certificate);
    json["verified"] = true;
    json["text_is_shipped"] = same;
    print_json(json);
  } else {
    print_text(report::certificate_text(*certificate) +
               fmt::format("\nverified, of the scheme whose text the certificate holds{}\n",
                           same ? ": the shipped one" : ""));
  }
  return kDone;
}

Result<certify::CertifyOptions> options_of(const CertifyCommand& command, const Scheme& scheme,
                                           base::ProgressLine& line) {
  certify::CertifyOptions options;
  options.bits = command.bits;
  options.all = command.all;
  options.curvature = !command.c1_only;
  options.time = TimeBudget(time_limit(command.seconds));
  options.progress = [&line](const std::string& what) { line.show("certifying: " + what); };
  if (command.resume.empty()) return options;
  Result<certify::Certificate> before = checked_certificate(command.resume, line);
  if (!before) return before.error();
  const auto same = [](const SourceText& a, const SourceText& b) { return a.text == b.text; };
  if (!std::equal(before->texts.begin(), before->texts.end(), scheme.texts.begin(),
                  scheme.texts.end(), same) ||
      before->parameters != certify::set_parameters_of(scheme))
    return Error{
        "it is a certificate of another scheme, or of other parameters", {}, command.resume, 0, 0};
  options.known = std::move(before->valences);
  return options;
}

int prove(const CertifyCommand& command) {
  if (command.scheme.name.empty())
    return report(Error{"SCHEME is missing", "or give --check FILE, a certificate"});
  const Result<Valences> range = read_valences(command.valence, kLeastValence);
  if (!range) return report(range.error());
  if (Status outputs = check_outputs({command.output}); !outputs) return report(outputs.error());
  const Result<Scheme> scheme = command.scheme.load();
  if (!scheme) return report(scheme.error());
  base::ProgressLine line;
  const Result<certify::CertifyOptions> options = options_of(command, *scheme, line);
  if (!options) return report(options.error());
  std::vector<int> valences;
  // all valences bring those that are proved one by one
  if (!command.all || command.valence_given)
    for (int n = range->first; n <= range->last; ++n) valences.push_back(n);
  Result<certify::Certificate> certificate = certify::certify(*scheme, valences, *options);
  if (!certificate) {
    if (certificate.error().file.empty()) certificate.error().file = scheme->file;
    return report(certificate.error());
  }
  if (!command.output.empty())
    if (Status written = base::write_file(command.output,
                                          certify::certificate_json(*certificate).dump(1) + "\n");
        !written)
      return report(written.error());
  if (command.json)
    print_json(certify::answers_json(*certificate));
  else
    print_text(command.latex ? report::certificate_latex(*certificate)
                             : report::certificate_text(*certificate));
  const bool undecided = std::any_of(
      certificate->valences.begin(), certificate->valences.end(),
      [](const certify::ValenceClaim& c) { return c.c1 == certify::Answer::undecided; });
  const bool open = certificate->all && certificate->all->c1 == certify::Answer::undecided;
  return undecided || open ? kUndecided : kDone;
}

}  // namespace

void declare_certify(CLI::App& parser, Action& action) {
  CLI::App* command = add_command(
      parser, "certify", "proves or refutes that surfaces are C1 at a vertex, in ball arithmetic");
  const auto chosen = std::make_shared<CertifyCommand>();
  command->add_option("SCHEME", chosen->scheme.name, kSchemeArgumentHelp);
  chosen->scheme.declare_parameters(*command);
  CLI::Option* valence =
      command->add_option("--valence", chosen->valence, "a valence or a range, as 3..50")
          ->capture_default_str();
  command->add_flag("--all", chosen->all, "every valence from 3 on at once");
  command->add_flag(
      "--c1-only", chosen->c1_only,
      "leave curvature undecided, whose proof is most of the work for long fractions");
  command->add_option("-o,--output", chosen->output, "where the certificate is written, as JSON");
  CLI::Option* check_option =
      command->add_option("--check", chosen->check,
                          "a certificate that is verified, without a search; takes no SCHEME");
  command
      ->add_option("--resume", chosen->resume,
                   "a certificate of the same scheme; what it shows, once checked, is taken over")
      ->excludes(check_option);
  command->add_option("--bits", chosen->bits, "precision of the ball arithmetic")
      ->check(CLI::Range(64, kMostBits))
      ->capture_default_str();
  declare_time(*command, chosen->seconds, "how long to look for proofs; the rest is undecided");
  CLI::Option* json = command->add_flag("--json", chosen->json, "print one JSON object");
  command->add_flag("--latex", chosen->latex, "print the proof in LaTeX")->excludes(json);
  command->footer(
      "Example: limn certify loop --valence 3..50 -o loop.json\n"
      "         limn certify --check loop.json\n"
      "         limn certify catmull-clark --all\n"
      "         limn certify laplacian-loop -p a=1/16 --valence 3..20 --json");
  command->callback([&action, chosen, valence] {
    chosen->valence_given = valence->count() > 0;
    action = [chosen] { return chosen->check.empty() ? prove(*chosen) : check(*chosen); };
  });
}

}  // namespace limn::app
