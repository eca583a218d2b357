#include "proofs/certification/net_source.hpp"

#include "kernel/manifold/quotient/patch_size.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/sample/icosphere.hpp"
#include "kernel/sample/metric_field_net.hpp"
#include "kernel/sample/point_file.hpp"
#include "kernel/sample/poisson_disk.hpp"
#include "kernel/sample/space_form_net.hpp"
#include "kernel/simplex/dimensions.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

template <int m>
std::vector<Vector<Rational, m>> points_of_file(const std::string& file) {
  std::vector<Vector<Rational, m>> result;
  for (const auto& point : read_points(file, Dimension(m))) {
    result.emplace_back();
    std::copy(point.begin(), point.end(), result.back().begin());
  }
  return result;
}

/// A little above the covering radius, in 12 binary digits.
Rational radius_above(double covering_radius) {
  const Rational radius = Rational::exactly(covering_radius) * (Rational(1) + Rational::power_of_two(-20));
  return rounded_up(radius, binary_exponent(radius) - 11);
}

}  // namespace

void NetSource::require_radius(const char* sources) const {
  if (!radius) throw InputError(std::string("no net: give ") + sources);
  if (*radius <= Rational(0)) throw InputError("--radius " + exact_text(*radius) + " is not above 0");
}

void NetSource::require_radius_or_file(const char* manifolds) const {
  if (lattice || icosphere_frequency || relaxation_steps > 0)
    throw InputError(std::string("--lattice, --icosphere and --relax are not for ") + manifolds +
                     ": give --radius or --points");
  require_radius("--radius, or with it --points");
}

void NetSource::refuse_sizing() const {
  if (!sizing.text.empty()) throw InputError("--sizing is for flat tori and submanifolds");
}

template <int m>
std::optional<TorusSizing<m>> NetSource::torus_sizing(const FlatSpace<m>& space) const {
  if (sizing.text.empty()) return std::nullopt;
  require_radius("--radius, the greatest radius of --sizing");
  return delcert::torus_sizing<m>(sizing, space, approximate_double(*radius));
}

template <int m>
TriangulatedNet<m> NetSource::net(const FlatSpace<m>& space, const Progress& progress) const {
  if (icosphere_frequency) throw InputError("--icosphere is for the manifold sphere-2");
  if (relaxation_steps > 0) throw InputError("--relax is for space forms other than tori");
  if (!points_file.empty()) return {points_of_file<m>(points_file), {}};
  if (lattice) return {lattice_net<m>(space, LatticeNet{*lattice, centred, displacement_exponent, seed}), {}};
  require_radius("--radius, --lattice or --points");
  if (const auto radii = torus_sizing<m>(space)) return {poisson_disk_net<m>(space, *radii, seed, progress), {}};
  auto result = triangulated_poisson_disk_net<m>(space, *radius, seed, progress);
  // Beyond the rim of a ball, simplices are so flat that they are rather taken from displaced points.
  if (!space.is_torus()) result.simplices.clear();
  return result;
}

template <int m>
std::pair<std::vector<Vector<Rational, m>>, Rational> NetSource::net_of(const SpaceForm& form,
                                                                        const Progress& progress) const {
  refuse_sizing();
  if (lattice) throw InputError("--lattice is for tori and balls; on a space form give --radius or --points");
  SpaceFormNet<m> net;
  if (icosphere_frequency) {
    if constexpr (m == 2) {
      if (form.form().curvature() != Curvature::positive || !form.description.generators.empty())
        throw InputError("--icosphere is for the manifold sphere-2");
      // The farthest point is in a face: of the 20f² faces none is much larger than its share of the icosahedron's.
      net = measured_net<m>(form, icosphere(*icosphere_frequency),
                            Rational(Integer(4), Integer(5 * *icosphere_frequency)));
    } else {
      throw InputError("--icosphere is for the manifold sphere-2");
    }
  } else {
    require_radius("--radius, or with it --points");
    if (points_file.empty()) {
      // A radius that is refused later is refused before there is a net, with the radius to take.
      (void)fitting_patch_factor(form, m, *radius);
      net = space_form_net<m>(form, *radius, seed, progress);
    } else {
      net.centres = points_of_file<m>(points_file);
    }
    if (relaxation_steps == 0) return {std::move(net.centres), *radius};
  }
  if (relaxation_steps > 0) {
    const Rational about = radius ? *radius : radius_above(net.covering_radius);
    net = relaxed_net<m>(form, net.centres, about, relaxation_steps, progress);
  }
  return {std::move(net.centres), radius_above(net.covering_radius)};
}

template <int m>
std::vector<Vector<Rational, m>> NetSource::centres(const MetricField<m>& field, const Progress& progress) const {
  refuse_sizing();
  require_radius_or_file("metric fields");
  if (!points_file.empty()) return points_of_file<m>(points_file);
  return metric_field_net<m>(field, *radius, seed, progress).centres;
}

template <int m>
std::vector<NetPlace<m>> NetSource::places(const ChartGluing& gluing, const Progress& progress) const {
  refuse_sizing();
  require_radius_or_file("atlases");
  if (points_file.empty()) return atlas_net<m>(gluing, *radius, seed, progress).places;
  std::vector<NetPlace<m>> result;
  for (const auto& line : read_points(points_file, Dimension(m + 1))) {
    std::size_t chart = 0;
    while (chart < gluing.chart_count() && line[0] != Rational(Integer(chart))) ++chart;
    if (chart == gluing.chart_count())
      throw InputError(points_file + ": point " + std::to_string(result.size()) + ": no chart has the number " +
                       exact_text(line[0]));
    result.push_back({chart, {}});
    std::copy(line.begin() + 1, line.end(), result.back().x.begin());
  }
  return result;
}

template std::vector<NetPlace<2>> NetSource::places<2>(const ChartGluing&, const Progress&) const;
template std::vector<NetPlace<3>> NetSource::places<3>(const ChartGluing&, const Progress&) const;

template <int m>
std::unique_ptr<SubmanifoldSampling<m>> NetSource::sampling(const EmbeddedManifold& embedded,
                                                            const Progress& progress) const {
  require_radius_or_file("submanifolds");
  if (!points_file.empty()) return nullptr;
  Sizing e = sizing_of(sizing, embedded, approximate_double(*radius), seed, progress);
  return std::make_unique<SubmanifoldSampling<m>>(embedded, *radius, std::move(e), seed);
}

template <int m>
SubmanifoldNet<m> NetSource::charts(const EmbeddedManifold& embedded, const Progress& progress) const {
  SubmanifoldNet<m> result;
  result.centres = read_points(points_file, Dimension(static_cast<int>(embedded.ambient())));
  result.radii = *radius;
  if (!sizing.text.empty()) {
    const Sizing e = sizing_of(sizing, embedded, approximate_double(*radius), seed, progress);
    std::vector<double> radii;
    for (const auto& centre : result.centres) {
      std::vector<double> x;
      for (const Rational& coordinate : centre) x.push_back(approximate_double(coordinate));
      radii.push_back(e.at(x.data()));
    }
    result.radii = SamplingRadii(radii);
  }
  result.charts = embedded.fit_charts(result.centres, result.radii, progress);
  result.parts = require_cover(embedded, result.charts.charts, progress);
  return result;
}

template std::unique_ptr<SubmanifoldSampling<1>> NetSource::sampling<1>(const EmbeddedManifold&, const Progress&) const;
template std::unique_ptr<SubmanifoldSampling<2>> NetSource::sampling<2>(const EmbeddedManifold&, const Progress&) const;
template std::unique_ptr<SubmanifoldSampling<3>> NetSource::sampling<3>(const EmbeddedManifold&, const Progress&) const;
template SubmanifoldNet<1> NetSource::charts<1>(const EmbeddedManifold&, const Progress&) const;
template SubmanifoldNet<2> NetSource::charts<2>(const EmbeddedManifold&, const Progress&) const;
template SubmanifoldNet<3> NetSource::charts<3>(const EmbeddedManifold&, const Progress&) const;
template std::vector<Vector<Rational, 2>> NetSource::centres<2>(const MetricField<2>&, const Progress&) const;
template std::vector<Vector<Rational, 3>> NetSource::centres<3>(const MetricField<3>&, const Progress&) const;
template std::pair<std::vector<Vector<Rational, 2>>, Rational> NetSource::net_of<2>(const SpaceForm&,
                                                                                    const Progress&) const;
template std::pair<std::vector<Vector<Rational, 3>>, Rational> NetSource::net_of<3>(const SpaceForm&,
                                                                                    const Progress&) const;

#define DELCERT_INSTANTIATE(m)                                                                  \
  template std::optional<TorusSizing<m>> NetSource::torus_sizing<m>(const FlatSpace<m>&) const; \
  template TriangulatedNet<m> NetSource::net<m>(const FlatSpace<m>&, const Progress&) const;
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
