#include "kernel/theorems/glued_places.hpp"

#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/scalar.hpp"
#include "support/error.hpp"

namespace delcert {

template <int m>
GluedPlaces<m>::GluedPlaces(const FormulaAtlas<m>& atlas, const PointSet<m>& points)
    : places_(atlas.gluing().chart_count()) {
  const ChartGluing& gluing = atlas.gluing();
  for (auto& chart : places_) chart.resize(atlas.size());
  std::vector<Vector<Rational, m>> exact;
  for (std::uint32_t label = 0; label < atlas.size(); ++label) {
    home_.push_back(atlas.home_chart(Label(label)));
    exact.push_back(atlas.position(Label(label), points.exact(Label(label))));
  }
  const RoundingGuard guard;
  std::vector<PiecewiseCells> maps;
  for (const auto& transition : gluing.transitions()) maps.emplace_back(transition.pieces);
  for (std::uint32_t label = 0; label < atlas.size(); ++label) {
    Cell cell;
    Vector<Interval, m> here;
    for (std::size_t axis = 0; axis < m; ++axis) here[axis] = cell[axis] = scalar_from<Interval>(exact[label][axis]);
    places_[home_[label]][label] = here;
    for (std::size_t t = 0; t < maps.size(); ++t) {
      const auto& transition = gluing.transitions()[t];
      if (transition.from != home_[label]) continue;
      const MapOnCell found = maps[t].on(cell);
      if (found.is_excluded) continue;
      if (!found.is_regular || !is_inside(found.image, transition.pieces.front().box()))
        throw Undecided("level 5: whether chart " + gluing.chart(transition.to).name + " shows label " +
                        std::to_string(label));
      Vector<Interval, m> there;
      for (std::size_t axis = 0; axis < m; ++axis) there[axis] = found.image[axis];
      places_[transition.to][label] = there;
    }
  }
}

template class GluedPlaces<2>;
template class GluedPlaces<3>;

}  // namespace delcert
