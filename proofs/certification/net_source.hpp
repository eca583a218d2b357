#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "kernel/manifold/flat_space.hpp"
#include "kernel/manifold/gluing/metric_field.hpp"
#include "kernel/manifold/quotient/space_form.hpp"
#include "kernel/sample/atlas_net.hpp"
#include "kernel/sample/lattice_net.hpp"
#include "kernel/sample/poisson_disk.hpp"
#include "kernel/sample/submanifold_net.hpp"
#include "support/progress.hpp"

namespace delcert {

/// Where the points of a net come from.
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
  SizingRequest sizing;

  /// How densely a flat torus is to be sampled; none unless --sizing is given, with --radius. Throws InputError.
  template <int m>
  [[nodiscard]] std::optional<TorusSizing<m>> torus_sizing(const FlatSpace<m>& space) const;

  /// Makes or reads the points; with a triangulation of them if one comes for free, and without simplices otherwise.
  /// Throws what sampling and reading throw.
  template <int m>
  [[nodiscard]] TriangulatedNet<m> net(const FlatSpace<m>& space, const Progress& progress) const;

  /// The same on a space form: conformal coordinates, and the radius in which the run is measured: that of the
  /// Poisson-disk net, the nominal one of given points, otherwise about the covering radius.
  template <int m>
  [[nodiscard]] std::pair<std::vector<Vector<Rational, m>>, Rational> net_of(const SpaceForm& form,
                                                                             const Progress& progress) const;

  /// The same on a metric field: coordinates of the torus. --radius is given, with a file of points as the nominal one.
  template <int m>
  [[nodiscard]] std::vector<Vector<Rational, m>> centres(const MetricField<m>& field, const Progress& progress) const;

  /// The same on charts that are glued; a file of points has, a line, the number of a chart, from 0 on, and coordinates
  /// in it.
  template <int m>
  [[nodiscard]] std::vector<NetPlace<m>> places(const ChartGluing& gluing, const Progress& progress) const;

  /// The same on a submanifold: a sampling that is still to be completed. --radius is given. None for a file of points.
  template <int m>
  [[nodiscard]] std::unique_ptr<SubmanifoldSampling<m>> sampling(const EmbeddedManifold& embedded,
                                                                 const Progress& progress) const;
  /// Charts about the centres in a file of points, in the coordinates of the space around; they cover the manifold.
  template <int m>
  [[nodiscard]] SubmanifoldNet<m> charts(const EmbeddedManifold& embedded, const Progress& progress) const;

 private:
  /// Throws InputError if radii are to vary: on other manifolds they do not.
  void refuse_sizing() const;
  /// Throws InputError, with what they are not for, if other nets are asked for than of a radius or of a file.
  void require_radius_or_file(const char* manifolds) const;
  /// Throws InputError, which names the sources of a net, unless --radius is given and positive.
  void require_radius(const char* sources) const;
};

}  // namespace delcert
