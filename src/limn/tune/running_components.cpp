#include "limn/tune/running_components.h"

namespace limn {
namespace {

bool same(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && a == b;
}

void label(Eigencomponents& found) {
  const std::array<std::optional<double>*, kComponents.size()> values{
      &found.position, &found.cup, &found.tangent, &found.saddle};
  for (std::size_t i = 0; i < values.size(); ++i)
    if (const Component& component = kComponents[i]; component.exists_at(found.valence))
      *values[i] =
          labelled(component, found.spectra[static_cast<std::size_t>(component.frequency)]);
}

}  // namespace

const Eigencomponents& RunningComponents::at(const FrequencyBlocks& blocks) {
  std::vector<std::size_t> changed;
  const bool fresh = known_.size() != blocks.blocks.size() || found_.valence != blocks.valence;
  for (std::size_t i = 0; i < blocks.blocks.size() && !fresh; ++i)
    if (!same(known_[i], blocks.blocks[i])) changed.push_back(i);
  if (fresh || 2 * changed.size() > known_.size()) {
    found_.valence = blocks.valence;
    found_.rings = blocks.rings;
    found_.spectra = approx_spectra(blocks);
    known_ = blocks.blocks;
    solved_ += static_cast<long long>(known_.size());
  } else {
    for (const std::size_t i : changed) {
      found_.spectra[i] = approx_spectrum(blocks, static_cast<int>(i), Near::joined);
      known_[i] = blocks.blocks[i];
    }
    solved_ += static_cast<long long>(changed.size());
  }
  label(found_);
  return found_;
}

}  // namespace limn
