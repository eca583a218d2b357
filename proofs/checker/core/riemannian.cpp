#include "proofs/checker/core/circumball.hpp"
#include "proofs/checker/core/rules.hpp"
#include "proofs/checker/parts/parts.hpp"

namespace delcert::checker::core {
namespace {

/// The chart exp^-1 at a vertex: orthonormal coordinates for K != 0, those of the frame for K = 0.
template <class N>
class TangentSpace {
 public:
  TangentSpace(const Data& data, const Form<N>& form) : K_(data.K), m_(data.m), form_(form) {}

  /// The lifts as seen from that of number k.
  Lifts<N> chart(Lifts<N> lifts, std::size_t k) const {
    // Conformal coordinates are large near -o; x -> -x changes no distance.
    if (K_ > 0 && less(lifts[k][0], N(0)) == Verdict::proved) {
      for (Vector<N>& x : lifts) x = Vector<N>{} - x;
    }
    Lifts<N> result{};
    for (std::size_t other = 0; other <= m_; ++other) {
      if (other == k) continue;
      if (K_ == 0) {
        result[other] = lifts[other] - lifts[k];
      } else {
        const Vector<N> a = conformal(m_, seen_from(K_, m_, conformal(m_, lifts[k]), lifts[other]));
        result[other] = add(Vector<N>{}, logarithm_factor(K_, checker::squared(a, m_) / N(4)), a);
      }
    }
    return result;
  }
  N squared(const Vector<N>& x) const { return K_ == 0 ? form_.squared(x) : checker::squared(x, m_); }
  N squared_covector(const Vector<N>& x) const { return K_ == 0 ? form_.squared_covector(x) : checker::squared(x, m_); }

  /// The least altitude is at least t m (longest edge). The altitude of a vertex is 1 / |b|, b the linear form that is
  /// 1 at it and 0 at the others.
  Verdict is_thick(const Lifts<N>& chart, const N& t) const {
    N longest(0);
    for (std::size_t a = 0; a <= m_; ++a) {
      for (std::size_t b = 0; b < a; ++b) longest = maximum(longest, squared(chart[a] - chart[b]));
    }
    const N least = square(t * N(static_cast<int>(m_))) * longest;
    const Frame<N> frame(0, m_, chart, 0);
    Vector<N> sum{};
    N determinant(0);
    Verdict result = Verdict::proved;
    for (std::size_t k = 1; k <= m_; ++k) {
      const Vector<N> cofactors = frame.cofactors_of(k);
      determinant = dot(cofactors, chart[k] - chart[0], m_);
      sum = add(sum, N(1), cofactors);
      result = conjunction(result, less_equal(least * squared_covector(cofactors), square(determinant)));
    }
    return conjunction(result, less_equal(least * squared_covector(sum), square(determinant)));
  }

 private:
  int K_;
  std::size_t m_;
  const Form<N>& form_;
};

}  // namespace

void check_riemannian_simplices(Complex& complex, const Quantity& thickness, const Quantity& radius, Report& report) {
  const Circumballs balls(complex);
  const auto check = [&](std::size_t s, Report& found) {
    for (std::size_t k = 0; k < complex.vertices(); ++k) {
      const auto holds = [&](const auto& predicate) {
        return decide_enclosed([&]<class N>(In<N>) {
          const Form<N>& form = balls.form<N>();
          const TangentSpace<N> space(complex.data, form);
          return predicate(space, space.chart(complex.lifts<N>(s), k));
        });
      };
      const auto is_thick = [&]<class N>(const TangentSpace<N>& space, const Lifts<N>& chart) {
        return space.is_thick(chart, thickness.as<N>());
      };
      const auto is_near = [&]<class N>(const TangentSpace<N>& space, const Lifts<N>& chart) {
        Verdict result = Verdict::proved;
        for (std::size_t other = 0; other < complex.vertices(); ++other)
          result = conjunction(result, less(space.squared(chart[other]), square(radius.as<N>())));
        return result;
      };
      // To see the lifts from one of them takes the longest: once for both, unless one of them fails.
      const bool both = holds([&]<class N>(const TangentSpace<N>& space, const Lifts<N>& chart) {
        return conjunction(is_thick(space, chart), is_near(space, chart));
      });
      if (both) continue;
      if (!holds(is_thick)) {
        found.reject("5.thickness", [&] {
          return complex.name(s) + " is thinner than " + about(thickness.filter) + " in the chart of one of its labels";
        });
      }
      if (!holds(is_near)) found.reject("5.radius", [&] { return complex.name(s) + " is larger than radius"; });
    }
  };
  in_parts("5.thickness, 5.radius", Items::simplices, complex.data.simplices(), report,
           [&](std::size_t begin, std::size_t end, Report& found) {
             for (std::size_t s = begin; s < end; ++s) check(s, found);
             return Counts{};
           });
}

}  // namespace delcert::checker::core
