#include "kernel/theorems/full_stars.hpp"

#include <algorithm>
#include <concepts>
#include <map>
#include <optional>

#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/scalar.hpp"
#include "kernel/simplex/frame_metric.hpp"

namespace delcert {

namespace {

/// The labels of a simplex but the one whose star it is in.
template <int m>
using OtherLabels = std::array<std::uint32_t, static_cast<std::size_t>(m)>;

/// None if this is not sure.
std::optional<int> sign_of(const Interval& x) {
  if (x.lower() > 0) return 1;
  if (x.upper() < 0) return -1;
  return std::nullopt;
}
std::optional<int> sign_of(const Rational& x) { return x < Rational(0) ? -1 : Rational(0) < x ? 1 : 0; }

/// A star on a rung; `undecided` once a sign was not sure.
template <class S, int m>
class StarOnRung {
 public:
  StarOnRung(const std::vector<TangentChart>& charts, std::uint32_t i)
      : charts_(charts), centre_(charts[i].data().centre), chart_(enclosed(charts[i])) {}

  /// What is wrong with it, if anything.
  [[nodiscard]] std::optional<std::string> fault(const std::vector<OtherLabels<m>>& star) {
    std::map<std::vector<std::uint32_t>, int> sides;
    for (const OtherLabels<m>& others : star) {
      for (std::size_t apex = 0; apex < m; ++apex) {
        std::vector<std::uint32_t> face;
        Matrix<S, m> columns;
        columns[0] = place(others[apex]);
        for (std::size_t k = 0; k < m; ++k) {
          if (k == apex) continue;
          columns[face.size() + 1] = place(others[k]);
          face.push_back(others[k]);
        }
        const int side = sign(columns);
        const auto [at, is_new] = sides.try_emplace(face, side);
        if (side == 0 || (!is_new && at->second == side)) return "two simplices on one side of a face, or a flat one";
      }
    }
    Vector<S, m> ray = place(star[0][0]);
    for (std::size_t k = 1; k < m; ++k) ray = sum(ray, place(star[0][k]));
    for (std::size_t at = 1; at < star.size(); ++at) {
      Matrix<S, m> columns;
      for (std::size_t k = 0; k < m; ++k) columns[k] = place(star[at][k]);
      const int orientation = sign(columns);
      bool is_missed = false;
      for (std::size_t k = 0; k < m; ++k) {
        Matrix<S, m> exchanged = columns;
        exchanged[k] = ray;
        is_missed = sign(exchanged) * orientation < 0 || is_missed;
      }
      if (!is_missed) return "it goes around its label more than once";
    }
    return std::nullopt;
  }

  [[nodiscard]] bool is_undecided() const { return is_undecided_; }

 private:
  static EnclosedChart<S> enclosed(const TangentChart& chart) {
    if constexpr (std::same_as<S, Interval>) {
      return chart.enclosed();
    } else {
      return chart.on<S>();
    }
  }
  [[nodiscard]] Vector<S, m> place(std::uint32_t j) const {
    Vector<S, m> result;
    for (std::size_t row = 0; row < m; ++row) result[row] = S(0);
    for (std::size_t axis = 0; axis < centre_.size(); ++axis) {
      const S offset = scalar_from<S>(charts_[j].data().centre[axis] - centre_[axis]);
      for (std::size_t row = 0; row < m; ++row) result[row] += chart_.at(axis, row) * offset;
    }
    return result;
  }
  /// Of the determinant.
  int sign(const Matrix<S, m>& columns) {
    Matrix<S, m> others = columns;
    std::rotate(others.begin(), others.begin() + 1, others.end());
    const auto result = sign_of(pairing(wedge<S, static_cast<std::size_t>(m)>(others), columns[0]));
    if (!result) is_undecided_ = true;
    return result.value_or(0);
  }

  const std::vector<TangentChart>& charts_;
  const std::vector<Rational>& centre_;
  EnclosedChart<S> chart_;
  bool is_undecided_ = false;
};

template <int m>
bool has_two_simplices_at_each_face(const std::vector<OtherLabels<m>>& star) {
  std::map<std::vector<std::uint32_t>, int> count;
  for (const OtherLabels<m>& others : star) {
    for (std::size_t apex = 0; apex < m; ++apex) {
      std::vector<std::uint32_t> face(others.begin(), others.end());
      face.erase(face.begin() + static_cast<std::ptrdiff_t>(apex));
      ++count[face];
    }
  }
  return std::all_of(count.begin(), count.end(), [](const auto& entry) { return entry.second == 2; });
}

template <int m>
std::optional<std::string> fault_of_star(const std::vector<TangentChart>& charts, std::uint32_t i,
                                         const std::vector<OtherLabels<m>>& star) {
  if (star.empty()) return "no simplices";
  if (!has_two_simplices_at_each_face<m>(star)) return "a face in other than two simplices";
  {
    const RoundingGuard guard;
    StarOnRung<Interval, m> enclosed(charts, i);
    auto fault = enclosed.fault(star);
    if (!enclosed.is_undecided()) return fault;
  }
  return StarOnRung<Rational, m>(charts, i).fault(star);
}

}  // namespace

template <int m>
std::vector<StarFailure> check_full_stars(const std::vector<TangentChart>& charts,
                                          const std::vector<LabelSimplex<m>>& simplices) {
  std::vector<std::vector<OtherLabels<m>>> stars(charts.size());
  for (const LabelSimplex<m>& simplex : simplices) {
    for (const std::uint32_t label : simplex) {
      OtherLabels<m> others;
      std::copy_if(simplex.begin(), simplex.end(), others.begin(), [label](std::uint32_t one) { return one != label; });
      stars[label].push_back(others);
    }
  }
  std::vector<StarFailure> result;
  for (std::uint32_t i = 0; i < stars.size(); ++i) {
    if (const auto fault = fault_of_star<m>(charts, i, stars[i]))
      result.push_back({Label(i), *fault, {Label(i)}, FailureCause::combinatorial});
  }
  return result;
}

template std::vector<StarFailure> check_full_stars<2>(const std::vector<TangentChart>&,
                                                      const std::vector<LabelSimplex<2>>&);
template std::vector<StarFailure> check_full_stars<3>(const std::vector<TangentChart>&,
                                                      const std::vector<LabelSimplex<3>>&);

}  // namespace delcert
