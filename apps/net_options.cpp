#include "apps/net_options.hpp"

#include <CLI/CLI.hpp>

#include "apps/exact_option.hpp"

namespace delcert {

void add_net_options(CLI::App& command, NetSource& source, bool with_file) {
  command.add_option("--manifold", source.manifold, "A built-in manifold, or a manifold file")->required();
  add_exact_option(command, "--radius", source.radius,
                   "Poisson-disk net of this radius; with a given net its nominal radius");
  CLI::Option* lattice_option =
      command.add_option("--lattice", source.lattice, "The multiples of 1/N in every frame coordinate as the net")
          ->type_name("N");
  command.add_flag("--centred", source.centred, "With --lattice: the centres of its cells too (bcc in a cubic frame)")
      ->needs(lattice_option);
  command.add_option("--displace", source.displacement_exponent, "With --lattice: move every coordinate by ±2^-K")
      ->type_name("K")
      ->needs(lattice_option);
  if (with_file) {
    command.add_option("--points", source.points_file, "A file of points, one a line in frame coordinates")
        ->type_name("FILE")
        ->excludes(lattice_option);
  }
  command
      .add_option("--icosphere", source.icosphere_frequency,
                  "On sphere-2: the icosahedron, its faces divided by F, as the net")
      ->type_name("F")
      ->excludes(lattice_option);
  command
      .add_option("--relax", source.relaxation_steps, "Space forms: number of Lloyd's steps for the net (default 0)")
      ->type_name("STEPS");
  command
      .add_option(
          "--sizing", source.sizing.text,
          "Flat tori, submanifolds: radii that vary, at most --radius: a file with a cone a line, apex, radius, "
          "slope; on submanifolds also curvature:K,NU, K divided by the curvature with Lipschitz constant NU")
      ->type_name("FILE");
  command.add_option("--seed", source.seed, "Seed of all random choices (default 0)")->type_name("INTEGER");
}

}  // namespace delcert
