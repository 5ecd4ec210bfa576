#include "papers/kawaharada.h"

#include "papers/kawaharada_parts.h"

namespace limn {
namespace {

constexpr const char* kTitle = "Laplacian subdivision and optimal schemes, made anew";
constexpr const char* kCitation =
    "H. Kawaharada, K. Sugihara: Laplacian Subdivision and Optimal Schemes. Mathematical "
    "Engineering Technical Reports METR 2006-42, University of Tokyo, 2006. All its figures "
    "and the numbers of its claims, computed by limn from the rules in its scheme files. The paper "
    "gives no "
    "coordinates of its control meshes: the torus, the cube and the raised vertex here, their "
    "sizes and the "
    "directions from which they are seen are limn's choice, not the paper's.";

}  // namespace

Status write_kawaharada(const std::string& directory, const PaperProgress& progress) {
  if (!figure::figures_available())
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
