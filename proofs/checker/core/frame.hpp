#pragma once

#include "proofs/checker/core/data.hpp"

namespace delcert::checker::core {

template <class N>
using Columns = std::array<Vector<N>, 4>;
template <class N>
using Lifts = std::array<Vector<N>, 5>;

template <class N>
N minor_2(const Vector<N>& a, const Vector<N>& b, std::size_t i, std::size_t k) {
  return a[i] * b[k] - a[k] * b[i];
}
template <class N>
N minor_3(const Vector<N>& a, const Vector<N>& b, const Vector<N>& c, std::size_t i, std::size_t j, std::size_t k) {
  return a[i] * minor_2(b, c, j, k) - a[j] * minor_2(b, c, i, k) + a[k] * minor_2(b, c, i, j);
}

/// The linear form y -> det(columns 0 ... d-1 with y in the place k), 1 <= d <= 4.
template <class N>
Vector<N> cofactors(const Columns<N>& columns, std::size_t d, std::size_t k) {
  std::array<const Vector<N>*, 3> others{};
  for (std::size_t at = 0, next = 0; at < d; ++at) {
    if (at != k) others[next++] = &columns[at];
  }
  Vector<N> form{};
  if (d == 1) {
    form[0] = N(1);
  } else if (d == 2) {
    const Vector<N>& a = *others[0];
    form = {a[1], -a[0], N(0), N(0)};
  } else if (d == 3) {
    const Vector<N>&a = *others[0], &b = *others[1];
    form = {minor_2(a, b, 1, 2), minor_2(a, b, 2, 0), minor_2(a, b, 0, 1), N(0)};
  } else {
    const Vector<N>&a = *others[0], &b = *others[1], &c = *others[2];
    form = {minor_3(a, b, c, 1, 2, 3), -minor_3(a, b, c, 0, 2, 3), minor_3(a, b, c, 0, 1, 3),
            -minor_3(a, b, c, 0, 1, 2)};
  }
  if (k % 2 == 1) {
    for (N& x : form) x = -x;
  }
  return form;
}

/// A simplex seen from one of its vertices, `base`: for K != 0 the columns are its lifts less that one, and that one
/// itself in its place; for K = 0 there is no column for it.
template <class N>
struct Frame {
  Columns<N> columns{};
  std::size_t d = 0, base = 0;
  bool flat = false;

  Frame(int K, std::size_t m, const Lifts<N>& lifts, std::size_t seen_from)
      : d(K == 0 ? m : m + 1), base(seen_from), flat(K == 0) {
    for (std::size_t k = 0; k <= m; ++k) {
      if (k != base) columns[place(k)] = lifts[k] - lifts[base];
    }
    if (!flat) columns[base] = lifts[base];
  }

  /// Of the vertex k, which for K = 0 is not the base.
  std::size_t place(std::size_t k) const { return flat && k > base ? k - 1 : k; }
  Vector<N> cofactors_of(std::size_t k) const { return cofactors(columns, d, place(k)); }
  /// By which a determinant of the columns differs from that of V.
  int sign() const { return flat && base % 2 == 1 ? -1 : 1; }
};

/// The determinant of the lifts in V: of (1, x) for K = 0.
template <class N>
N determinant(int K, std::size_t m, const Lifts<N>& lifts) {
  const Frame<N> frame(K, m, lifts, 0);
  return dot(frame.cofactors_of(m), frame.columns[frame.place(m)], frame.d);
}

}  // namespace delcert::checker::core
