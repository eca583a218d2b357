#include "kernel/stars/local_ball.hpp"

#include <algorithm>
#include <numeric>

#include "kernel/number/elementary.hpp"
#include "kernel/simplex/dimensions.hpp"

namespace delcert {

namespace {

Filter enclosure_of(const Filter& x) { return x; }
Filter enclosure_of(const BigInterval& x) { return in_doubles(x); }
Filter enclosure_of(const Rational& x) { return scalar_from<Filter>(x); }

template <int m>
class Look {
 public:
  /// Precondition of all but `above_filter`: a `FilterGuard` is alive.
  Look(const ChartView<m>& view, LocalCoordinates coordinates, const PlaceSimplex<m>& simplex)
      : view_(view), coordinates_(coordinates), simplex_(simplex) {
    is_curved_ = coordinates == LocalCoordinates::conformal && view.geometry().curvature != Curvature::zero;
  }

  /// Points whose coordinates alone say that they are farther than `look_beyond` from the ball are not looked at.
  void on_filter(double look_beyond) {
    const auto& metric = view_.filter_metric();
    SphereStack<Filter, m> stack(metric);
    const auto vertices = vertices_in<Filter>();
    if (!is_proved(build_spheres<Filter, m>(stack, metric, vertices, m))) {
      rest_.resize(view_.size());
      std::iota(rest_.begin(), rest_.end(), std::size_t{0});
      needs_ball_ = true;
      return;
    }
    take_ball(stack, vertices[0]);
    const Filter radius = square_root(result_.squared_radius);
    const Filter beyond = Filter::exactly(look_beyond);
    find_near((radius + beyond).upper());
    for (const std::uint32_t at : near_) {
      if (is_corner(at)) continue;
      const auto& position = view_.position(coordinates_, at);
      const auto offset = difference(position, vertices[0]);
      const Filter power = stack.power(offset, metric.squared_norm(offset));
      if (is_proved(less(Filter(0), power))) {
        include(weighed(power, position), at);
      } else {
        rest_.push_back(at);
      }
    }
    std::sort(rest_.begin(), rest_.end());
    Filter most_deviation(1);
    if (is_curved_) {
      for (std::size_t at = 0; at < view_.size(); ++at)
        most_deviation = maximum(most_deviation, deviation(view_.position(coordinates_, at)));
    }
    // |q − C|² − R² for |q − C| = R + s.
    include(beyond * (beyond + twice(radius)) / (Filter(2) * most_deviation), view_.size());
  }

  /// What the filter left over, on another rung; undecided points remain in rest_.
  template <class S>
  [[nodiscard]] Verdict above_filter() {
    const auto metric = view_.atlas().metric().template on<S>();
    SphereStack<S, m> stack(metric);
    const auto vertices = vertices_in<S>();
    if (const Verdict ok = build_spheres<S, m>(stack, metric, vertices, m); !is_proved(ok)) {
      result_.witness = view_.size();
      return ok;
    }
    if (needs_ball_) {
      const FilterGuard guard;
      take_ball(stack, vertices[0]);
      needs_ball_ = false;
    }
    std::vector<std::size_t> undecided;
    for (const std::size_t at : rest_) {
      if (is_corner(at)) continue;
      const auto position = view_.template position_in<S>(coordinates_, at);
      const auto offset = difference(position, vertices[0]);
      const S power = stack.power(offset, metric.squared_norm(offset));
      const Verdict outside = less(S(0), power);
      if (is_refuted(outside)) {
        result_.witness = at;
        return outside;
      }
      if (is_proved(outside)) {
        const FilterGuard guard;
        include(enclosure_of(weighed(power, position)), at);
      } else {
        undecided.push_back(at);
      }
    }
    rest_ = std::move(undecided);
    if (rest_.empty()) return Verdict::proved;
    result_.witness = rest_.front();
    return Verdict::undecided;
  }

  [[nodiscard]] bool is_done() const { return rest_.empty(); }
  [[nodiscard]] LocalBall<m>& result() { return result_; }

 private:
  template <class S>
  LocalVertices<S, m> vertices_in() const {
    LocalVertices<S, m> result;
    for (std::size_t corner = 0; corner <= m; ++corner) {
      if constexpr (std::same_as<S, Filter>) {
        result[corner] = view_.position(coordinates_, simplex_[corner]);
      } else {
        result[corner] = view_.template position_in<S>(coordinates_, simplex_[corner]);
      }
    }
    return result;
  }

  template <class S>
  void take_ball(const SphereStack<S, m>& stack, const Vector<S, m>& first) {
    const auto centre = sum(first, stack.centre());
    for (std::size_t axis = 0; axis < m; ++axis) result_.centre[axis] = enclosure_of(centre[axis]);
    result_.squared_radius = enclosure_of(stack.squared_radius());
  }

  [[nodiscard]] bool is_corner(std::size_t at) const {
    return std::find(simplex_.begin(), simplex_.end(), at) != simplex_.end();
  }
  /// The points that may be within this distance of the centre; in a frame that is not Cartesian, all.
  void find_near(double distance) {
    if (!view_.filter_metric().is_cartesian()) {
      near_.resize(view_.size());
      std::iota(near_.begin(), near_.end(), std::uint32_t{0});
      return;
    }
    Vector<double, m> lowest;
    Vector<double, m> highest;
    for (std::size_t axis = 0; axis < m; ++axis) {
      lowest[axis] = (Filter::exactly(result_.centre[axis].lower()) - Filter::exactly(distance)).lower();
      highest[axis] = (Filter::exactly(result_.centre[axis].upper()) + Filter::exactly(distance)).upper();
    }
    view_.meeting(coordinates_, lowest, highest, near_);
  }

  template <class S>
  [[nodiscard]] S deviation(const Vector<S, m>& position) const {
    return S(1) + detail::conformal_deviation(view_.geometry().curvature, position);
  }
  template <class S>
  [[nodiscard]] S weighed(const S& power, const Vector<S, m>& position) const {
    return is_curved_ ? S(power / (S(2) * deviation(position))) : S(power / S(2));
  }
  void include(const Filter& power, std::size_t at) {
    if (!has_power_ || power.lower() < result_.least_power.lower()) result_.nearest = at;
    result_.least_power = has_power_ ? minimum(result_.least_power, power) : power;
    has_power_ = true;
  }

  const ChartView<m>& view_;
  LocalCoordinates coordinates_;
  const PlaceSimplex<m>& simplex_;
  bool is_curved_ = false;
  bool needs_ball_ = false;
  bool has_power_ = false;
  std::vector<std::uint32_t> near_;
  std::vector<std::size_t> rest_;
  LocalBall<m> result_;
};

}  // namespace

template <int m>
LocalBall<m> look_at_ball(const ChartView<m>& view, LocalCoordinates coordinates, const PlaceSimplex<m>& simplex,
                          double look_beyond) {
  Look<m> look(view, coordinates, simplex);
  {
    const FilterGuard guard;
    look.on_filter(look_beyond);
  }
  ladder_statistics().count(Rung::interval, view.size());
  LocalBall<m>& result = look.result();
  if (look.is_done()) {
    result.empty = Verdict::proved;
    return result;
  }
  Ladder ladder;
  ladder.ask_in_bits(128, 1024, [&look] { return look.template above_filter<BigInterval>(); });
  if (view.atlas().has_exact_transitions())
    ladder.ask(Rung::rational, [&look] { return look.template above_filter<Rational>(); });
  result.empty = ladder.finish();
  return result;
}

#define DELCERT_INSTANTIATE(m) \
  template LocalBall<m> look_at_ball<m>(const ChartView<m>&, LocalCoordinates, const PlaceSimplex<m>&, double);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
