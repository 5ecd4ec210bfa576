#include "limn/number/exact.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// Largest denominator of a turn for which exact arithmetic is sensible: the cost of a product
// grows with its square.
constexpr int kLargestOrder = 4096;

Error failure(std::string message, std::string hint = {}) {
  return {std::move(message), std::move(hint), {}, 0, 0};
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
  return terms_.empty() || (terms_.size() == 1 && terms_[0].roots.empty() &&
                            terms_[0].coefficient.is_rational());
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

Result<Exact> Exact::multiply(const Exact& a, const Exact& b) {
  const auto has_pi = [](const Exact& x) { return x.pi_ != 0; };
  if ((has_pi(a) && !b.is_rational()) || (has_pi(b) && !a.is_rational()))
    return failure("pi is multiplied by something that is not rational",
                   "pi may only stand in the argument of cos or sin, times a rational");
  Exact result;
  if (has_pi(a)) result.pi_ = a.pi_ * b.rational();
  if (has_pi(b)) result.pi_ = b.pi_ * a.rational();
  for (const Term& s : a.terms_)
    for (const Term& t : b.terms_) result += product(s, t);
  return result;
}

Result<Exact> Exact::inverse() const {
  if (is_zero()) return failure("division by zero");
  if (pi_ != 0) return failure("division by a multiple of pi");
  const auto with_root = std::find_if(terms_.begin(), terms_.end(),
                                      [](const Term& term) { return !term.roots.empty(); });
  if (with_root == terms_.end()) return Exact(terms_[0].coefficient.inverse());
  // a + b·t with t = sqrt(r): multiply by the conjugate a - b·t, which leaves a² - b²·r
  const Root root = with_root->roots.front();
  Exact conjugate;
  for (Term term : terms_) {
    if (find_root(term.roots, root) != term.roots.end())
      term.coefficient *= Cyclotomic(Rational(-1));
    conjugate.add(std::move(term));
  }
  const Exact norm = *this * conjugate;
  if (norm.is_zero()) return failure("division by zero");
  Result<Exact> reciprocal = norm.inverse();
  if (!reciprocal) return reciprocal;
  return conjugate * *reciprocal;
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
  const Integer q = boost::multiprecision::denominator(turns);
  if (q > kLargestOrder) return failure("cos or sin of a fraction of pi below 1/" +
                                        std::to_string(kLargestOrder / 2) + " is not exact here");
  const Integer p = boost::multiprecision::numerator(turns) % q;
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
    const Integer top = boost::multiprecision::sqrt(Integer(boost::multiprecision::numerator(q)));
    const Integer bottom =
        boost::multiprecision::sqrt(Integer(boost::multiprecision::denominator(q)));
    const Rational root(top, bottom);
    if (root * root == q) return Exact(root);
  }
  Exact result;
  result.terms_.push_back({{std::make_shared<const Exact>(square)}, Cyclotomic(Rational(1))});
  return result;
}

}  // namespace limn
