#include "limn/report/page/page_html.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "limn/base/printable.h"

namespace limn::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kPlace = R"(<script type="application/json" id="record">)";

constexpr std::string_view kHead = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'">
<style>
:root { color-scheme: light dark; }
body { font: 1rem/1.5 system-ui, sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-weight: 600; } h2 { margin-top: 2.5rem; font-size: 1.1rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { text-align: left; padding: .2rem 1rem .2rem 0; border-bottom: 1px solid #8885; }
th { font-weight: 600; } pre { overflow-x: auto; padding: 1rem; background: #8881; }
</style>
)";

/// JSON in a script element: no "<" in it can end that.
std::string script_text(const Json& record) {
  std::string text;
  for (const char c : record.dump(-1, ' ', false, Json::error_handler_t::replace))
    text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

/// Text of a page.
std::string html_text(std::string_view text) {
  std::string html;
  for (const char c : base::printable_lines(text)) {
    if (c == '<')
      html += "&lt;";
    else if (c == '&')
      html += "&amp;";
    else
      html += c;
  }
  return html;
}

/// What stands in a cell: numbers to six decimals; nothing as a dash.
std::string cell(const Json& value) {
  if (value.is_null()) return "–";
  if (value.is_string()) return html_text(value.get<std::string>());
  if (value.is_number_float()) return fmt::format("{:.6f}", value.get<double>());
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  return html_text(value.dump(-1, ' ', false, Json::error_handler_t::replace));
}

/// What `json` has at a path of keys; null where it has not.
Json at(const Json& json, std::string_view path) {
  const Json::json_pointer pointer{std::string(path)};
  return json.contains(pointer) ? json.at(pointer) : Json();
}

/// A table with a row for each entry, and a column for each title, path of keys.
using Columns = std::vector<std::pair<std::string_view, std::string_view>>;
std::string table(const Json& entries, const Columns& columns) {
  std::string html = "<div class=\"wide\"><table>\n<tr>";
  for (const auto& [title, path] : columns) html += fmt::format("<th>{}</th>", title);
  html += "</tr>\n";
  for (const Json& entry : entries) {
    html += "<tr>";
    for (const auto& [title, path] : columns)
      html += fmt::format("<td>{}</td>", cell(path.empty() ? entry : at(entry, path)));
    html += "</tr>\n";
  }
  return html + "</table></div>\n";
}

std::string paragraph(const Json& text) {
  if (!text.is_string() || text.get<std::string>().empty()) return {};
  return fmt::format("<p>{}</p>\n", html_text(text.get<std::string>()));
}

std::string eigen_section(const Json& record) {
  return "<h2>Extraordinary vertices</h2>\n" +
         table(at(record, "/record/valences"),
               {{"valence", "/valence"},
                {"tangent", "/components/tangent"},
                {"cup", "/components/cup"},
                {"saddle", "/components/saddle"},
                {"convergent", "/verdict/convergent"},
                {"C1: necessary", "/verdict/c1_necessary"},
                {"curvature bounded", "/verdict/bounded_curvature"}});
}

std::string regularity_section(const Json& record) {
  Json rows = Json::array();
  const Json regularity = at(record, "/record/regularity");
  if (regularity.is_object()) rows.push_back(regularity);
  return "<h2>The regular lattice</h2>\n" + table(rows, {{"Hölder exponent, from", "/holder/lower"},
                                                         {"to", "/holder/upper"},
                                                         {"exactly", "/holder/exact"},
                                                         {"C1", "/c1"},
                                                         {"C2", "/c2"}});
}

std::string certificate_section(const Json& record) {
  std::string html = "<h2>Proofs in ball arithmetic</h2>\n";
  const Json valences = at(record, "/certificate/valences");
  if (!valences.is_array()) return html + paragraph(at(record, "/certificate_reason"));
  return html + table(valences, {{"valence", "/valence"},
                                 {"C1", "/c1"},
                                 {"curvature", "/curvature"},
                                 {"reason", "/reason"}});
}

std::string formula_section(const Json& record) {
  std::string html = "<h2>Eigenvalues in closed form</h2>\n";
  const Json sets = at(record, "/formulas/eigen/formulas");
  if (!sets.is_array()) return html + paragraph(at(record, "/formulas/reason"));
  for (const Json& set : sets) {
    html += fmt::format("<h3>{}, frequency {}</h3>\n", cell(at(set, "/valences")),
                        cell(at(set, "/frequency")));
    html += table(at(set, "/eigenvalues"),
                  {{"ring", "/ring"}, {"eigenvalue", "/text"}, {"times", "/multiplicity"}});
  }
  return html;
}

std::string text_section(const Json& record) {
  std::string html = "<h2>Scheme file</h2>\n";
  for (const Json& text : at(record, "/scheme/texts"))
    html += fmt::format("<h3>{}</h3>\n<pre>{}</pre>\n", cell(at(text, "/name")),
                        cell(at(text, "/text")));
  return html;
}

}  // namespace

Result<std::string> page_with_record(std::string_view page, const nlohmann::ordered_json& record) {
  const std::string place = std::string(kPlace) + "null</script>";
  const std::size_t at = page.find(place);
  if (at == std::string_view::npos || page.find(place, at + 1) != std::string_view::npos)
    return Error{"the page that limn was built with has no place for a record", "build limn anew"};
  std::string html(page.substr(0, at + kPlace.size()));
  html += script_text(record);
  html += page.substr(at + place.size() - std::string_view("</script>").size());
  return html;
}

std::string static_page(const nlohmann::ordered_json& record) {
  const std::string name = cell(at(record, "/scheme/label"));
  std::string html(kHead);
  html += fmt::format("<title>{} – limn</title>\n</head>\n<body>\n<h1>{}</h1>\n", name, name);
  html += paragraph(at(record, "/show/title")) + paragraph(at(record, "/show/source"));
  html += paragraph(at(record, "/show/notes"));
  html += eigen_section(record) + regularity_section(record) + certificate_section(record) +
          formula_section(record);
  Json facts = at(record, "/facts");
  if (!facts.empty())
    html += "<h2>What the literature states</h2>\n" +
            table(facts, {{"valences", "/valences"}, {"values", "/values"}, {"source", "/source"}});
  html += text_section(record);
  return html + std::string(kPlace) + script_text(record) + "</script>\n</body>\n</html>\n";
}

}  // namespace limn::report
