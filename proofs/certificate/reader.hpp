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
  /// The value of the key `manifold` as it stands in the file: what it holds differs from family to family.
  std::string manifold_text;
  /// The value of the key `net` as it stands in the file: half of its numbers, which not all need.
  std::string net_text;
  /// The keys `charts` and `radii`; empty where a family has none.
  std::vector<std::vector<Rational>> charts;
  std::vector<Rational> radii;
  /// As in the file: labels and the numbers of elements; what describes elements 1, 2, ….
  std::vector<std::vector<std::uint32_t>> simplices;
  std::vector<std::vector<std::int32_t>> elements;
  /// The value of the key `sha256`, and the SHA-256 of the bytes before it: different where the file was changed.
  std::string seal;
  std::string sealed_bytes;

  /// The points of the net, read when they are asked for. Throws InputError if they are not exact numbers.
  [[nodiscard]] std::vector<std::vector<Rational>> net() const;
  /// An entry of `parameters`, exactly. Throws InputError if there is none.
  [[nodiscard]] Rational parameter(const std::string& key) const;
  /// A margin of a level, exactly. None if the level is not claimed, or not with such a number.
  [[nodiscard]] std::optional<Rational> margin(const std::string& level, const std::string& key) const;
};

/// Reads a certificate, plain or compressed, whatever its seal. Throws InputError with the file and what is wrong
/// where.
[[nodiscard]] CertificateSummary read_certificate(const std::filesystem::path& path);

}  // namespace delcert
