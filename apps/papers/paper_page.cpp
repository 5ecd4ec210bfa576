#include "papers/paper_page.h"

#include <filesystem>

#include <fmt/core.h>

#include "limn/base/files/file.h"

namespace limn {
namespace {

const char* const kStyle = R"css(
body { font: 16px/1.5 "DejaVu Sans", Verdana, sans-serif; color: #222; background: #fff;
       max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; line-height: 1.25; } h2 { font-size: 1.2rem; margin-top: 2.5rem; }
.cite { color: #555; }
figure { margin: 2.5rem 0; border-top: 1px solid #ccc; padding-top: 1rem; }
figure img { width: 100%; height: auto; }
figcaption { font-size: .92rem; }
table { border-collapse: collapse; font-size: .88rem; margin: .8rem 0; width: 100%; }
th, td { text-align: left; vertical-align: top; padding: .3rem .6rem; border-bottom: 1px solid #ddd; }
td.code, code { font-family: "DejaVu Sans Mono", monospace; font-size: .82rem; }
a { color: #15558f; }
)css";

std::string number_links(const std::string& stem) {
  return fmt::format("<a href=\"{0}.csv\">CSV</a>, <a href=\"{0}.json\">JSON</a>", stem);
}

}  // namespace

std::string_view to_string(Judgement judgement) {
  switch (judgement) {
    case Judgement::confirmed: return "confirmed";
    case Judgement::supported: return "supported";
    case Judgement::refined: return "refined";
    case Judgement::contradicted: return "contradicted";
    case Judgement::depends: return "depends on the measure";
    case Judgement::undecided: break;
  }
  return "undecided";
}

std::string html_escaped(const std::string& text) {
  std::string result;
  for (const char c : text) switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      default: result += c;
    }
  return result;
}

PaperPage::PaperPage(std::string directory, std::string title, std::string citation,
                     PaperProgress progress)
    : directory_(std::move(directory)),
      title_(std::move(title)),
      citation_(std::move(citation)),
      progress_(std::move(progress)) {
  (void)base::make_folder(directory_);  // the first write says what is wrong
}

std::string PaperPage::path(const std::string& name) const {
  return (std::filesystem::path(directory_) / name).string();
}

void PaperPage::add_heading(const std::string& heading) {
  body_ += fmt::format("<h2>{}</h2>\n", html_escaped(heading));
}

void PaperPage::add_paragraph(const std::string& text) {
  body_ += fmt::format("<p>{}</p>\n", html_escaped(text));
}

Result<std::string> PaperPage::write_numbers(const std::string& stem,
                                             const report::DescribedTable& numbers) {
  const std::string csv = report::csv_text(numbers);
  const auto [known, fresh] = stems_.try_emplace(csv, stem);
  if (!fresh) return known->second;
  if (Status status = base::write_file(path(stem + ".csv"), csv); !status) return status.error();
  if (Status status = base::write_file(path(stem + ".json"), report::json_text(numbers)); !status)
    return status.error();
  return stem;
}

Status PaperPage::add_figure(const PaperItem& item, const figure::Figure& figure,
                             const report::DescribedTable& numbers, const std::string& printed,
                             const std::string& found) {
  if (progress_) progress_(item.label);
  const figure::Canvas canvas = figure.canvas();
  for (const char* extension : {".pdf", ".svg"})
    if (Status status = canvas.write(path(item.stem + extension)); !status) return status;
  const Result<std::string> data = write_numbers(item.stem, numbers);
  if (!data) return data.error();
  body_ += fmt::format(
      "<figure id=\"{0}\">\n<img src=\"{0}.svg\" alt=\"{1}\">\n<figcaption><b>{1}.</b> "
      "<b>Printed:</b> {2} <b>limn:</b> {3}<br><a href=\"{0}.pdf\">PDF</a> · <a "
      "href=\"{0}.svg\">SVG</a> · numbers: {4}</figcaption>\n</figure>\n",
      item.stem, html_escaped(item.label), html_escaped(printed), html_escaped(found),
      number_links(*data));
  return Done{};
}

void PaperPage::append_rows(const std::vector<std::vector<std::string>>& rows) {
  body_ += "<table>\n";
  for (std::size_t r = 0; r < rows.size(); ++r) {
    body_ += "<tr>";
    for (const std::string& cell : rows[r])
      body_ += r == 0 ? "<th>" + html_escaped(cell) + "</th>"
                      : "<td class=\"code\">" + html_escaped(cell) + "</td>";
    body_ += "</tr>\n";
  }
  body_ += "</table>\n";
}

Status PaperPage::add_table(const PaperItem& item,
                            const std::vector<std::vector<std::string>>& rows,
                            const report::DescribedTable& numbers, const std::string& found) {
  if (progress_) progress_(item.label);
  const Result<std::string> data = write_numbers(item.stem, numbers);
  if (!data) return data.error();
  body_ += fmt::format("<figure id=\"{}\">\n<figcaption><b>{}.</b> {}</figcaption>\n", item.stem,
                       html_escaped(item.label), html_escaped(found));
  append_rows(rows);
  body_ += fmt::format("<p>numbers: {}</p>\n</figure>\n", number_links(*data));
  return Done{};
}

Status PaperPage::add_findings(const PaperItem& item, const std::vector<PaperFinding>& findings) {
  const bool judged = !findings.empty() && findings.front().judgement.has_value();
  report::DescribedTable table{{{"place", "where in the paper"}, {"paper", "what it says"}}, {}};
  if (judged) table.columns.push_back({"verdict", "what the evidence shows of it"});
  table.columns.push_back({"limn", "what limn finds"});
  add_heading(item.label);
  body_ += fmt::format("<table id=\"{}\">\n<tr>", item.stem);
  for (const report::DescribedColumn& column : table.columns)
    body_ += fmt::format("<th>{}</th>", html_escaped(column.name));
  body_ += "</tr>\n";
  for (const auto& [place, printed, found, judgement] : findings) {
    std::vector<report::Cell>& row =
        table.rows.emplace_back(std::vector<report::Cell>{place, printed});
    if (judged) row.emplace_back(std::string(judgement ? to_string(*judgement) : ""));
    row.emplace_back(found);
    body_ += "<tr>";
    for (const report::Cell& cell : row)
      body_ += fmt::format("<td>{}</td>", html_escaped(std::get<std::string>(cell)));
    body_ += "</tr>\n";
  }
  const Result<std::string> data = write_numbers(item.stem, table);
  if (!data) return data.error();
  body_ += fmt::format("</table>\n<p>as files: {}</p>\n", number_links(*data));
  return Done{};
}

Status PaperPage::add_file(const std::string& name, const std::string& content,
                           const std::string& what) {
  if (progress_) progress_(name);
  if (Status status = base::write_file(path(name), content); !status) return status;
  body_ +=
      fmt::format("<p><a href=\"{0}\">{0}</a>: {1}</p>\n", html_escaped(name), html_escaped(what));
  return Done{};
}

std::string runs_text(const std::vector<int>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const int first = numbers[i];
    while (i + 1 < numbers.size() && numbers[i + 1] == numbers[i] + 1) ++i;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", first);
    if (numbers[i] > first) text += fmt::format(" … {}", numbers[i]);
  }
  return text.empty() ? "none" : text;
}

std::string c1_answers_text(const std::vector<certify::Answer>& answers, int first) {
  std::vector<int> proved;
  std::vector<int> refuted;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const int n = first + static_cast<int>(i);
    if (answers[i] == certify::Answer::proved) proved.push_back(n);
    if (answers[i] == certify::Answer::refuted) refuted.push_back(n);
  }
  std::string text = runs_text(proved);
  if (!refuted.empty()) text += "; refuted " + runs_text(refuted);
  return text;
}

std::string html_page(const std::string& title, const std::string& body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
      "name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{0}</title>\n"
      "<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n{2}</body>\n</html>\n",
      html_escaped(title), kStyle, body);
}

Status PaperPage::write_index() const {
  return base::write_file(path("index.html"),
                          html_page(title_, fmt::format("<p class=\"cite\">{}</p>\n{}",
                                                        html_escaped(citation_), body_)));
}

}  // namespace limn
