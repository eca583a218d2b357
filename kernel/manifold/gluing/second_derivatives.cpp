#include "kernel/manifold/gluing/second_derivatives.hpp"

#include <algorithm>

namespace delcert {

template <int m>
bool second_derivatives(FormulaEvaluation<Interval>& map, const Cell& box, std::size_t parts_of_side,
                        std::array<Interval, static_cast<std::size_t>(m* m* m)>& out) {
  const std::size_t parts = m == 2 ? parts_of_side * parts_of_side : parts_of_side * parts_of_side * parts_of_side;
  std::array<Interval, static_cast<std::size_t>(m)> ignored;
  std::array<Interval, static_cast<std::size_t>(m * m)> first;
  std::array<Interval, static_cast<std::size_t>(m * m * m)> second;
  for (std::size_t part = 0; part < parts; ++part) {
    Cell cell;
    std::size_t rest = part;
    for (std::size_t axis = 0; axis < m; ++axis) {
      const Interval from = Interval::exactly(box[axis].lower());
      const Interval step = (Interval::exactly(box[axis].upper()) - from) / Interval(static_cast<int>(parts_of_side));
      const auto at = static_cast<int>(rest % parts_of_side);
      rest /= parts_of_side;
      cell[axis] = Interval::between((from + Interval(at) * step).lower(), (from + Interval(at + 1) * step).upper());
    }
    if (!map.second(cell.data(), ignored.data(), first.data(), second.data())) return false;
    for (std::size_t k = 0; k < out.size(); ++k) {
      out[k] = part == 0 ? second[k]
                         : Interval::between(std::min(out[k].lower(), second[k].lower()),
                                             std::max(out[k].upper(), second[k].upper()));
    }
  }
  return true;
}

template bool second_derivatives<2>(FormulaEvaluation<Interval>&, const Cell&, std::size_t, std::array<Interval, 8>&);
template bool second_derivatives<3>(FormulaEvaluation<Interval>&, const Cell&, std::size_t, std::array<Interval, 27>&);

}  // namespace delcert
