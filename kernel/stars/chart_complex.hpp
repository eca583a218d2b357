#pragma once

#include <vector>

#include "kernel/stars/chart_stars.hpp"

namespace delcert {

/// An m-simplex as its sorted labels.
template <int m>
using LabelSimplex = std::array<std::uint32_t, static_cast<std::size_t>(m) + 1>;

/// How far the stars of a complex agree (rule 2.agreement of docs/levels/space-forms.md).
struct StarAgreement {
  std::size_t missing = 0;  ///< pairs of a simplex of some star and a label of it whose star does not have the simplex
  std::size_t stars = 0;    ///< labels in such a pair
  std::vector<Label> labels;          ///< these, sorted
  std::vector<StarFailure> failures;  ///< one for each simplex that some star misses: which, and whose star has it
};

/// The stars of all interior labels, each computed in its own chart, and the complex that they are if they agree.
template <int m>
class ChartComplex {
 public:
  /// `stars[i]` is that of label i, empty where no star is claimed; its simplices are sorted, as are their vertices.
  explicit ChartComplex(std::vector<ChartStar<m>> stars, const std::vector<bool>& interior);

  [[nodiscard]] std::size_t size() const { return stars_.size(); }
  [[nodiscard]] bool is_interior(Label i) const { return interior_[i.value]; }
  [[nodiscard]] const ChartStar<m>& chart_star(Label i) const { return stars_[i.value]; }
  /// The stars, for good: nothing may be asked afterwards.
  [[nodiscard]] std::vector<ChartStar<m>> take_stars() { return std::move(stars_); }
  /// The other labels of each simplex of star(i), sorted, in increasing order.
  [[nodiscard]] std::vector<std::array<std::uint32_t, static_cast<std::size_t>(m)>> star(Label i) const;
  /// The labels of the simplices of star(i) other than i, sorted.
  [[nodiscard]] std::vector<Label> neighbours(Label i) const;

  /// The simplices of star(i) whose smallest interior label is i, by their other vertices as the chart of i sees them:
  /// where stars agree, every simplex at one label.
  [[nodiscard]] std::vector<ChartSimplex<m>> first_seen_from(Label i) const;

  /// All simplices that some star has, each once, in increasing order.
  [[nodiscard]] std::vector<LabelSimplex<m>> simplices() const;
  /// Σ (−1)^k times the number of k-faces, of the complex of all faces.
  [[nodiscard]] std::int64_t euler_characteristic() const { return label_complex().euler_characteristic(); }
  /// The complex of all faces, a face being its set of labels. Throws InputError if a simplex meets itself.
  [[nodiscard]] PureComplex label_complex() const;

  /// Whether σ ∈ star(i) and j ∈ σ imply σ ∈ star(j), for interior labels j.
  [[nodiscard]] StarAgreement agreement() const;

 private:
  /// A simplex as a star has it.
  struct Listed {
    LabelSimplex<m> simplex;
    std::uint32_t star;
    friend auto operator<=>(const Listed&, const Listed&) = default;
  };
  /// The simplices that some star misses, with all stars that have them, sorted.
  [[nodiscard]] std::vector<Listed> listed_where_some_miss() const;

  std::vector<ChartStar<m>> stars_;
  std::vector<bool> interior_;
};

/// Where the simplex of these labels is in a view; none if one of them is not seen exactly once.
template <int m>
[[nodiscard]] std::optional<PlaceSimplex<m>> places_of(const ChartView<m>& view, const LabelSimplex<m>& labels);

}  // namespace delcert
