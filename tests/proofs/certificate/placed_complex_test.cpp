#include "proofs/certificate/placed_complex.hpp"

#include <gtest/gtest.h>

#include "kernel/manifold/space_form_file.hpp"
#include "kernel/run/chart_run.hpp"
#include "kernel/sample/space_form_net.hpp"
#include "proofs/certificate/element_words.hpp"
#include "tests/proofs/certificate/metric_field_run.hpp"
#include "tests/proofs/certificate/small_run.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

template <int m>
std::vector<std::uint32_t> labels_of(const PlacedComplex<m>& complex) {
  std::vector<std::uint32_t> result;
  for (const auto& simplex : complex.simplices) result.insert(result.end(), simplex.begin(), simplex.begin() + m + 1);
  return result;
}

/// Labels increase, simplices are sorted, and facets pair together with the relative elements that `relative` gives.
template <int m, class Relative>
void expect_closed(const PlacedComplex<m>& complex, const Relative& relative) {
  std::map<std::vector<std::string>, int> facets;
  for (const auto& simplex : complex.simplices) {
    for (std::size_t corner = 1; corner <= m; ++corner) EXPECT_LT(simplex[corner - 1], simplex[corner]);
    for (std::size_t left_out = 0; left_out <= m; ++left_out) {
      std::vector<std::string> facet;
      const std::size_t base = left_out == 0 ? 1 : 0;
      for (std::size_t corner = 0; corner <= m; ++corner) {
        if (corner == left_out) continue;
        facet.push_back(std::to_string(simplex[corner]) + " at " +
                        relative(element_at<m>(simplex, base), element_at<m>(simplex, corner)));
      }
      ++facets[facet];
    }
  }
  EXPECT_TRUE(std::is_sorted(complex.simplices.begin(), complex.simplices.end()));
  for (const auto& [facet, count] : facets) EXPECT_EQ(count, 2) << facet[0] << ", " << facet[1];
}

template <int m>
void expect_lattice_complex(const PlacedComplex<m>& complex) {
  EXPECT_TRUE(std::is_sorted(complex.elements.begin(), complex.elements.end()));
  const std::vector<std::int32_t> zero(m, 0);
  expect_closed<m>(complex, [&](std::uint32_t a, std::uint32_t b) {
    const auto& from = a == 0 ? zero : complex.elements[a - 1];
    const auto& to = b == 0 ? zero : complex.elements[b - 1];
    std::string text;
    for (std::size_t axis = 0; axis < m; ++axis) text += std::to_string(to[axis] - from[axis]) + " ";
    return text;
  });
}

TEST(PlacedComplex, OfATorusIsClosedAndItsLoopsAreTheUnitVectors) {
  const SmallRun& run = small_run();
  const PlacedComplex<2> complex = placed_complex<2>(run.atlas, run.run.points, run.run.complex);
  EXPECT_EQ(complex.simplices.size(), run.run.complex.simplices().size());
  expect_lattice_complex<2>(complex);
  ASSERT_EQ(complex.loops.size(), 2U);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    std::array<std::int32_t, 2> sum{};
    std::uint32_t label = 0;
    for (const LoopStep& step : complex.loops[axis]) {
      const auto& simplex = complex.simplices[step.simplex];
      EXPECT_EQ(simplex[step.from], label);
      label = simplex[step.to];
      for (std::size_t k = 0; k < 2; ++k) {
        const auto at = [&](std::uint32_t corner) {
          const std::uint32_t element = element_at<2>(simplex, corner);
          return element == 0 ? 0 : complex.elements[element - 1][k];
        };
        sum[k] += at(step.to) - at(step.from);
      }
    }
    EXPECT_EQ(label, 0U);
    EXPECT_EQ(sum[axis], 1);
    EXPECT_EQ(sum[1 - axis], 0);
    EXPECT_LT(complex.loops[axis].size(), 60U) << "a straight way is some 30 steps long";
  }
}

TEST(PlacedComplex, OfAMetricFieldIsClosed) {
  const auto& sample = test::sheared_run();
  const PlacedComplex<2> complex = placed_complex<2>(sample.run.complex);
  EXPECT_EQ(complex.simplices.size(), sample.run.complex.simplices().size());
  EXPECT_TRUE(complex.loops.empty());
  expect_lattice_complex<2>(complex);
}

template <int m>
void expect_space_form(const std::string& name, const Rational& radius, int patch_factor = 9) {
  SCOPED_TRACE(name);
  const SpaceForm form = verify_space_form(find_space_form(name));
  auto net = space_form_net<m>(form, radius, 1, no_progress());
  const SpaceFormAtlas<m> atlas(form, std::move(net.centres), radius, patch_factor);
  PerturbationParameters parameters = measured_parameters(Dimension(m), 1);
  parameters.choices = 5;
  const auto run = run_in_charts<m>(atlas, parameters, {}, no_progress());
  ASSERT_TRUE(run.is_certified());
  const PlacedComplex<m> complex = placed_complex<m>(atlas, run.complex);
  ElementWords words(form.form(), form.description.generators);
  std::vector<FieldMatrix> elements{words.matrix(0)};
  for (const auto& word : complex.elements)
    elements.push_back(elements.at(static_cast<std::size_t>(word[0])) * words.letter(word[1]));
  expect_closed<m>(complex, [&](std::uint32_t a, std::uint32_t b) {
    if (a == b) return std::string("0");
    return std::to_string(words.number_of(form.form().inverse_of(elements[a]) * elements[b]));
  });
  ASSERT_EQ(complex.loops.size(), words.letter_count());
  for (std::size_t at = 0; at < complex.loops.size(); ++at) {
    FieldMatrix product = elements[0];
    for (const LoopStep& step : complex.loops[at]) {
      const auto& simplex = complex.simplices[step.simplex];
      product = product * form.form().inverse_of(elements[element_at<m>(simplex, step.from)]) *
                elements[element_at<m>(simplex, step.to)];
    }
    EXPECT_TRUE(product == words.letter(static_cast<std::int32_t>(at) + 1));
  }
}

TEST(PlacedComplex, OfSpaceFormsIsClosedAndItsLoopsAreTheGenerators) {
  const Rational one(1);
  expect_space_form<2>("klein-bottle", one / Rational(24));
  expect_space_form<2>("bolza-surface", one / Rational(8));
  expect_space_form<2>("projective-plane", one / Rational(8));
  expect_space_form<3>("projective-space-3", one / Rational(7), 7);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
