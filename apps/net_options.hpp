#pragma once

#include <CLI/CLI.hpp>

#include "proofs/certification/net_source.hpp"

namespace delcert {

/// Adds --manifold, --radius, --points (if `with_file`), --lattice, --centred, --displace, --icosphere, --relax,
/// --sizing, --seed, which several subcommands share.
void add_net_options(CLI::App& command, NetSource& source, bool with_file);

}  // namespace delcert
