#pragma once

#include <optional>
#include <string>
#include <vector>

#include "proofs/certificate/claims.hpp"
#include "proofs/certificate/run_parameters.hpp"
#include "proofs/certification/net_source.hpp"

namespace delcert {

/// What is asked of a certification.
struct CertifyOptions {
  std::string complex;  ///< a file, instead of a manifold and a net
  NetSource source;
  ParameterChoice choice;
  bool mode_is_given = false;
  bool no_perturbation = false;
  std::optional<Rational> required_protection;
  int repair_rounds = 20;
  int refinement_rounds = 0;
  unsigned threads = 0;  ///< 0: as many as there are processors
  LevelSelection levels = all_levels();
  std::string output;  ///< the certificate
  Origin origin;
};

}  // namespace delcert
