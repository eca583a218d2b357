#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kernel/manifold/manifold_file.hpp"

namespace delcert {

/// What a certificate says, read without verifying any of it: for printing and drawing. `delcert-check` is the program
/// that verifies.
struct CertificateSummary {
  std::vector<std::pair<std::string, std::string>> software;
  std::vector<std::pair<std::string, std::string>> parameters;
  /// Level → its margins as (name, value).
  std::vector<std::pair<std::string, std::vector<std::pair<std::string, std::string>>>> levels;
  /// "flat-torus", "euclidean-ball", "spherical", "flat", "hyperbolic".
  std::string family;
  /// Of a space form name and dimension alone.
  ManifoldDescription manifold;
  std::size_t net_simplices = 0;
  /// Of a space form tangent vectors at the points of the net.
  std::vector<std::vector<Rational>> points;
  /// As in the file: labels and the numbers of elements; what describes elements 1, 2, ….
  std::vector<std::vector<std::uint32_t>> simplices;
  std::vector<std::vector<std::int32_t>> elements;
  std::string seal;
};

/// Reads a certificate, plain or compressed. Throws InputError with the file and what is wrong where.
[[nodiscard]] CertificateSummary read_certificate(const std::filesystem::path& path);

}  // namespace delcert
