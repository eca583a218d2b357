#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace delcert::checker {

using Label = std::uint32_t;

inline constexpr std::array<std::string_view, 8> level_names = {"0", "1", "2", "2s", "3", "4", "5", "6"};
enum Level : std::size_t { level_0, level_1, level_2, level_2s, level_3, level_4, level_5, level_6 };

/// The content of a certificate as it is written. Texts point into the document's bytes. What holds of it is what the
/// grammar says: types, keys, number forms, lengths of rows; everything else is left to `form.hpp` and the levels.
struct Document {
  bool torus = false;
  int dimension = 0;
  std::string_view name;
  std::vector<std::string_view> gram;  // m rows of m; empty on a Euclidean ball
  std::string_view radius;             // of a Euclidean ball

  std::string_view mode;
  std::string_view sampling_radius, separation, radius_variation, distortion, perturbation, flake_parameter_squared,
      tolerance;

  std::array<bool, level_names.size()> claimed{};
  bool hypotheses_2 = false;
  std::string_view protection, thickness, circumradius;
  std::uint64_t simplices = 0;
  std::int64_t euler_characteristic = 0;
  bool closed = false;

  std::vector<std::string_view> net, points;  // m to a point
  std::vector<Label> net_simplices;           // m + 1 to a simplex
  std::vector<std::uint64_t> star_begin;      // star(i) is simplices star_begin[i] … star_begin[i + 1] - 1
  std::vector<Label> star_labels;             // m to a simplex

  std::string_view sealed;  // the bytes under the seal
  std::string_view sha256;

  std::size_t number_of_points() const { return points.size() / static_cast<std::size_t>(dimension); }
};

/// Reads the whole text. Throws Malformed. The result refers to the text.
Document parse_document(std::string_view text);

}  // namespace delcert::checker
