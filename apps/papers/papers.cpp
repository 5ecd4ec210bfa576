#include "papers/papers.h"

#include <filesystem>

#include <fmt/core.h>

#include "limn/base/files/file.h"
#include "papers/augsdorfer.h"
#include "papers/barthe.h"
#include "papers/kawaharada.h"

namespace limn {

const std::vector<Paper>& papers() {
  static const std::vector<Paper> list{
      {"augsdorfer", "U. H. Augsdörfer, N. A. Dodgson, M. A. Sabin",
       "Artifact analysis on triangular box-spline and subdivision meshes", "fig07",
       "figures 1–12, tables 1–3, claims, misprints", write_augsdorfer},
      {"barthe", "L. Barthe, C. Gérot, M. Sabin, L. Kobbelt",
       "Simple computation of the eigencomponents of a subdivision matrix in the Fourier domain",
       "fig01",
       "figures 1 and 2, the √3 example, claims, misprints; eigenvalues of every shipped scheme",
       write_barthe},
      {"kawaharada", "H. Kawaharada, K. Sugihara", "Laplacian Subdivision and Optimal Schemes",
       "fig14", "figures 1–46, claims, misprints", write_kawaharada}};
  return list;
}

Status write_paper_list(const std::string& directory, const std::vector<const Paper*>& written) {
  std::string body =
      "<p>Figures, tables and main claims of these papers, computed by limn from scheme "
      "files. Each page says what the paper prints and what limn finds; figures come "
      "as PDF and SVG, their numbers, claims and misprints as CSV and JSON.</p>\n";
  for (const Paper* paper : written)
    body += fmt::format(
        "<h2><a href=\"{0}/index.html\">{2}</a></h2>\n<p "
        "class=\"cite\">{1}</p>\n<p>{4}</p>\n<figure><a "
        "href=\"{0}/index.html\"><img src=\"{0}/{3}.svg\" alt=\"a figure of it\"></a></figure>\n",
        paper->name, html_escaped(paper->authors), html_escaped(paper->title), paper->picture,
        html_escaped(paper->content));
  return base::write_file((std::filesystem::path(directory) / "index.html").string(),
                          html_page("Three papers on subdivision, made anew", body));
}

}  // namespace limn
