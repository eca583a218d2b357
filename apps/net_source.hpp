#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <utility>

#include "kernel/manifold/flat_space.hpp"
#include "kernel/manifold/gluing/metric_field.hpp"
#include "kernel/manifold/quotient/space_form.hpp"
#include "kernel/sample/lattice_net.hpp"
#include "kernel/sample/submanifold_net.hpp"
#include "support/progress.hpp"

namespace delcert {

/// Where the points of a net come from: options that several subcommands share.
struct NetSource {
  std::string manifold;
  std::optional<Rational> radius;
  std::string points_file;
  std::optional<std::uint32_t> lattice;
  bool centred = false;
  std::optional<unsigned> displacement_exponent;
  std::optional<std::uint32_t> icosphere_frequency;
  std::uint32_t relaxation_steps = 0;
  std::uint64_t seed = 0;

  /// Adds --manifold, --radius, --points (if `with_file`), --lattice, --centred, --displace, --icosphere, --relax,
  /// --seed.
  void add_options(CLI::App& command, bool with_file);

  /// Makes or reads the points. Throws what sampling and reading throw.
  template <int m>
  [[nodiscard]] std::vector<Vector<Rational, m>> points(const FlatSpace<m>& space, const Progress& progress) const;

  /// The same on a space form: conformal coordinates, and the radius in which the run is measured: that of the
  /// Poisson-disk net, the nominal one of given points, otherwise about the covering radius.
  template <int m>
  [[nodiscard]] std::pair<std::vector<Vector<Rational, m>>, Rational> net_of(const SpaceForm& form,
                                                                             const Progress& progress) const;

  /// The same on a metric field: coordinates of the torus. --radius is given, with a file of points as the nominal one.
  template <int m>
  [[nodiscard]] std::vector<Vector<Rational, m>> centres(const MetricField<m>& field, const Progress& progress) const;

  /// The same on a submanifold: charts about points near it, which have passed and cover it. --radius is given; a file
  /// of points has centres of charts, in the coordinates of the space around.
  template <int m>
  [[nodiscard]] SubmanifoldNet<m> charts(const ZeroSet& zero_set, const Progress& progress) const;

 private:
  /// Throws InputError, which names the sources of a net, unless --radius is given and positive.
  void require_radius(const char* sources) const;
};

}  // namespace delcert
