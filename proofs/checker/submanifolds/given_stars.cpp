#include <algorithm>
#include <map>

#include "proofs/checker/arithmetic/square_matrix.hpp"
#include "proofs/checker/levels/levels.hpp"
#include "proofs/checker/submanifolds/tangent_charts.hpp"

namespace delcert::checker {
namespace {

/// The star of one label, straight in its chart; all is exact.
class GivenStar {
 public:
  GivenStar(const Certificate& c, Label i) : c_(c), i_(i), chart_(tangent_chart(c, i)) {}

  /// Each face at i has its two simplices on different sides.
  bool has_sides() {
    std::map<std::vector<Label>, int> sides;  // of each face, the side of the first simplex with it
    for (std::size_t s = 0; s < c_.star_size(i_); ++s) {
      const Label* others = c_.star_simplex(i_, s);
      for (int apex = 0; apex < c_.m; ++apex) {
        std::vector<Label> face;
        for (int k = 0; k < c_.m; ++k) {
          if (k != apex) face.push_back(others[k]);
        }
        std::vector<Matrix<Rational>> columns;
        for (const Label j : face) columns.push_back(place(j));
        columns.push_back(place(others[apex]));
        const int side = sign_of(columns);
        const auto [at, is_new] = sides.try_emplace(face, side);
        if (side == 0 || (!is_new && at->second == side)) return false;
      }
    }
    return true;
  }

  /// Of the simplices only the first one has the ray through its barycentre.
  bool has_ray() {
    Matrix<Rational> ray(c_.m_size(), 1);
    for (int k = 0; k < c_.m; ++k) ray = ray + place(c_.star_simplex(i_, 0)[k]);
    for (std::size_t s = 1; s < c_.star_size(i_); ++s) {
      std::vector<Matrix<Rational>> columns;
      for (int k = 0; k < c_.m; ++k) columns.push_back(place(c_.star_simplex(i_, s)[k]));
      const int orientation = sign_of(columns);
      bool misses = false;
      for (std::size_t k = 0; k < columns.size(); ++k) {
        std::vector<Matrix<Rational>> exchanged = columns;
        exchanged[k] = ray;
        misses = misses || sign_of(exchanged) * orientation < 0;
      }
      if (!misses) return false;
    }
    return true;
  }

 private:
  const Matrix<Rational>& place(Label j) {
    const auto [at, is_new] = places_.try_emplace(j);
    if (is_new) {
      Matrix<Rational> offset(chart_.centre.rows(), 1);
      for (std::size_t k = 0; k < offset.size(); ++k)
        offset[k] = exact_value(c_.net_text[j * offset.size() + k]) - chart_.centre[k];
      at->second = transposed_times(chart_.tangent, offset);
    }
    return at->second;
  }
  int sign_of(const std::vector<Matrix<Rational>>& columns) const {
    Budget::spend(1000);
    SquareMatrix<Rational> matrix(columns.size());
    for (std::size_t k = 0; k < columns.size(); ++k) {
      for (std::size_t a = 0; a < columns.size(); ++a) matrix(a, k) = columns[k][a];
    }
    return matrix.leading_minor(columns.size()).sign();
  }

  const Certificate& c_;
  Label i_;
  TangentChart<Rational> chart_;
  std::map<Label, Matrix<Rational>> places_;
};

}  // namespace

std::string check_given_stars(const Certificate& c, Report& report) {
  for (Label i = 0; i < c.n; ++i) {
    check_facets(c, i, report, "1f.facets");
    GivenStar star(c, i);
    const auto reject = [&](const char* rule, const char* what) {
      report.reject(rule, [&] { return "in its chart the star of " + std::to_string(i) + what; });
    };
    if (!star.has_sides()) {
      reject("1f.sides", " has two simplices on the same side of a face, or a flat one");
    } else if (!star.has_ray()) {
      reject("1f.ray", " goes around it more than once");
    }
  }
  return std::to_string(c.n) + " stars, straight in the charts of their labels, are embedded and full";
}

}  // namespace delcert::checker
