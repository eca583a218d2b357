#include "apps/net_source.hpp"

#include "apps/exact_option.hpp"
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

void NetSource::add_options(CLI::App& command, bool with_file) {
  command.add_option("--manifold", manifold, "A built-in manifold, or a manifold file")->required();
  add_exact_option(command, "--radius", radius, "Poisson-disk net of this radius; with a given net its nominal radius");
  CLI::Option* lattice_option =
      command.add_option("--lattice", lattice, "The multiples of 1/N in every frame coordinate as the net")
          ->type_name("N");
  command.add_flag("--centred", centred, "With --lattice: the centres of its cells too (bcc in a cubic frame)")
      ->needs(lattice_option);
  command.add_option("--displace", displacement_exponent, "With --lattice: move every coordinate by ±2^-K")
      ->type_name("K")
      ->needs(lattice_option);
  if (with_file) {
    command.add_option("--points", points_file, "A file of points, one a line in frame coordinates")
        ->type_name("FILE")
        ->excludes(lattice_option);
  }
  command
      .add_option("--icosphere", icosphere_frequency,
                  "On sphere-2: the icosahedron, its faces divided by F, as the net")
      ->type_name("F")
      ->excludes(lattice_option);
  command.add_option("--relax", relaxation_steps, "Space forms: so many of Lloyd's steps for the net (default 0)")
      ->type_name("STEPS");
  command.add_option("--seed", seed, "Seed of all random choices (default 0)")->type_name("INTEGER");
}

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

template <int m>
std::vector<Vector<Rational, m>> NetSource::points(const FlatSpace<m>& space, const Progress& progress) const {
  if (icosphere_frequency) throw InputError("--icosphere is for the manifold sphere-2");
  if (relaxation_steps > 0) throw InputError("--relax is for space forms other than tori");
  if (!points_file.empty()) return points_of_file<m>(points_file);
  if (lattice) return lattice_net<m>(space, LatticeNet{*lattice, centred, displacement_exponent, seed});
  require_radius("--radius, --lattice or --points");
  return poisson_disk_net<m>(space, *radius, seed, progress);
}

template <int m>
std::pair<std::vector<Vector<Rational, m>>, Rational> NetSource::net_of(const SpaceForm& form,
                                                                        const Progress& progress) const {
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
  if (lattice || icosphere_frequency || relaxation_steps > 0)
    throw InputError("--lattice, --icosphere and --relax are not for metric fields: give --radius or --points");
  require_radius("--radius, or with it --points");
  if (!points_file.empty()) return points_of_file<m>(points_file);
  return metric_field_net<m>(field, *radius, seed, progress).centres;
}

template <int m>
SubmanifoldNet<m> NetSource::charts(const ZeroSet& zero_set, const Progress& progress) const {
  if (lattice || icosphere_frequency || relaxation_steps > 0)
    throw InputError("--lattice, --icosphere and --relax are not for submanifolds: give --radius or --points");
  require_radius("--radius, or with it --points");
  if (points_file.empty()) return submanifold_net<m>(zero_set, *radius, seed, progress);
  SubmanifoldNet<m> result;
  result.centres = read_points(points_file, Dimension(static_cast<int>(zero_set.ambient())));
  result.charts = fit_charts(zero_set, result.centres, *radius, progress);
  result.parts = require_cover(zero_set, result.charts.charts, progress);
  return result;
}

template SubmanifoldNet<2> NetSource::charts<2>(const ZeroSet&, const Progress&) const;
template SubmanifoldNet<3> NetSource::charts<3>(const ZeroSet&, const Progress&) const;
template std::vector<Vector<Rational, 2>> NetSource::centres<2>(const MetricField<2>&, const Progress&) const;
template std::vector<Vector<Rational, 3>> NetSource::centres<3>(const MetricField<3>&, const Progress&) const;
template std::pair<std::vector<Vector<Rational, 2>>, Rational> NetSource::net_of<2>(const SpaceForm&,
                                                                                    const Progress&) const;
template std::pair<std::vector<Vector<Rational, 3>>, Rational> NetSource::net_of<3>(const SpaceForm&,
                                                                                    const Progress&) const;

#define DELCERT_INSTANTIATE(m) \
  template std::vector<Vector<Rational, m>> NetSource::points<m>(const FlatSpace<m>&, const Progress&) const;
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
