#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/ranks/communicator.hpp"
#include "proofs/certification/certify_options.hpp"
#include "support/progress.hpp"

namespace delcert {

/// What is asked of ranks beyond what is asked of one process. Of `certify`: the manifold, which is a sphere, a radius,
/// the parameters of the perturbation, the levels, `origin`; `output` is the folder. How many threads a rank has, its
/// caller says.
struct SharedOptions {
  CertifyOptions certify;
  std::size_t chunks = 0;  ///< at least 2
};

/// The same at all ranks but for the root, which the first rank has.
struct SharedReport {
  struct Stage {
    std::string name;
    double seconds = 0;            ///< until all ranks have ended it
    double processor_seconds = 0;  ///< of the rank that has taken most; waiting for others is counted, too
  };

  std::size_t points = 0;
  std::uint64_t simplices = 0;
  std::size_t most_own = 0;   ///< labels that some rank places
  std::size_t most_here = 0;  ///< labels that some rank knows
  std::uint32_t colours = 0;
  std::uint32_t restored_colours = 0;  ///< of these, what was there already
  int repair_rounds = 0;
  std::size_t repaired_points = 0;
  std::uint64_t bytes_of_perturbation = 0;  ///< sent by all ranks to others
  std::vector<std::string> levels;
  std::vector<std::string> reasons;  ///< for levels that are not reached
  std::string root;
  std::vector<Stage> stages;
  double memory_of_net_mib = 0;  ///< of the first rank until the net is divided
  double most_memory_mib = 0;    ///< of some rank
};

/// Certifies a triangulation of a sphere by several ranks, which have one file system in common, and writes it in
/// chunks: the files that `write_chunks` makes of the certificate of one process, byte for byte, for any number of
/// ranks (docs/ranks.md).
///
/// What is finished is kept in the folder OUTPUT.progress, which is removed at the end; a run of the same options and
/// as many ranks goes on from there. Throws at the rank where something is wrong: InputError, Rejection where nothing
/// is certified, or if there are fewer than 16 labels for each rank. Precondition: rounding to nearest.
[[nodiscard]] SharedReport certify_shared(Communicator& ranks, const SharedOptions& options, const Progress& progress);

}  // namespace delcert
