#include "limn/number/exact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace limn::number {
namespace {

// Largest denominator of a turn for which a cosine is written exactly, largest order of a field
// that sums and products are formed in (their cost grows with its square).
constexpr int kLargestOrder = 4096;
constexpr double kLargestField = 1024;
constexpr double kMostBits = 4096;
constexpr double kLargestExponent = 1000;  // numbers stay within a double's range
constexpr double kMostTerms = 64;
constexpr double kDeepestRoots = 4;
constexpr double kMostWork = 5e5;  // of one operation

/// Of two integers below 1e9.
double common_multiple(double a, double b) {
  return static_cast<double>(std::lcm(static_cast<long long>(a), static_cast<long long>(b)));
}

thread_local double work_left = std::numeric_limits<double>::infinity();

Error failure(std::string message, std::string hint = {}) {
  return {std::move(message), std::move(hint)};
}

bool same_number(const std::shared_ptr<const Exact>& a, const std::shared_ptr<const Exact>& b) {
  return a == b || *a == *b;
}

template <class Roots>
auto find_root(Roots& roots, const std::shared_ptr<const Exact>& root) {
  return std::find_if(roots.begin(), roots.end(),
                      [&](const auto& other) { return same_number(other, root); });
}

template <class Roots>
bool same_roots(const Roots& a, const Roots& b) {
  if (a.size() != b.size()) return false;
  return std::all_of(a.begin(), a.end(),
                     [&](const auto& root) { return find_root(b, root) != b.end(); });
}

}  // namespace

Exact::Exact(Cyclotomic value) {
  if (!value.is_zero()) terms_.push_back({{}, std::move(value)});
}

Exact Exact::pi() {
  Exact result;
  result.pi_ = 1;
  return result;
}

bool Exact::is_rational() const {
  if (pi_ != 0) return false;
  return terms_.empty() ||
         (terms_.size() == 1 && terms_[0].roots.empty() && terms_[0].coefficient.is_rational());
}

Rational Exact::rational() const {
  return terms_.empty() ? Rational(0) : terms_[0].coefficient.rational();
}

double Exact::approx() const {
  double sum = to_double(pi_) * M_PI;
  for (const Term& term : terms_) {
    double product = term.coefficient.approx();
    for (const Root& root : term.roots) product *= std::sqrt(root->approx());
    sum += product;
  }
  return sum;
}

double Exact::magnitude() const {
  double sum = std::abs(to_double(pi_)) * M_PI;
  for (const Term& term : terms_) {
    double product = 0;
    for (const Rational& q : term.coefficient.coefficients()) product += std::abs(to_double(q));
    for (const Root& root : term.roots) product *= std::sqrt(root->approx());
    sum += product;
  }
  return sum;
}

void Exact::add(Term term) {
  const auto found = std::find_if(terms_.begin(), terms_.end(), [&](const Term& other) {
    return same_roots(other.roots, term.roots);
  });
  if (found == terms_.end()) {
    if (!term.coefficient.is_zero()) terms_.push_back(std::move(term));
    return;
  }
  found->coefficient += term.coefficient;
  if (found->coefficient.is_zero()) terms_.erase(found);
}

Exact::Size Exact::size() const {
  Size size;
  const auto measure = [&size](const Rational& q) {
    if (q == 0) return;
    const auto bits = [](const Integer& i) { return static_cast<double>(msb(abs(i)) + 1); };
    const double top = bits(numerator(q));
    const double bottom = bits(denominator(q));
    size.bits = std::max({size.bits, top, bottom});
    size.huge = size.huge || top - bottom > kLargestExponent;
  };
  const auto join = [&size](double order) {
    // beyond what is allowed anyway the exact value does not matter
    size.order = size.order * order > 1e9 ? 1e9 : common_multiple(size.order, order);
  };
  measure(pi_);
  for (const Term& term : terms_) {
    size.terms += 1;
    join(term.coefficient.order());
    for (const Rational& q : term.coefficient.coefficients()) measure(q);
    for (const Root& root : term.roots) {
      const Size inner = root->size();
      size.terms += inner.terms;
      join(inner.order);
      size.bits = std::max(size.bits, inner.bits);
      size.depth = std::max(size.depth, inner.depth + 1);
      size.huge = size.huge || inner.huge;
    }
  }
  return size;
}

/// Takes the cost of an operation on a and b from the budget: `operations` multiplications of
/// rationals per pair of terms (in the square of the field's order, where both are irrational).
Status Exact::charge(const Size& a, const Size& b, double operations) {
  const double order = common_multiple(a.order, b.order);
  if (order > kLargestField && a.order != 1 && b.order != 1)
    return failure(
        "cosines of such small or such different fractions of pi cannot be combined exactly");
  const double pairs = std::max(1.0, a.terms) * std::max(1.0, b.terms);
  const double length = 1 + (a.bits + b.bits) / 256;
  const double work = pairs * length * (1 + operations * order);
  if (work > kMostWork) return failure("the numbers are too long for exact arithmetic");
  if (work > work_left) {
    work_left = 0;  // the next one, be it short, does not go on either
    return failure("the exact arithmetic takes too long");
  }
  work_left -= work;
  return Done{};
}

Result<Exact> Exact::bounded(Exact value) {
  const Size size = value.size();
  if (size.huge) return failure("the number is too large");
  if (size.bits > kMostBits || size.terms > kMostTerms || size.depth > kDeepestRoots)
    return failure("the number is too long for exact arithmetic");
  return value;
}

ExactBudget::ExactBudget(double work) : outer_(work_left), given_(std::min(work, work_left)) {
  work_left = given_;
}
ExactBudget::~ExactBudget() { work_left = outer_ - (given_ - work_left); }

Exact& Exact::operator+=(const Exact& b) {
  pi_ += b.pi_;
  for (const Term& term : b.terms_) add(term);
  return *this;
}

Exact& Exact::operator-=(const Exact& b) {
  pi_ -= b.pi_;
  for (Term term : b.terms_) {
    term.coefficient *= Cyclotomic(Rational(-1));
    add(std::move(term));
  }
  return *this;
}

Exact Exact::product(const Term& a, const Term& b) {
  Exact result(a.coefficient * b.coefficient);
  if (result.terms_.empty()) return result;
  std::vector<Root> roots = a.roots;
  Exact squares(1);
  for (const Root& root : b.roots) {
    const auto found = find_root(roots, root);
    if (found == roots.end()) {
      roots.push_back(root);
    } else {  // t·t = its radicand
      roots.erase(found);
      squares = squares * *root;
    }
  }
  result.terms_[0].roots = std::move(roots);
  return squares == Exact(1) ? result : result * squares;
}

Exact operator*(const Exact& a, const Exact& b) {
  Exact result;
  if (a.pi_ != 0) result.pi_ = a.pi_ * b.rational();
  if (b.pi_ != 0) result.pi_ = b.pi_ * a.rational();
  for (const Exact::Term& s : a.terms_)
    for (const Exact::Term& t : b.terms_) result += Exact::product(s, t);
  return result;
}

Result<Exact> Exact::add(const Exact& a, const Exact& b) {
  const Size left = a.size();
  const Size right = b.size();
  // numbers of one field are added coefficient by coefficient, others lifted to a common field
  const bool lifts = left.order != right.order && left.order != 1 && right.order != 1;
  const double operations = lifts ? std::max(left.order, right.order) : 1;
  if (Status status = charge(left, right, operations); !status) return status.error();
  return bounded(a + b);
}

Result<Exact> Exact::subtract(const Exact& a, const Exact& b) { return add(a, Exact(-1) * b); }

Result<Exact> Exact::multiply(const Exact& a, const Exact& b) {
  if ((a.pi_ != 0 && !b.is_rational()) || (b.pi_ != 0 && !a.is_rational()))
    return failure("pi is multiplied by something that is not rational",
                   "pi may only stand in the argument of cos or sin, times a rational");
  const Size left = a.size();
  const Size right = b.size();
  const bool scales = std::min(left.order, right.order) == 1;
  const double operations = scales ? 1 : common_multiple(left.order, right.order);
  if (Status status = charge(left, right, operations); !status) return status.error();
  return bounded(a * b);
}

Result<Exact> Exact::inverse() const {
  if (is_zero()) return failure("division by zero");
  if (pi_ != 0) return failure("division by a multiple of pi");
  const auto with_root = std::find_if(terms_.begin(), terms_.end(),
                                      [](const Term& term) { return !term.roots.empty(); });
  if (with_root == terms_.end()) {
    // Euclid's algorithm: as many operations as a product, on numbers of many times the length
    const Size own = size();
    if (Status status = charge(own, own, own.order * (1 + own.order / 32)); !status)
      return status.error();
    return bounded(Exact(terms_[0].coefficient.inverse()));
  }
  // a + b·t with t = sqrt(r): multiply by the conjugate a - b·t, which leaves a² - b²·r
  const Root root = with_root->roots.front();
  Exact conjugate;
  for (Term term : terms_) {
    if (find_root(term.roots, root) != term.roots.end())
      term.coefficient *= Cyclotomic(Rational(-1));
    conjugate.add(std::move(term));
  }
  Result<Exact> norm = multiply(*this, conjugate);
  if (!norm) return norm;
  if (norm->is_zero()) {  // t is after all in the field, and a = ±b·t: the number is 2a, or 0
    if (!(std::abs(approx()) > 1e-9 * magnitude())) return failure("division by zero");
    return (*this + conjugate).inverse();
  }
  Result<Exact> reciprocal = norm->inverse();
  if (!reciprocal) return reciprocal;
  return multiply(conjugate, *reciprocal);
}

Result<Exact> Exact::divide(const Exact& a, const Exact& b) {
  Result<Exact> reciprocal = b.inverse();
  if (!reciprocal) return reciprocal;
  return multiply(a, *reciprocal);
}

Result<Exact> Exact::cos(const Exact& angle) {
  if (!angle.terms_.empty())
    return failure("the argument of cos or sin is not a rational multiple of pi",
                   "write it as in cos(2*pi*k/n)");
  const Rational turns = angle.pi_ / 2;
  const Integer q = denominator(turns);
  if (q > kLargestOrder)
    return failure("cos or sin of a fraction of pi below 1/" + std::to_string(kLargestOrder / 2) +
                   " is not exact here");
  const Integer p = numerator(turns) % q;
  return Exact(Cyclotomic::cos_turn(p.convert_to<long long>(), q.convert_to<long long>()));
}

Result<Exact> Exact::sin(const Exact& angle) {
  Exact quarter = Exact::pi();
  quarter.pi_ /= 2;
  return cos(angle - quarter);
}

Result<Exact> Exact::sqrt(const Exact& square) {
  if (square.pi_ != 0) return failure("square root of a multiple of pi");
  if (square.is_zero()) return Exact(0);
  if (square.approx() < 0) return failure("square root of a negative number");
  if (square.is_rational()) {
    const Rational q = square.rational();
    const Integer top = limn::sqrt(numerator(q));
    const Integer bottom = limn::sqrt(denominator(q));
    const Rational root(top, bottom);
    if (root * root == q) return Exact(root);
  }
  Exact result;
  result.terms_.push_back({{std::make_shared<const Exact>(square)}, Cyclotomic(Rational(1))});
  return bounded(std::move(result));
}

}  // namespace limn::number
