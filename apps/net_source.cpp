#include "apps/net_source.hpp"

#include "apps/exact_option.hpp"
#include "kernel/error.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/sample/point_file.hpp"
#include "kernel/sample/poisson_disk.hpp"
#include "kernel/simplex/dimensions.hpp"

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
  command.add_option("--seed", seed, "Seed of all random choices (default 0)")->type_name("INTEGER");
}

template <int m>
std::vector<Vector<Rational, m>> NetSource::points(const FlatSpace<m>& space, const Progress& progress) const {
  if (!points_file.empty()) {
    std::vector<Vector<Rational, m>> result;
    for (const auto& point : read_points(points_file, Dimension(m))) {
      result.emplace_back();
      std::copy(point.begin(), point.end(), result.back().begin());
    }
    return result;
  }
  if (lattice) return lattice_net<m>(space, LatticeNet{*lattice, centred, displacement_exponent, seed});
  if (!radius) throw InputError("no net: give --radius, --lattice or --points");
  if (*radius <= Rational(0)) throw InputError("--radius " + exact_text(*radius) + " is not above 0");
  return poisson_disk_net<m>(space, *radius, seed, progress);
}

#define DELCERT_INSTANTIATE(m) \
  template std::vector<Vector<Rational, m>> NetSource::points<m>(const FlatSpace<m>&, const Progress&) const;
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
