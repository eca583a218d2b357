#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

#include "kernel/manifold/any_manifold.hpp"
#include "kernel/manifold/flat_space.hpp"
#include "kernel/sample/net_measure.hpp"
#include "kernel/sample/poisson_disk.hpp"
#include "kernel/sample/separation.hpp"
#include "proofs/certificate/content.hpp"
#include "proofs/certificate/flat_claims.hpp"

namespace delcert {

/// A certified run on the square torus with some 400 points, made once.
struct SmallRun {
  ManifoldDescription manifold = find_manifold("torus-2");
  FlatSpace<2> space = flat_space_of<2>(manifold);
  PointSet<2> net{poisson_disk_net<2>(space, radius(), 1, no_progress())};
  NetDensity<2> density = measure_density<2>(space, net, radius(), no_progress());
  FlatAtlas<2> atlas{space, net, density.sampling_radius};
  RunParameters parameters = parameters_for(Dimension(2), measure_separation<2>(atlas), {});
  RunResult<2> run = run_algorithm<2>(atlas, parameters.algorithm, {}, no_progress());

  static Rational radius() { return Rational(Integer(1), Integer(24)); }

  [[nodiscard]] Claims claims(const LevelSelection& levels = all_levels()) const {
    std::vector<std::string> reasons;
    return derive_claims<2>(atlas, parameters, run, levels, no_progress(), reasons);
  }
  void write(const std::filesystem::path& path, const Claims& some, const ManifoldDescription& described) const {
    write_certificate<2>(path, content_of<2>(described, atlas, density.simplices, parameters, run, some));
  }
  void write(const std::filesystem::path& path) const { write(path, claims(), manifold); }
};

[[nodiscard]] inline const SmallRun& small_run() {
  static const SmallRun run;
  return run;
}

[[nodiscard]] inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace delcert
