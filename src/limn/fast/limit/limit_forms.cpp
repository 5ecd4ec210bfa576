#include "limn/fast/limit/limit_forms.h"

#include "limn/fast/layout/star_places.h"

namespace limn::fast {
namespace {

using Form = refine::LinearForm<double>;
using Spot = limit::LimitPlace<Form>;

Form difference(const Form& to, const Form& from) {
  Form sum = to;
  refine::add_scaled(sum, -1.0, from);
  return sum;
}

/// Two vectors whose cross product is the area vector of the one face, or nothing.
std::optional<std::array<Form, 2>> tangents_of_face(const Mesh& mesh,
                                                    const std::vector<Form>& values, Index h,
                                                    bool dual) {
  const auto value = [&](Index g) -> const Form& { return values[mesh.origin(g)]; };
  const Index last = mesh.prev(h), next = mesh.next(h);
  if (!dual) {
    if (mesh.twin(last) != kNone || mesh.twin(h) != kNone) return std::nullopt;
    return std::array{difference(value(next), value(h)), difference(value(last), value(h))};
  }
  if (mesh.degree(mesh.face(h)) != 4) return std::nullopt;
  return std::array{difference(value(mesh.next(next)), value(h)),
                    difference(value(last), value(next))};
}

/// t₀, t₁, …, whose Σ tᵢ × tᵢ₊₁ is the sum that normals are taken from where there are no two
/// tangents: from the vertex to its neighbours, or (dual) along the edges of the face.
void add_chain(const Mesh& mesh, const std::vector<Form>& values, Index start, bool dual,
               std::vector<Form>& chain) {
  const std::size_t first = chain.size();
  const auto edge = [&](Index h) {
    return difference(values[mesh.target(h)], values[mesh.origin(h)]);
  };
  for (Index h = start;;) {
    chain.push_back(edge(h));
    const Index next = dual ? mesh.next(h) : mesh.rotate(h);
    if (next == kNone) {
      const Index last = mesh.prev(h);
      chain.push_back(difference(values[mesh.origin(last)], values[mesh.target(last)]));
      return;
    }
    if (next == start) break;
    h = next;
  }
  chain.push_back(Form(chain[first]));
}

LimitOptions options_of(int steps_made, bool closed) {
  LimitOptions options;
  options.steps_made = steps_made;
  options.boundary = !closed;
  return options;
}

}  // namespace

template <class Read>
Status LimitReader::search(const Mesh& mesh, int steps_made, bool closed,
                           const std::vector<Index>& vertices, Read read) {
  const auto no_curvature = [](const Spot&) {};
  const LimitOptions options = options_of(steps_made, closed);
  return limit::LimitSearch<Form, Read, decltype(no_curvature)>(scheme_, kinds_, options, read,
                                                                no_curvature)
      .run(mesh, refine::unit_forms<double>(mesh.vertex_count()), vertices, nullptr);
}

Result<Index> LimitReader::regular_rings(bool open) {
  const Lattice lattice = scheme_.split->lattice;
  const int size = open ? half_plane_sectors(lattice) : plane_sectors(lattice);
  const Result<const limit::LimitKind*> kind = kinds_.find({open, size});
  if (!kind) return kind.error();
  return (*kind)->shape;
}

Result<std::vector<std::optional<LimitForms>>> LimitReader::read(
    const Mesh& mesh, int steps_made, bool closed, const std::vector<Index>& vertices) {
  std::vector<std::optional<LimitForms>> found(vertices.size());
  std::vector<Index> slot(static_cast<std::size_t>(mesh.vertex_count()), kNone);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    slot[vertices[i]] = static_cast<Index>(i);
    if (mesh.is_isolated(vertices[i])) found[i] = {Form::unit(vertices[i]), Form(), Form()};
  }
  const bool dual = scheme_.split->is_dual();
  const auto read = [&](const Spot& at) {
    const LimitStencil& limit = at.kind.limit;
    const Form position = at.weighted(limit.position);
    std::optional<LimitForms>& forms = found[slot[at.vertex]];
    if (!limit.has_plane)
      forms = {position, Form(), Form()};
    else if (!limit.first_tangent.empty())
      forms = {position, at.weighted(limit.first_tangent), at.weighted(limit.second_tangent)};
    else if (auto tangents = tangents_of_face(at.mesh, at.values, at.start, dual))
      forms = {position, std::move((*tangents)[0]), std::move((*tangents)[1])};
    for (const Index v : at.others) found[slot[v]] = forms;
  };
  if (Status status = search(mesh, steps_made, closed, vertices, read); !status)
    return status.error();
  return found;
}

Result<LimitChain> LimitReader::read_chain(const Mesh& mesh, int steps_made, bool closed,
                                           Index vertex) {
  LimitChain chain;
  const bool dual = scheme_.split->is_dual();
  const auto read = [&](const Spot& at) {
    chain.forms = {at.weighted(at.kind.limit.position)};
    add_chain(at.mesh, at.values, at.start, dual, chain.forms);
    chain.rings = at.kind.shape;
  };
  if (Status status = search(mesh, steps_made, closed, {vertex}, read); !status)
    return status.error();
  return chain;
}

}  // namespace limn::fast
