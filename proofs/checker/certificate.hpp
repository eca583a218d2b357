#pragma once

#include <optional>
#include <vector>

#include "proofs/checker/document.hpp"
#include "proofs/checker/point_set.hpp"
#include "proofs/checker/report.hpp"

namespace delcert::checker {

/// A certificate of the right form: its numbers with their enclosures. Neither copied nor moved.
class Certificate {
 public:
  /// Reads the text, which must outlive the certificate. Throws Malformed.
  explicit Certificate(std::string_view text);
  Certificate(const Certificate&) = delete;
  Certificate& operator=(const Certificate&) = delete;

  const Document document;
  const bool torus;
  const int m;
  const Label n;
  const Metric metric;
  const Quantity epsilon, mu, rho, flake_squared, tolerance, radius;  // radius: of the Euclidean ball
  const Quantity protection, thickness, circumradius;                 // of level 1, if it is claimed
  const PointSet net, points;
  const std::vector<bool> interior;

  std::size_t star_size(Label i) const { return document.star_begin[i + 1] - document.star_begin[i]; }
  /// The m labels other than i of simplex number s of star(i), increasing.
  const Label* star_simplex(Label i, std::size_t s) const {
    return &document.star_labels[(document.star_begin[i] + s) * static_cast<std::size_t>(m)];
  }

 private:
  std::vector<bool> interior_labels() const;
  void require_parameters() const;
  void require_levels() const;
  void require_net() const;
  void require_stars() const;
};

/// The levels with which a level must be claimed and checked.
std::vector<Level> rests_on(Level level);

/// "{3, 17, 90}".
std::string label_set(std::vector<Label> labels);

/// The number, approximately, for messages.
std::string about(const Interval& x);

}  // namespace delcert::checker
