#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "proofs/checker/certificate/cursor.hpp"
#include "proofs/checker/certificate/gluing.hpp"
#include "proofs/checker/certificate/input.hpp"
#include "proofs/checker/certificate/metric_field.hpp"
#include "proofs/checker/certificate/space_form.hpp"
#include "proofs/checker/certificate/submanifold.hpp"
#include "proofs/checker/geometry/point_set.hpp"

namespace delcert::checker {

inline constexpr std::array<std::string_view, 10> level_names = {"0", "1", "1f", "2", "2s", "3", "4", "5", "5i", "6"};
enum Level : std::size_t {
  level_0,
  level_1,
  level_1f,
  level_2,
  level_2s,
  level_3,
  level_4,
  level_5,
  level_5i,
  level_6
};

/// What rules there are depends on which kind of manifold it is.
enum class Kind { ball, torus, space_form, metric_field, atlas, submanifold, given_complex };
/// Whether the core decides levels 2, 4, 5 and 6 (docs/levels/core.md). On other kinds levels 1, of given
/// complexes 1f, and 2 are one.
constexpr bool has_core(Kind kind) { return kind == Kind::torus || kind == Kind::space_form; }
/// The levels with which a level must be claimed.
std::vector<Level> rests_on(std::size_t level, Kind kind);
/// The level of the stars with which level 2 is one, where there is no core.
constexpr Level level_of_stars(Kind kind) { return kind == Kind::given_complex ? level_1f : level_1; }

/// An edge of a simplex: from its vertex at one position to that at another.
struct LoopStep {
  std::uint32_t simplex, from, to;
};

class ChunkView;

/// A certificate of the right form. Neither copied nor moved: the point sets refer to it, and it refers to the text.
struct Certificate {
  /// Reads the whole text; the digest that is known of its beginning is not computed again, and is asked for when all
  /// else has been read. Throws Malformed: `form.*` or `seal`.
  explicit Certificate(std::string_view text, const KnownDigest& known = {});
  /// Reads of a certificate in chunks what is so many edges from a chunk or nearer: labels and simplices have numbers
  /// of their own (chunk_items.hpp). Throws Malformed: `form.*`, `chunk.*` or `seal`.
  Certificate(ChunkView& view, unsigned edges);
  Certificate(const Certificate&) = delete;
  Certificate& operator=(const Certificate&) = delete;

  std::string content;                   // the SHA-256 that it is sealed with
  std::string_view name, manifold_text;  // the name as it is written; the block with its braces
  bool torus = false;
  std::unique_ptr<SpaceForm> space_form;      // of its families; otherwise none
  std::unique_ptr<MetricField> metric_field;  // of its family; otherwise none
  std::unique_ptr<Gluing> gluing;             // of the family "atlas"; otherwise none
  std::unique_ptr<Submanifold> submanifold;   // of its family; otherwise none
  int m = 0;
  Label n = 0;
  std::vector<Rational> gram;  // m rows of m; empty on a Euclidean ball
  bool theory = false;         // the mode
  bool unperturbed = false;    // the mode none
  Quantity radius, epsilon, mu, radius_variation, distortion, rho, flake_squared, tolerance;
  std::array<bool, level_names.size()> claimed{};
  bool hypotheses_2 = false;                                   // level 0
  bool sharper = false;                                        // which Hypotheses 2: docs/sharper-lemmas.md
  Quantity density, transition_distortion, metric_distortion;  // level 0 on a space form
  Quantity protection, thickness, circumradius;                // level 1
  std::uint64_t simplices = 0;                                 // level 2
  std::int64_t euler_characteristic = 0;
  bool closed = false;
  std::vector<std::string> homology;                     // m + 1 groups, or none
  Quantity reach_2s;                                     // level 2s on a space form
  Quantity empty_margin, ball_radius;                    // level 4 on a space form
  Quantity edge, stability_margin;                       // level 4 on a metric field
  Quantity contraction, displacement, embedding_margin;  // levels 5 and 5i on a submanifold, 5 on an atlas
  bool isotopic_by_normals = false;                      // level 5i: then, in place of the margin,
  Quantity cosine;                                       // of the angles between normals and gradients
  bool riemannian_simplices = false;                     // level 5: whether the two that follow are there
  Quantity riemannian_thickness, riemannian_radius;
  bool self_delaunay = true;  // level 6
  Quantity weight, least_stretch, greatest_stretch;
  bool extrinsic = false, intrinsic = false;  // level 4 on a submanifold: of which distances; `density` is its own
  Quantity normal;                            // level 6 on a submanifold
  std::vector<std::string_view> net_text, points_text;  // m to a point; in net_text, on a submanifold, N
  std::vector<std::string_view> chart_text;             // chart_size() to a point
  std::vector<std::string_view> radii_text;             // on a torus or a submanifold: one to a point, or none
  std::vector<Label> net_simplices;                     // m + 1 to a simplex
  std::vector<std::int32_t> element_entries;            // element_size() to an element; the identity is not among them
  std::vector<Label> simplex_labels;                    // m + 1 to a simplex, increasing
  std::vector<std::uint32_t> simplex_elements;          // m to a simplex: of its second to its last vertex
  std::vector<std::vector<LoopStep>> loops;             // one for each generator of the group; none without one
  // From the simplices.
  std::vector<std::uint64_t> star_begin;  // star(i) is simplices star_begin[i] … star_begin[i + 1] - 1
  std::vector<Label> star_labels;         // m to a simplex

  ChunkView* chunk = nullptr;  // none if the whole was read
  Metric metric;
  PointSet net, points;
  std::vector<Quantity> units;  // see `at`; none: all are 1. On a torus none exceeds 1
  std::vector<bool> interior;

  Kind kind() const {
    return space_form     ? Kind::space_form
           : metric_field ? Kind::metric_field
           : gluing       ? Kind::atlas
           : submanifold  ? (submanifold->given ? Kind::given_complex : Kind::submanifold)
           : torus        ? Kind::torus
                          : Kind::ball;
  }
  bool has_boundary() const { return kind() == Kind::ball; }
  std::size_t m_size() const { return static_cast<std::size_t>(m); }
  /// How many numbers describe a chart; 0 where the file has none.
  std::size_t chart_size() const {
    if (submanifold) return submanifold->chart_size();
    return metric_field || gluing ? (gluing ? 1 : 0) + m_size() * (m_size() + 1) / 2 : 0;
  }
  /// How many numbers describe a point of the net.
  std::size_t net_size() const { return submanifold ? submanifold->N : m_size(); }
  /// On all but flat tori and balls `points` are what the net points are moved by.
  bool points_are_moves() const { return space_form || metric_field || gluing || submanifold; }
  /// Lengths are claimed for epsilon: at label i, with the radius epsilon_i, they count epsilon_i/epsilon times.
  Quantity at(Label i, const Quantity& length) const {
    return units.empty() ? length : Quantity(length.exact * units[i].exact);
  }
  /// The same of labels: the least that it is at one of them.
  Quantity at_least(const Label* begin, const Label* end, const Quantity& length) const;
  /// Kept in `memory`, if it is not the length itself: copies take time.
  const Quantity& at_least(const Label* begin, const Label* end, const Quantity& length, Quantity& memory) const {
    return units.empty() ? length : memory = at_least(begin, end, length);
  }
  Quantity at_simplex(std::size_t s, const Quantity& length) const {
    return at_least(simplex(s), simplex(s) + m + 1, length);
  }
  /// 1 + epsilon_0: on a torus no radius in a patch is more than this times another. 1 if they are all the same.
  Quantity radius_factor() const {
    return Quantity(Rational(1) + (units.empty() ? Rational(0) : radius_variation.exact));
  }
  /// What a summary adds to lengths.
  const char* of_lengths() const {
    return units.empty() ? "" : " (lengths, of the greatest radius; elsewhere in proportion)";
  }
  Interval unit(Label i) const { return units.empty() ? Interval(1) : units[i].filter; }
  Interval least_unit(std::size_t s) const { return at_simplex(s, Quantity(Rational(1))).filter; }
  double greatest_unit() const { return greatest_unit_; }
  /// Of an affine chart: the entries on and above the diagonal of the matrix of a label, row by row.
  std::vector<Rational> chart_entries(Label i) const;
  /// On an atlas: the number of the chart that contains the chart of a label; the number of charts if no chart contains
  /// it.
  std::size_t home_chart(Label i) const;
  /// On a space form, a metric field, an atlas or a submanifold: within rho epsilon + 2 (circumradius) + protection of
  /// p_i is what level 1 looks at.
  Rational reach_1() const;
  /// How far from p_i any level looks; 0 if none does.
  Rational reach() const;

  /// How many integers describe an element: a vector, or parent and letter; none where there is no group.
  std::size_t element_size() const { return space_form ? 2 : has_boundary() || gluing || submanifold ? 0 : m_size(); }
  /// The identity, element 0, is counted.
  std::size_t element_count() const { return 1 + (element_size() == 0 ? 0 : element_entries.size() / element_size()); }
  /// What describes element number e > 0.
  const std::int32_t* element(std::size_t e) const { return &element_entries[(e - 1) * element_size()]; }
  /// The letters of words: generators, then translations where they are understood.
  std::size_t letter_count() const {
    return space_form ? space_form->generators.size() + (space_form->K == 0 ? m_size() : 0) : 0;
  }
  /// How many loops there have to be: one for each generator of the group.
  std::size_t loop_count() const { return space_form ? letter_count() : torus ? m_size() : 0; }
  std::size_t simplex_count() const { return simplex_labels.size() / (m_size() + 1); }
  /// The m + 1 labels of simplex number s.
  const Label* simplex(std::size_t s) const { return &simplex_labels[s * (m_size() + 1)]; }
  /// The number of the element at which simplex number s has its k-th vertex.
  std::uint32_t element_of(std::size_t s, std::size_t k) const {
    return k == 0 ? 0 : simplex_elements[s * m_size() + k - 1];
  }

  /// The component of the complex in which each label is, as one of its labels.
  std::vector<Label> components() const;

  std::size_t star_size(Label i) const { return star_begin[i + 1] - star_begin[i]; }
  /// The m labels other than i of simplex number s of star(i), increasing.
  const Label* star_simplex(Label i, std::size_t s) const {
    return &star_labels[(star_begin[i] + s) * static_cast<std::size_t>(m)];
  }

 private:
  double greatest_unit_ = 1;
  std::vector<Interval> net_read_, points_read_;  // of the texts, until they are understood
  void take();
  void parse(Cursor& cursor);
  void parse_claims(Cursor& cursor);
  void parse_manifold(Cursor& cursor);
  void parse_parameters(Cursor& cursor);
  void parse_levels(Cursor& cursor);
  void parse_elements(Cursor& cursor);
  void parse_net(Cursor& cursor);
  void parse_points_and_complex(Cursor& cursor);
  void parse_complex(Cursor& cursor);
  void require_lengths() const;
  void require_parameters() const;
  void parse_space_form_level(Cursor& cursor, std::size_t level);
  void parse_metric_field_level(Cursor& cursor, std::size_t level);
  void require_mode() const;
  void require_levels() const;
  void require_space_form() const;
  void require_affine_charts() const;
  void require_metric_field() const;
  void require_gluing() const;
  void parse_atlas_level(Cursor& cursor, std::size_t level);
  void parse_submanifold_level(Cursor& cursor, std::size_t level);
  void parse_stretch(Cursor& cursor);
  void require_submanifold() const;
  void take_radii();
  void require_elements() const;
  void require_loops() const;
  void require_simplices() const;
  void derive_stars();
  bool is_interior(Label i) const;
};

/// "{3, 17, 90}".
std::string label_set(const Label* begin, const Label* end);

}  // namespace delcert::checker
