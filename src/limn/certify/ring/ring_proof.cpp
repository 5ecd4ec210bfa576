#include "limn/certify/ring/ring_proof.h"

#include <algorithm>
#include <deque>

#include <fmt/core.h>

namespace limn::certify {
namespace {

std::string text(LatticeVector cell) { return fmt::format("cell ({}, {})", cell[0], cell[1]); }

/// Whether the words, in order, are the leaves of a tree of digits below `count`.
class Tiling {
 public:
  Tiling(const std::vector<std::string>& words, int count) : words_(words), count_(count) {}
  [[nodiscard]] bool holds() { return fills("") && next_ == words_.size(); }

 private:
  bool fills(const std::string& word) {
    if (next_ >= words_.size() || word.size() > RingProof::kDeepest) return false;
    if (words_[next_] == word) {
      ++next_;
      return true;
    }
    for (int d = 0; d < count_; ++d)
      if (!fills(word + static_cast<char>('0' + d))) return false;
    return true;
  }

  const std::vector<std::string>& words_;
  int count_;
  std::size_t next_ = 0;
};

}  // namespace

RingProof::RingProof(const CellMatrices& cells, const CellSigns& signs, EigenNet& net,
                     const Phase<number::Ball>& phase, RingGoal goal)
    : cells_(cells), signs_(signs), net_(net), phase_(phase), goal_(goal) {}

/// An eigenvector has no sign: the direction is turned to where the map is, on the spoke (dual: the
/// diagonal) at the ring's inner boundary.
Status RingProof::look(int inner) {
  const Result<NetPoint> first = net_.at({inner, cells_.dual ? inner : 0});
  if (!first) return first.error();
  const Turn<number::Ball> middle = goal_ == RingGoal::one_sign
                                        ? Turn<number::Ball>({number::Ball(1), number::Ball(0)})
                                        : phase_(cells_.dual ? -1 : 1, 4);
  const bool negative = first->u.is_negative();
  direction_ = {negative ? -middle.cosine : middle.cosine,
                negative ? -middle.to_imaginary : middle.to_imaginary};
  direction_u_ = DoubleBall(direction_.u);
  direction_v_ = DoubleBall(direction_.v);
  return Done{};
}

namespace {

template <class Number>
int sign_of(const Number& number) {
  return number.is_positive() ? 1 : number.is_negative() ? -1 : 0;
}

}  // namespace

RingProof::Told RingProof::told_by(const QuickCells::Map& map) const {
  Told told;
  if (goal_ == RingGoal::regular) {
    told.sign = sign_of(signs_.quick().jacobian(map));
    if (told.sign != 1) return told;
  }
  const QuickCells::Values at = signs_.quick().values(map);
  told.shown = goal_ == RingGoal::nowhere_zero
                   ? !at.u.holds_zero() || !at.v.holds_zero()
                   : (at.u * direction_u_ + at.v * direction_v_).is_positive();
  return told;
}

RingProof::Told RingProof::told_by(const CellMap& map) const {
  Told told;
  if (goal_ == RingGoal::regular) {
    told.sign = sign_of(signs_.jacobian(map));
    if (told.sign != 1) return told;
  }
  const NetPoint at = signs_.values(map);
  told.shown = goal_ == RingGoal::nowhere_zero
                   ? !at.u.holds_zero() || !at.v.holds_zero()
                   : (at.u * direction_.u + at.v * direction_.v).is_positive();
  return told;
}

Result<RingProof::Told> RingProof::tell(QuickCells::Map& map, LatticeVector cell,
                                        const std::string& word) {
  const Told told = told_by(map);
  if (told.shown || told.sign == -1 || signs_.quick().is_sharp(map)) return told;
  const Result<CellMap> exact = map_of(cell, word);
  if (!exact) return exact.error();
  map = signs_.quick().map_of(*exact);  // parts of it begin with new, small errors
  return told_by(*exact);
}

Result<RingProof::Found> RingProof::search(int most_parts, const Stop& stop) {
  const Result<RingCells> ring = ring_cells(cells_);
  if (!ring) return ring.error();
  if (Status looked = look(ring->inner); !looked) return looked.error();
  struct Part {
    std::size_t cell;
    QuickCells::Map map;
    std::string word;
  };
  // large parts first, of all cells: where the map folds, both signs are soon seen
  std::deque<Part> open;
  Found found;
  found.inner = ring->inner;
  for (const LatticeVector cell : ring->cells) {
    const Result<CellMap> whole = signs_.map_on(net_, cell);
    if (!whole) return whole.error();
    open.push_back({found.ring.size(), signs_.quick().map_of(*whole), ""});
    found.ring.push_back({cell, {}});
  }
  std::optional<PartPlace> positive;
  std::optional<PartPlace> negative;
  std::string failed;
  for (int cut = 0; !open.empty(); open.pop_front()) {
    Part& part = open.front();
    CellClaim& cell = found.ring[part.cell];
    const Result<Told> told = tell(part.map, cell.cell, part.word);
    if (!told) return told.error();
    if (told->sign == 1 && !positive) positive = PartPlace{cell.cell, part.word};
    if (told->sign == -1 && !negative) negative = PartPlace{cell.cell, part.word};
    if (positive && negative) {
      found.answer = Answer::refuted;
      found.fold = {*positive, *negative};
      found.ring.clear();
      return found;
    }
    if (told->shown) {
      cell.parts.push_back(part.word);
      continue;
    }
    if (part.word.size() >= kDeepest || ++cut > most_parts || asked(stop)) {
      if (failed.empty())
        failed = text(cell.cell) + (part.word.empty() ? "" : ", part " + part.word);
      continue;
    }
    for (std::size_t d = 0; d < cells_.residual.size(); ++d)
      open.push_back(
          {part.cell, signs_.quick().part(part.map, d), part.word + static_cast<char>('0' + d)});
  }
  for (CellClaim& cell : found.ring) std::sort(cell.parts.begin(), cell.parts.end());
  if (failed.empty()) {
    found.answer = Answer::proved;
  } else {
    found.ring.clear();
    found.reason =
        asked(stop) ? "the time ended while the characteristic map was looked at"
                    : "the characteristic map's Jacobian or place could not be told on " + failed;
  }
  return found;
}

Status RingProof::check(int inner, const std::vector<CellClaim>& claimed) {
  const Result<RingCells> ring = ring_cells(cells_);
  if (!ring) return ring.error();
  if (ring->inner != inner || ring->cells.size() != claimed.size())
    return Error{"the cells of the certificate are not those of the ring"};
  if (Status looked = look(inner); !looked) return looked;
  for (std::size_t i = 0; i < claimed.size(); ++i) {
    if (claimed[i].cell != ring->cells[i])
      return Error{text(claimed[i].cell) + " is not the ring's next, " + text(ring->cells[i])};
    if (!Tiling(claimed[i].parts, static_cast<int>(cells_.residual.size())).holds())
      return Error{text(claimed[i].cell) + ": its parts do not fill it"};
    if (Status shown = check_parts(claimed[i]); !shown) return shown;
  }
  return Done{};
}

/// The parts are in order: maps along the way to one are kept for the next. Precondition: they fill
/// the cell.
Status RingProof::check_parts(const CellClaim& claim) {
  const Result<CellMap> whole = signs_.map_on(net_, claim.cell);
  if (!whole) return whole.error();
  std::vector<QuickCells::Map> way{signs_.quick().map_of(*whole)};
  std::string last;
  for (const std::string& part : claim.parts) {
    const auto differs = std::mismatch(last.begin(), last.end(), part.begin(), part.end());
    way.resize(static_cast<std::size_t>(differs.second - part.begin()) + 1);
    for (std::size_t i = way.size() - 1; i < part.size(); ++i)
      way.push_back(signs_.quick().part(way.back(), static_cast<std::size_t>(part[i] - '0')));
    last = part;
    const Result<Told> told = tell(way.back(), claim.cell, part);
    if (!told) return told.error();
    if (!told->shown)
      return Error{text(claim.cell) + ", part " + part + ": it does not show what is claimed"};
  }
  return Done{};
}

Result<CellMap> RingProof::map_of(LatticeVector cell, const std::string& word) {
  Result<CellMap> map = signs_.map_on(net_, cell);
  for (const char c : word) {
    const auto digit = static_cast<std::size_t>(c - '0');
    if (map && digit >= cells_.residual.size()) return Error{"there is no part " + word};
    if (map) map = signs_.part(*map, digit);
  }
  return map;
}

Status RingProof::check_fold(const std::array<PartPlace, 2>& fold, int inner) {
  const Result<RingCells> ring = ring_cells(cells_);
  if (!ring) return ring.error();
  if (ring->inner != inner) return Error{"the ring begins elsewhere"};
  if (Status looked = look(inner); !looked) return looked;
  for (std::size_t i = 0; i < fold.size(); ++i) {
    if (std::find(ring->cells.begin(), ring->cells.end(), fold[i].cell) == ring->cells.end() ||
        fold[i].part.size() > kDeepest)
      return Error{text(fold[i].cell) + " is not one of the ring"};
    const Result<CellMap> map = map_of(fold[i].cell, fold[i].part);
    if (!map) return map.error();
    if (told_by(*map).sign != (i == 0 ? 1 : -1))
      return Error{text(fold[i].cell) + ": the Jacobian's sign is not shown"};
  }
  return Done{};
}

}  // namespace limn::certify
