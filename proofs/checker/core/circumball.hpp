#pragma once

#include <optional>

#include "proofs/checker/core/complex.hpp"

namespace delcert::checker::core {

/// x -> K x_0 y_0 + x_1 y_1 + ..., or x^T G y for K = 0.
template <class N>
class Form {
 public:
  explicit Form(const Data& data) : K_(data.K), m_(data.m), gram_(0), inverse_(0) {
    if (K_ != 0) return;
    gram_ = as(data.form);
    inverse_ = as(inverse_of(data.form));
    for (std::size_t i = 0; i < m_; ++i) {
      for (std::size_t k = 0; k < i; ++k) is_diagonal_ = is_diagonal_ && data.form(i, k).is_zero();
    }
  }
  N squared(const Vector<N>& x) const {
    return K_ == 0 ? squared_by(gram_, x) : N(K_) * square(x[0]) + squared_tail(x);
  }
  N product(const Vector<N>& x, const Vector<N>& y) const {
    if (K_ != 0) {
      N sum = N(K_) * x[0] * y[0];
      for (std::size_t k = 1; k <= m_; ++k) sum = sum + x[k] * y[k];
      return sum;
    }
    return dot(x, times(gram_, y), m_);
  }
  /// Of K = 0.
  const SquareMatrix<N>& gram() const { return gram_; }
  /// The form y -> <x, y>. K = 0.
  Vector<N> covector(const Vector<N>& x) const { return times(gram_, x); }
  /// The vector u with form(x) = <u, x>. K = 0.
  Vector<N> vector(const Vector<N>& form) const { return times(inverse_, form); }
  /// |u|^2 of this vector. K = 0.
  N squared_covector(const Vector<N>& form) const { return squared_by(inverse_, form); }

 private:
  static SquareMatrix<N> as(const FieldMatrix& a) {
    SquareMatrix<N> result(a.order());
    for (std::size_t i = 0; i < a.order(); ++i) {
      for (std::size_t k = 0; k < a.order(); ++k) {
        if constexpr (std::is_same_v<N, Rational>) {
          result(i, k) = a(i, k).constant_term();
        } else if constexpr (std::is_same_v<N, Ball>) {
          result(i, k) = a(i, k).enclosure();
        } else {
          result(i, k) = in_balls(128, [&] { return a(i, k).enclosure().enclosure(); });
        }
      }
    }
    return result;
  }
  N squared_tail(const Vector<N>& x) const {
    N sum = square(x[1]);
    for (std::size_t k = 2; k <= m_; ++k) sum = sum + square(x[k]);
    return sum;
  }
  N squared_by(const SquareMatrix<N>& a, const Vector<N>& x) const {
    N sum(0);
    for (std::size_t i = 0; i < m_; ++i) {
      sum = sum + a(i, i) * square(x[i]);
      for (std::size_t k = 0; k < i && !is_diagonal_; ++k) sum = sum + N(2) * a(i, k) * x[i] * x[k];
    }
    return sum;
  }
  Vector<N> times(const SquareMatrix<N>& a, const Vector<N>& x) const {
    if (!is_diagonal_) return a * x;
    Vector<N> result = x;
    for (std::size_t i = 0; i < m_; ++i) result[i] = a(i, i) * x[i];
    return result;
  }

  int K_;
  std::size_t m_;
  bool is_diagonal_ = true;  // and then its inverse is
  SquareMatrix<N> gram_, inverse_;
};

/// The circumball of a simplex that is not flat (docs/levels/core.md, How it is checked).
template <class N>
class Circumball {
 public:
  Circumball(const Data& data, const Form<N>& form, const Lifts<N>& lifts) : K_(data.K), base_(lifts[0]), form_(&form) {
    const std::size_t m = data.m;
    const Frame<N> frame(K_, m, lifts, 0);
    if (K_ == 0) {
      for (std::size_t k = 1; k <= m; ++k) {
        const Vector<N> cofactors = frame.cofactors_of(k);
        const Vector<N>& edge = frame.columns[frame.place(k)];
        linear_ = add(linear_, form.squared(edge) / (N(2) * dot(cofactors, edge, m)), cofactors);
      }
      tangent_squared_ = form.squared_covector(linear_);
      return;
    }
    const Vector<N> cofactors = frame.cofactors_of(0);
    linear_ = add(Vector<N>{}, N(1) / dot(cofactors, base_, m + 1), cofactors);
    Vector<N> u{};  // n - v_0, where linear_(x) = K <x, n>
    u[0] = linear_[0] - base_[0];
    for (std::size_t k = 1; k <= m; ++k) u[k] = N(K_) * linear_[k] - base_[k];
    tangent_squared_ = form.squared(u);
  }

  /// The centre, a point of the space. Precondition: the ball exists.
  Vector<N> centre() const {
    if (K_ == 0) return add(base_, N(1), form_->vector(linear_));
    // n = (l_0, K l_1, ...), of which the form is K (1 + K tan^2): 1 / cos^2, -1 / cosh^2.
    const N unit = N(1) / square_root(N(1) + N(K_) * tangent_squared_);
    Vector<N> result{};
    result[0] = unit * linear_[0];
    for (std::size_t k = 1; k < 4; ++k) result[k] = N(K_) * unit * linear_[k];
    return result;
  }
  /// The first vertex v_0, and the linear form of q - v_0 in the power.
  const Vector<N>& base() const { return base_; }
  const Vector<N>& linear() const { return linear_; }
  /// tan^2, square, tanh^2 of the radius; for K < 0 a ball exists if this is less than 1.
  const N& tangent_squared() const { return tangent_squared_; }
  /// pow(q), half of it for K = 0.
  N power(const Vector<N>& q) const {
    const Vector<N> y = q - base_;
    if (K_ == 0) return form_->squared(y) / N(2) - along(y);
    return K_ > 0 ? -along(y) : along(y);
  }

 private:
  N along(const Vector<N>& y) const {
    return linear_[0] * y[0] + linear_[1] * y[1] + linear_[2] * y[2] + linear_[3] * y[3];
  }
  int K_;
  Vector<N> base_, linear_{};
  const Form<N>* form_;
  N tangent_squared_{0};
};

/// Circumballs in each arithmetic.
class Circumballs {
 public:
  explicit Circumballs(Complex& complex) : complex_(complex), filter_(complex.data) {}

  /// Whether the predicate holds of the circumball. It takes a Circumball<N>.
  template <class Predicate>
  bool decide(std::size_t s, const Circumball<Interval>& filter, const Predicate& predicate) {
    return complex_.decide([&]<class N>(In<N>) {
      if constexpr (std::is_same_v<N, Interval>) {
        return predicate(filter);
      } else {
        const Form<N> in_form = form<N>();
        return predicate(Circumball<N>(complex_.data, in_form, complex_.lifts<N>(s)));
      }
    });
  }
  template <class N>
  decltype(auto) form() const {
    if constexpr (std::is_same_v<N, Interval>) {
      return (filter_);
    } else {
      return Form<N>(complex_.data);
    }
  }
  Circumball<Interval> filter(std::size_t s) { return {complex_.data, filter_, complex_.lifts<Interval>(s)}; }
  /// The same for those who ask several times for simplices whose numbers are near.
  const Circumball<Interval>& kept(std::size_t s) {
    auto& [number, ball] = kept_[s % kept_.size()];
    if (!ball || number != s) ball.emplace(filter(s));
    number = s;
    return *ball;
  }

 private:
  Complex& complex_;
  Form<Interval> filter_;
  std::array<std::pair<std::size_t, std::optional<Circumball<Interval>>>, 64> kept_;
};

}  // namespace delcert::checker::core
