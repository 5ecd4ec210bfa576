#include "papers/kawaharada.h"

#include "papers/kawaharada_parts.h"

namespace limn {
namespace {

constexpr const char* kTitle = "Laplacian subdivision and optimal schemes, made anew";
constexpr const char* kCitation =
    "H. Kawaharada, K. Sugihara: Laplacian Subdivision and Optimal Schemes. Mathematical "
    "Engineering Technical Reports METR 2006-42, University of Tokyo, 2006. All its figures "
    "and the numbers of its claims, computed by limn from the rules in its scheme files.";

}  // namespace

Status write_kawaharada(const std::string& directory, const PaperProgress& progress) {
  if (!figures_available())
    return Error{"this limn draws no figures", "build it with cairo (LIMN_FIGURES)"};
  PaperPage page(directory, kTitle, kCitation, progress);
  ks::Studio studio;
  if (Status status = ks::add_foundations(page, studio); !status) return status;
  if (Status status = ks::add_surfaces(page, studio); !status) return status;
  if (Status status = ks::add_stencils(page, studio.members); !status) return status;
  if (Status status = ks::add_circle(page, studio.members); !status) return status;
  if (Status status = ks::add_differences(page, studio.members); !status) return status;
  if (Status status = ks::add_claims(page, studio); !status) return status;
  return page.write_index();
}

}  // namespace limn
