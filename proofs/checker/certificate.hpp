#pragma once

#include <array>
#include <string>
#include <vector>

#include "proofs/checker/cursor.hpp"
#include "proofs/checker/point_set.hpp"

namespace delcert::checker {

inline constexpr std::array<std::string_view, 8> level_names = {"0", "1", "2", "2s", "3", "4", "5", "6"};
enum Level : std::size_t { level_0, level_1, level_2, level_2s, level_3, level_4, level_5, level_6 };

/// The levels with which a level must be claimed.
std::vector<Level> rests_on(std::size_t level);

/// A certificate of the right form. Neither copied nor moved: the point sets refer to it, and it refers to the text.
struct Certificate {
  /// Reads the whole text. Throws Malformed: `form.*` or `seal`.
  explicit Certificate(std::string_view text);
  Certificate(const Certificate&) = delete;
  Certificate& operator=(const Certificate&) = delete;

  bool torus = false;
  int m = 0;
  Label n = 0;
  std::vector<Rational> gram;  // m rows of m; empty on a Euclidean ball
  bool theory = false;         // the mode
  Quantity radius, epsilon, mu, radius_variation, distortion, rho, flake_squared, tolerance;
  std::array<bool, level_names.size()> claimed{};
  bool hypotheses_2 = false;                     // level 0
  Quantity protection, thickness, circumradius;  // level 1
  std::uint64_t simplices = 0;                   // level 2
  std::int64_t euler_characteristic = 0;
  bool closed = false;
  std::vector<std::string> homology;                    // m + 1 groups, or none
  std::vector<std::string_view> net_text, points_text;  // m to a point
  std::vector<Label> net_simplices;                     // m + 1 to a simplex
  std::vector<std::uint64_t> star_begin;                // star(i) is simplices star_begin[i] … star_begin[i + 1] - 1
  std::vector<Label> star_labels;                       // m to a simplex

  Metric metric;
  PointSet net, points;
  std::vector<bool> interior;

  std::size_t star_size(Label i) const { return star_begin[i + 1] - star_begin[i]; }
  /// The m labels other than i of simplex number s of star(i), increasing.
  const Label* star_simplex(Label i, std::size_t s) const {
    return &star_labels[(star_begin[i] + s) * static_cast<std::size_t>(m)];
  }

 private:
  void parse(Cursor& cursor);
  void parse_manifold(Cursor& cursor);
  void parse_parameters(Cursor& cursor);
  void parse_levels(Cursor& cursor);
  void require_lengths() const;
  void require_parameters() const;
  void require_levels() const;
  void require_stars() const;
  bool is_interior(Label i) const;
};

/// "{3, 17, 90}".
std::string label_set(const Label* begin, const Label* end);

/// The number in decimal, approximately, for messages.
std::string about(const Interval& x);

}  // namespace delcert::checker
