#pragma once

#include <string>

#include "proofs/checker/certificate/certificate.hpp"

namespace delcert::checker {

/// Of what a verdict speaks. All but the name was computed from what the certificate states exactly; the name is a word
/// that nothing verifies.
struct Identity {
  std::string family;
  int dimension = 0;
  std::string size;            // "14 sides", "squared volume 3/4"; empty if the group was not verified
  std::string orientability;   // "orientable"; empty if nothing was verified of the generators
  std::string first_homology;  // "Z^6"; empty if it was not looked at
  std::string homology_of = "its presentation";  // from what it was found
  std::string name;                              // as stated, safe to print
  std::string manifold_digest;                   // SHA-256 of the bytes of the manifold block, with its braces
  std::string file_digest;                       // SHA-256 of the file as it is
};

/// What the manifold block says, and nothing that is to be verified of a space form.
Identity identify(const Certificate& c);

/// One line. The name only if it may be said: it could be any word, "verified" among them.
std::string to_string(const Identity& identity, bool with_name);

}  // namespace delcert::checker
