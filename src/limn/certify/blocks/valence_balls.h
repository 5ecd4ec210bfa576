#pragma once
/// The subdivision matrix at one valence in balls, and what claims on its spectrum are proved with:
/// shared by the search and by the check.

#include <vector>

#include "limn/certify/blocks/real_blocks.h"
#include "limn/certify/blocks/spectral_bound.h"
#include "limn/certify/certificate/certificate.h"
#include "limn/certify/ring/eigen_net.h"

namespace limn::certify {

/// The whole block of frequency 0 without the eigenvalue 1, of the constant vector: its row 0 is
/// taken off the others.
[[nodiscard]] number::BallMatrix without_one(const number::BallMatrix& whole,
                                             const RealBasis& basis);

class ValenceBalls {
 public:
  /// At a valence n ≥ 3. Fails where a rule is missing or a weight cannot be enclosed.
  [[nodiscard]] static Result<ValenceBalls> make(const Scheme& scheme, int n);

  [[nodiscard]] int valence() const { return n_; }
  [[nodiscard]] const RealBasis& basis() const { return basis_; }
  [[nodiscard]] Phase<number::Ball> phase(int frequency) const;
  /// The block in its real basis; of frequency 0 without the eigenvalue 1, of the constant vector:
  /// row 0 is taken off the others.
  [[nodiscard]] number::BallMatrix block(int frequency) const;
  /// The eigenvector of the whole block where `pair` is one of block(frequency): of frequency 0 it
  /// has a value at row 0 again. First the centre's value, 0 but for frequency 0.
  struct WholeVector {
    number::Ball center;
    EnclosedPair pair;
  };
  [[nodiscard]] WholeVector whole_vector(int frequency, const EnclosedPair& pair) const;
  /// The block of frequency `frequency`, exactly; 1 included.
  [[nodiscard]] Result<number::DenseMatrix<number::Exact>> exact_block(const Scheme& scheme,
                                                                       int frequency) const;
  /// The same without the eigenvalue 1.
  [[nodiscard]] Result<number::DenseMatrix<number::Exact>> exact_rest(const Scheme& scheme,
                                                                      int frequency) const;

 private:
  [[nodiscard]] number::BallMatrix whole_block(int frequency) const;

  int n_ = 0;
  spectrum::SectorPattern pattern_;
  RealBasis basis_;
  NamedValues<number::Ball> values_;
};

/// For each frequency 0 … n/2 the squarings that show that all eigenvalues but 1 and `leader` (of
/// the block of its frequency) are below `bound`; -1 where `most_squarings` did not.
[[nodiscard]] std::vector<int> squarings_of_others(const ValenceBalls& balls, int leader_frequency,
                                                   const EnclosedPair& leader,
                                                   const number::Ball& bound, int most_squarings);

}  // namespace limn::certify
