// OpenSubdiv: positions again and again, by Far::StencilTable and by Far::PrimvarRefiner.

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/stencilTableFactory.h>

#include <utility>

#include "limn/base/parallel.h"
#include "opensubdiv_topology.h"
#include "repeated_peer.h"

namespace limn::peers {
namespace {

namespace far = OpenSubdiv::Far;

template <class Real>
class Stencils final : public RepeatedPeer {
 public:
  Stencils(Method method, const Polygons& control, int levels, const PeerTags& tags)
      : control_(osd_points<Real>(control.positions)) {
    const std::unique_ptr<far::TopologyRefiner> refiner = osd_topology(method, control, tags);
    refiner->RefineUniform(far::TopologyRefiner::UniformOptions(levels));
    using Factory = far::StencilTableFactoryReal<Real>;
    typename Factory::Options options;
    options.generateIntermediateLevels = false;
    options.generateOffsets = true;  // for chunks
    table_.reset(Factory::Create(*refiner, options));
    if (!table_) throw std::runtime_error("OpenSubdiv makes no stencils");
    points_.resize(static_cast<std::size_t>(table_->GetNumStencils()));
  }

  void evaluate() override {
    const auto count = static_cast<Index>(points_.size());
    if (thread_limit() == 1) {
      table_->UpdateValues(control_, points_);
      return;
    }
    base::parallel_for(0, count, [&](Index first, Index last) {
      table_->UpdateValues(control_, points_, first, last);
    });
  }
  [[nodiscard]] std::size_t vertex_count() const override { return points_.size(); }
  [[nodiscard]] std::vector<Point3> points() const override { return points_of(points_); }

 private:
  std::vector<OsdPoint<Real>> control_, points_;
  std::unique_ptr<const far::StencilTableReal<Real>> table_;
};

template <class Real>
class Primvars final : public RepeatedPeer {
 public:
  Primvars(Method method, const Polygons& control, int levels, const PeerTags& tags)
      : refiner_(osd_topology(method, control, tags)),
        levels_{osd_points<Real>(control.positions)} {
    refiner_->RefineUniform(far::TopologyRefiner::UniformOptions(levels));
    for (int level = 1; level <= levels; ++level)
      levels_.emplace_back(static_cast<std::size_t>(refiner_->GetLevel(level).GetNumVertices()));
  }

  void evaluate() override {
    const far::PrimvarRefinerReal<Real> primvars(*refiner_);
    for (std::size_t level = 1; level < levels_.size(); ++level)
      primvars.Interpolate(static_cast<int>(level), levels_[level - 1], levels_[level]);
  }
  [[nodiscard]] std::size_t vertex_count() const override { return levels_.back().size(); }
  [[nodiscard]] std::vector<Point3> points() const override { return points_of(levels_.back()); }

 private:
  std::unique_ptr<far::TopologyRefiner> refiner_;
  std::vector<std::vector<OsdPoint<Real>>> levels_;
};

template <template <class> class Kind>
std::unique_ptr<RepeatedPeer> make(Method method, const Polygons& control, int levels,
                                   Precision precision, const PeerTags& tags) {
  if (!osd_has(method)) return nullptr;
  if (precision == Precision::double_float)
    return std::make_unique<Kind<double>>(method, control, levels, tags);
  return std::make_unique<Kind<float>>(method, control, levels, tags);
}

}  // namespace

std::unique_ptr<RepeatedPeer> opensubdiv_stencils(Method method, const Polygons& control,
                                                  int levels, Precision precision,
                                                  const PeerTags& tags) {
  return make<Stencils>(method, control, levels, precision, tags);
}

std::unique_ptr<RepeatedPeer> opensubdiv_primvars(Method method, const Polygons& control,
                                                  int levels, Precision precision,
                                                  const PeerTags& tags) {
  return make<Primvars>(method, control, levels, precision, tags);
}

}  // namespace limn::peers
