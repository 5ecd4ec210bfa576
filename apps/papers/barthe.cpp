#include "papers/barthe.h"

#include "papers/barthe_parts.h"

namespace limn {
namespace {

constexpr const char* kTitle =
    "Simple computation of the eigencomponents of a subdivision matrix in the Fourier domain";
constexpr const char* kCitation =
    "L. Barthe, C. Gérot, M. Sabin, L. Kobbelt. In: N. Dodgson, M. Floater, M. Sabin (eds.): "
    "Advances "
    "in Multiresolution for Geometric Modelling, 2005";

}  // namespace

Status write_barthe(const std::string& directory, const PaperProgress& progress) {
  if (!figure::figures_available())
    return Error{"this limn draws no figures", "build it with cairo (LIMN_FIGURES)"};
  PaperPage page(directory, kTitle, kCitation, progress);
  for (const auto& add :
       {bgsk::add_variants, bgsk::add_labels, bgsk::add_sqrt3, bgsk::add_schemes, bgsk::add_words})
    if (Status status = add(page); !status) return status;
  return page.write_index();
}

}  // namespace limn
