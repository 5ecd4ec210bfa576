#pragma once
/// Private to the page of [KS]: what its parts share.

#include <map>
#include <string>
#include <vector>

#include "limn/figure/space/shaded_panel.h"
#include "limn/figure/space/surface_scene.h"
#include "limn/mesh/mesh.h"
#include "limn/scheme/scheme.h"
#include "papers/paper_page.h"

namespace limn::ks {

/// A mesh to subdivide. Its surfaces are seen in one frame, from one side.
struct Control {
  std::string name;   ///< "torus"
  std::string title;  ///< a sentence
  Mesh mesh;
  std::vector<Point3> points;
  int steps;                  ///< that limit surfaces of it are sampled after
  double azimuth, elevation;  ///< degrees, of the viewer
};

/// Fig. 6: every vertex regular. Fig. 10 and 29: a cube with a diagonal in each face, so that four
/// vertices have 3 edges and four have 6. Fig. 23: vertex 0 raised over a flat regular mesh.
[[nodiscard]] Control torus_control();
[[nodiscard]] Control cube_control();
[[nodiscard]] Control raised_control(int valence = 6);

/// A scheme of the paper, its parameter set: "laplacian-butterfly", {"b=3/16"}.
struct Member {
  std::string words;  ///< as captions name it
  std::string scheme;
  std::vector<std::string> parameters = {};

  [[nodiscard]] Result<Scheme> load() const;
};

/// The members that the paper compares.
struct Members {
  Member loop{"Loop", "loop"};
  Member high{"high pass", "laplacian-loop"};
  Member low{"low pass, á = 1", "laplacian-loop-low"};
  Member butterfly{"butterfly", "butterfly-modified"};
  Member eighth{"butterfly, b = 1/8", "laplacian-butterfly", {"b=1/8"}};
  Member sixteenths{"butterfly, b = 3/16", "laplacian-butterfly", {"b=3/16"}};
  Member quarter{"butterfly, b = 1/4", "laplacian-butterfly", {"b=1/4"}};
  Member optimal{"optimal", "optimal"};
  Member optimal_high{"optimal, high pass", "optimal-high"};
  Member optimal_low{"optimal, low pass", "optimal-low"};
};

/// Control meshes and limit surfaces, each made once.
class Studio {
 public:
  Studio();

  Control torus, cube, raised;
  Members members;

  /// The limit surface; the reference lives as long as the studio.
  [[nodiscard]] Result<const figure::SmoothSurface*> surface(const Control& control,
                                                             const Member& member);

 private:
  std::map<std::pair<std::string, std::string>, figure::SmoothSurface> surfaces_;
};

/// What one sees of a surface in a number.
struct SurfaceSize {
  double area = 0;
  double volume = 0;  ///< under it: what it encloses, or what lies between it and the plane z = 0
  double lowest = 0, highest = 0;
};
[[nodiscard]] SurfaceSize size_of(const figure::SmoothSurface& surface);

/// A mesh with flat faces.
[[nodiscard]] figure::ShadedPanel control_panel(const Control& control,
                                                const figure::ViewFrame& frame);

/// Figures 6-15, 23-34 and 37-46; the control meshes as files.
[[nodiscard]] Status add_surfaces(PaperPage& page, Studio& studio);

/// Fig. 1: Loop's steps from a mesh to its limit surface. Figs. 2-5: the numbering round a vertex,
/// the stencils of the 1-disc, of the Laplacian and of its pseudo inverse.
[[nodiscard]] Status add_foundations(PaperPage& page, Studio& studio);

/// Figures 16-22: the operator for interpolating schemes; the stencils of new vertices, from the
/// schemes' rules.
[[nodiscard]] Status add_stencils(PaperPage& page, const Members& members);

/// Fig. 35: the eigenvalues of D_k and their circle.
[[nodiscard]] Status add_circle(PaperPage& page, const Members& members);

/// Fig. 36: the difference vectors round a vertex in the limit.
[[nodiscard]] Status add_differences(PaperPage& page, const Members& members);

/// Differences in the limit from random vectors: how far they are from an affine image of the
/// regular k-gon, and the ratio of the half-axes of the ellipse through them, 1 if it is regular.
struct DifferenceFit {
  double distance = 0, axes = 1;
};
[[nodiscard]] Result<DifferenceFit> difference_fit(const Members& members, int k);

/// The claims with their verdicts; misprints.
[[nodiscard]] Status add_claims(PaperPage& page, Studio& studio);

}  // namespace limn::ks
