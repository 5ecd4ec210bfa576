#pragma once
/// A folder that holds a paper's figures and tables made anew, with one index page that says for
/// each what the paper prints and what limn finds.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "limn/certify/certificate/certificate.h"
#include "limn/figure/figure.h"
#include "limn/report/data_table.h"

namespace limn {

/// Called before each file is made, with its name.
using PaperProgress = std::function<void(const std::string& what)>;

/// "Figure 7": a figure's place in the paper, and its files' name without extension.
struct PaperItem {
  std::string label;
  std::string stem;
};

/// What the evidence beside a claim shows.
enum class Judgement {
  confirmed,     ///< it holds, by what is shown
  supported,     ///< it holds wherever it was computed; it says more than that
  refined,       ///< it holds in part, or in another form, which is given
  contradicted,  ///< a case is shown in which it does not hold
  depends,       ///< the measures that it leaves open disagree
  undecided
};
[[nodiscard]] std::string_view to_string(Judgement judgement);

/// A line of a list of claims or misprints.
struct PaperFinding {
  std::string place;                        ///< where in the paper
  std::string printed;                      ///< what it says
  std::string found;                        ///< what limn finds
  std::optional<Judgement> judgement = {};  ///< of a claim; computed from the numbers in `found`
};

class PaperPage {
 public:
  /// `directory` is made if it does not exist, its parents too; a failure shows at the first write.
  PaperPage(std::string directory, std::string title, std::string citation, PaperProgress progress);

  void add_heading(const std::string& heading);
  void add_paragraph(const std::string& text);

  /// Writes the figure as .pdf and .svg and its numbers as .csv and .json, and puts it on the page.
  /// Numbers that the folder holds already are not written twice: the page leads to the first.
  [[nodiscard]] Status add_figure(const PaperItem& item, const figure::Figure& figure,
                                  const report::DescribedTable& numbers, const std::string& printed,
                                  const std::string& found);

  /// A table of text, its first row the header; and its numbers as .csv and .json.
  [[nodiscard]] Status add_table(const PaperItem& item,
                                 const std::vector<std::vector<std::string>>& rows,
                                 const report::DescribedTable& numbers, const std::string& found);

  /// A table of claims or misprints under a heading, and as .csv and .json.
  [[nodiscard]] Status add_findings(const PaperItem& item,
                                    const std::vector<PaperFinding>& findings);

  /// Any further file, linked from the page.
  [[nodiscard]] Status add_file(const std::string& name, const std::string& content,
                                const std::string& what);

  /// The index page, last, so that it never names what is not there.
  [[nodiscard]] Status write_index() const;

 private:
  [[nodiscard]] std::string path(const std::string& name) const;
  /// Gives the stem of the files that hold the numbers.
  [[nodiscard]] Result<std::string> write_numbers(const std::string& stem,
                                                  const report::DescribedTable& numbers);
  void append_rows(const std::vector<std::vector<std::string>>& rows);

  std::string directory_, title_, citation_, body_;
  std::map<std::string, std::string> stems_;  ///< of the tables that are written, by their text
  PaperProgress progress_;
};

/// Rising numbers, those that follow each other drawn together: "3, 8 … 20"; "none".
[[nodiscard]] std::string runs_text(const std::vector<int>& numbers);

/// Where C1 is proved, and refuted, at the valences from `first` on: "3 … 7; refuted 8 … 12";
/// "none".
[[nodiscard]] std::string c1_answers_text(const std::vector<certify::Answer>& answers, int first);

/// A whole page in the style of them all; `title` is text, `body` HTML.
[[nodiscard]] std::string html_page(const std::string& title, const std::string& body);

/// For text between tags and in attributes.
[[nodiscard]] std::string html_escaped(const std::string& text);

}  // namespace limn
