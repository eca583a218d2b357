#include "kernel/manifold/submanifold/chart_fitting.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "kernel/manifold/submanifold/graph_check.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "kernel/parallel/parts.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// The slope is greater than needed by this: the more, the fewer cells, here and for whoever checks it.
constexpr std::array slope_slacks{1.6, 1.25};
constexpr double last_slack = 1.1;
/// Of these factors the narrow ones hold most balls of level 1 and few of level 2s.
constexpr std::size_t wide_factors = 3;
constexpr long slope_exponent = -8;
/// What is not so at all charts is mostly seen at some of them.
constexpr std::size_t most_suspects = 64;
constexpr std::size_t most_estimates = 1024;

/// ζ > |z₀| + 9Lϱ/16 by a little, with few digits.
Rational least_height(const Rational& radius, const Rational& slope) {
  const Rational needed =
      radius * slope * Rational(Integer(9), Integer(16)) * (Rational(1) + Rational::power_of_two(-6));
  return rounded_up(needed, binary_exponent(needed) - 6);
}

Rational eighths(const Rational& unit, int number) { return unit * Rational(Integer(number), Integer(8)); }

/// In doubles, how steep M and the level sets near it are in this chart, where the cone of this slope meets the rim of
/// the patch.
class SlopeEstimate {
 public:
  explicit SlopeEstimate(const ZeroSet& zero_set)
      : n_(zero_set.ambient()),
        m_(zero_set.dimension()),
        f_(zero_set.map()),
        x_(n_),
        value_(n_ - m_),
        derivative_((n_ - m_) * n_) {}

  double estimate(const TangentChart& chart, double radius, double slope) {
    const auto& enclosed = chart.enclosed();
    double result = 0;
    std::size_t directions = 1;
    for (std::size_t k = 0; k < m_; ++k) directions *= 3;
    for (std::size_t code = 0; code < directions; ++code) {
      std::vector<double> y(n_, 0);
      std::size_t rest = code;
      double length = 0;
      for (std::size_t k = 0; k < m_; ++k, rest /= 3) {
        y[k] = static_cast<double>(rest % 3) - 1;
        length += y[k] * y[k];
      }
      if (length == 0) continue;
      for (const double s : {0.5, 1.0}) {
        std::vector<double> at(n_, 0);
        for (std::size_t k = 0; k < m_; ++k) at[k] = y[k] * s * radius / std::sqrt(length);
        for (std::size_t b = m_; b < n_; ++b) {
          for (const double sign : {-1.0, 1.0}) {
            at[b] = sign * slope * radius * (2 * s + 7 * s * s) / 16;
            result = std::max(result, slope_at(enclosed, at) * 8 / (1 + 7 * s));
          }
          at[b] = 0;
        }
      }
    }
    return result;
  }

 private:
  double slope_at(const EnclosedChart<Interval>& chart, const std::vector<double>& y) {
    for (std::size_t axis = 0; axis < n_; ++axis) {
      x_[axis] = chart.centre[axis].lower();
      for (std::size_t k = 0; k < n_; ++k) x_[axis] += chart.at(axis, k).lower() * y[k];
    }
    if (!f_.first(x_.data(), value_.data(), derivative_.data())) return std::numeric_limits<double>::infinity();
    const std::size_t q = n_ - m_;
    Dense<double> entries(q * n_, 0);
    Dense<double> normal(q * q);
    for (std::size_t row = 0; row < q; ++row) {
      for (std::size_t column = 0; column < n_; ++column) {
        for (std::size_t axis = 0; axis < n_; ++axis)
          entries[row * n_ + column] += derivative_[row * n_ + axis] * chart.at(axis, column).lower();
        if (column >= m_) normal[row * q + column - m_] = entries[row * n_ + column];
      }
    }
    const auto inverse = inverse_of(std::move(normal), q);
    if (!inverse) return std::numeric_limits<double>::infinity();
    double result = 0;
    for (std::size_t row = 0; row < q; ++row) {
      for (std::size_t column = 0; column < m_; ++column) {
        double entry = 0;
        for (std::size_t b = 0; b < q; ++b) entry += (*inverse)[row * q + b] * entries[b * n_ + column];
        result += entry * entry;
      }
    }
    return std::sqrt(result);
  }

  std::size_t n_;
  std::size_t m_;
  FormulaEvaluation<double> f_;
  std::vector<double> x_;
  std::vector<double> value_;
  Dense<double> derivative_;
};

class Fitting {
 public:
  Fitting(const ZeroSet& zero_set, const std::vector<std::vector<Rational>>& centres, const SamplingRadii& radii,
          const Progress& progress)
      : zero_set_(zero_set), radii_(radii), progress_(progress) {
    in_parts(
        "make charts", centres.size(), progress,
        [&](std::size_t first, std::size_t last) {
          FormulaEvaluation<double> f(zero_set.map());
          std::vector<TangentChart> found;
          for (std::size_t at = first; at < last; ++at) found.push_back(tangent_chart(zero_set, f, centres[at]));
          return found;
        },
        [&](std::vector<TangentChart> found) {
          for (TangentChart& chart : found) charts_.push_back(std::move(chart));
        });
    for (std::size_t at = 0; at < charts_.size(); ++at) all_.push_back(at);
  }

  FittedCharts fit() {
    std::string reason;
    const auto found = [&](std::size_t first, std::size_t last, const auto& slacks) -> std::optional<FittedCharts> {
      for (std::size_t at = first; at < last; ++at) {
        const Rational factor = Rational(patch_quarters[at]) / Rational(4);
        for (const double slack : slacks) {
          if (auto slope = fitting_slope(factor, slack, reason))
            return FittedCharts{std::move(charts_), std::move(*slope), factor};
        }
      }
      return std::nullopt;
    };
    const std::array last_slacks{last_slack};
    if (auto charts = found(0, wide_factors, slope_slacks)) return *std::move(charts);
    if (auto charts = found(0, wide_factors, last_slacks)) return *std::move(charts);
    if (auto charts = found(wide_factors, patch_quarters.size(), slope_slacks)) return *std::move(charts);
    if (auto charts = found(patch_quarters.size() - 1, patch_quarters.size(), last_slacks)) return *std::move(charts);
    std::vector<std::vector<double>> places;
    for (const std::size_t label : failed_) places.push_back(place_of(label));
    throw TooCoarse(reason, std::move(places));
  }

 private:
  std::optional<Rational> fitting_slope(const Rational& patch, double slack, std::string& reason) {
    Rational slope;
    failed_.clear();
    if (!estimate(patch, slack, slope, reason)) return std::nullopt;
    std::vector<std::size_t> suspects = spread(most_suspects);
    while (slope <= Rational(1)) {
      auto failures = failing(suspects, patch, slope);
      if (failures.empty()) failures = failing(all_, patch, slope);
      if (failures.empty()) return slope;
      note(failures.front().first, failures.front().second.reason, reason);
      suspects.clear();
      failed_.clear();
      for (const auto& [label, failure] : failures) {
        failed_.push_back(label);
        suspects.push_back(label);
        if (failure.is_slope) continue;
        note(label, failure.reason, reason);
        return std::nullopt;
      }
      slope = rounded_up(slope * Rational(Integer(9), Integer(8)), slope_exponent);
    }
    return std::nullopt;
  }

  /// About so many labels, at most.
  [[nodiscard]] std::vector<std::size_t> spread(std::size_t most) const {
    std::vector<std::size_t> result;
    for (std::size_t at = 0; at < charts_.size(); at += charts_.size() / most + 1) result.push_back(at);
    return result;
  }

  /// A little more than the slope that all charts seem to need; false if it is above 1.
  bool estimate(const Rational& patch, double slack, Rational& slope, std::string& reason) {
    constexpr int rounds = 16;
    const std::vector<std::size_t> looked_at = spread(most_estimates);
    double needed = 0;
    for (int round = 0; round < rounds; ++round) {
      const double last = needed;
      std::size_t where = 0;
      in_parts(
          "estimate slopes", looked_at.size(), progress_,
          [&](std::size_t first, std::size_t end) {
            SlopeEstimate estimate(zero_set_);
            std::pair<double, std::size_t> most{0, looked_at[first]};
            for (std::size_t at = first; at < end; ++at) {
              const double radius = approximate_double(patch * radii_.of(looked_at[at]));
              const double found = slack * estimate.estimate(charts_[looked_at[at]], radius, last);
              if (found > most.first) most = {found, looked_at[at]};
            }
            return most;
          },
          [&](const std::pair<double, std::size_t>& found) {
            if (found.first > needed) {
              needed = found.first;
              where = found.second;
            }
          });
      if (!(needed <= 1)) {
        failed_.push_back(where);
        note(where, "its patch is steeper than 1", reason);
        return false;
      }
      if (needed <= last * 1.01) break;
    }
    slope = rounded_up(Rational::exactly(std::max(needed, 0x1p-8)), slope_exponent);
    return true;
  }

  std::vector<std::pair<std::size_t, GraphFailure>> failing(const std::vector<std::size_t>& labels,
                                                            const Rational& patch, const Rational& slope) {
    // Others may divide the cylinders otherwise.
    const Rational less = slope * (Rational(1) - Rational::power_of_two(-6));
    std::vector<std::pair<std::size_t, GraphFailure>> result;
    in_parts(
        "look at patches", labels.size(), progress_,
        [&](std::size_t first, std::size_t last) {
          GraphCheck check(zero_set_);
          std::vector<std::pair<std::size_t, GraphFailure>> found;
          for (std::size_t at = first; at < last; ++at) {
            TangentChart& chart = charts_[labels[at]];
            const Rational& unit = radii_.of(labels[at]);
            const Rational radius = patch * unit;
            const Rational least = least_height(radius, slope);
            std::vector high_lids{radius * Rational::power_of_two(-1), unit * Rational(Integer(13), Integer(8))};
            // Where they vary, discs of level 4 are larger, and lids have to be higher than these are wide.
            if (radii_.vary()) high_lids = {eighths(unit, 23), eighths(unit, 19), eighths(unit, 16), eighths(unit, 13)};
            chart.set_size(radius, least);
            if (auto failure = check.failure(chart, less)) {
              found.emplace_back(labels[at], std::move(*failure));
              continue;
            }
            // The higher, the fewer parts the box is divided into.
            for (const Rational& height : high_lids) {
              if (height <= least) break;
              chart.set_size(radius, height);
              if (check.may_be_as_high(chart)) break;
              chart.set_size(radius, least);
            }
          }
          return found;
        },
        [&](std::vector<std::pair<std::size_t, GraphFailure>> found) {
          result.insert(result.end(), found.begin(), found.end());
        });
    return result;
  }

  [[nodiscard]] std::vector<double> place_of(std::size_t label) const {
    std::vector<double> x;
    for (const Rational& coordinate : charts_[label].data().centre) x.push_back(approximate_double(coordinate));
    return x;
  }
  void note(std::size_t label, const std::string& what, std::string& reason) const {
    const std::vector<double> x = place_of(label);
    reason = zero_set_.description().name + ": label " + std::to_string(label) + " at " + rough_text(x) + ": " + what;
    const double advised = advised_radius(charts_[label], x);
    if (advised < approximate_double(radii_.of(label))) {
      char text[32];
      std::snprintf(text, sizeof text, "%.2g", advised);
      reason += ": there, by the curvature, a sampling radius of some " + std::string(text) + " would do";
    }
  }

  /// 1/(6κ), κ the norm of the second derivative of the graph at the centre: in doubles.
  double advised_radius(const TangentChart& chart, const std::vector<double>& x) const {
    const std::size_t n = zero_set_.ambient();
    const std::size_t m = zero_set_.dimension();
    const std::size_t q = n - m;
    FormulaEvaluation<double> f(zero_set_.map());
    std::vector<double> value(q);
    Dense<double> first(q * n);
    Dense<double> second(q * n * n);
    if (!f.second(x.data(), value.data(), first.data(), second.data())) return 0;
    const auto& enclosed = chart.enclosed();
    double squared = 0;
    for (std::size_t row = 0; row < q; ++row) {
      for (std::size_t k = 0; k < m; ++k) {
        for (std::size_t l = 0; l < m; ++l) {
          double entry = 0;
          for (std::size_t b = 0; b < q; ++b) {
            for (std::size_t a = 0; a < n; ++a) {
              for (std::size_t c = 0; c < n; ++c)
                entry += enclosed.preconditioner[row * q + b].lower() * second[(b * n + a) * n + c] *
                         enclosed.at(a, k).lower() * enclosed.at(c, l).lower();
            }
          }
          squared += entry * entry;
        }
      }
    }
    return 1 / (6 * std::sqrt(squared));
  }

  const ZeroSet& zero_set_;
  const SamplingRadii& radii_;
  const Progress& progress_;
  std::vector<TangentChart> charts_;
  std::vector<std::size_t> all_;
  std::vector<std::size_t> failed_;  // at what was last tried
};

}  // namespace

FittedCharts fit_charts(const ZeroSet& zero_set, const std::vector<std::vector<Rational>>& centres,
                        const SamplingRadii& radii, const Progress& progress) {
  if (radii.greatest() <= Rational(0)) throw InputError("the sampling radius is above 0");
  if (centres.empty()) throw InputError("a net has at least one point");
  return Fitting(zero_set, centres, radii, progress).fit();
}

Rational distortion_of_slope(const Rational& slope) {
  const Rational stretch = square_root_upper(Rational(1) + square(slope), 30) - Rational(1);
  return stretch <= Rational(0) ? Rational(0) : rounded_up(stretch, binary_exponent(stretch) - 10);
}

}  // namespace delcert
