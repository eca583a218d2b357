#include "proofs/constants/ledger_entries.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>

namespace delcert {
namespace {

Ledger surface() { return constants_for(Dimension{2}, Rational(1), Rational(1) / Rational(4)); }

LedgerEntry entry_named(const std::vector<LedgerEntry>& entries, const std::string& name) {
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.name == name; });
  if (found == entries.end()) throw std::out_of_range(name);
  return *found;
}

TEST(LedgerEntries, have_distinct_names_and_ordered_bounds) {
  std::set<std::string> names;
  for (const LedgerEntry& entry : ledger_entries(surface())) {
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_LE(entry.value.lower, entry.value.upper) << entry.name;
    EXPECT_FALSE(entry.source.empty()) << entry.name;
    EXPECT_EQ(entry.exact.empty(), entry.exact_latex.empty()) << entry.name;
    if (entry.log2) {
      EXPECT_LE(entry.log2->lower, entry.log2->upper) << entry.name;
    }
  }
}

TEST(LedgerEntries, show_products_of_powers_and_fractions) {
  const auto entries = ledger_entries(surface());
  const LedgerEntry flake = entry_named(entries, "flake_parameter");
  EXPECT_EQ(flake.exact, "2^(-101/2)");
  EXPECT_EQ(flake.exact_latex, "2^{-101/2}");
  EXPECT_LT(flake.value.lower, flake.value.upper);
  const LedgerEntry separation = entry_named(entries, "perturbed_separation");
  EXPECT_EQ(separation.exact, "2/5");
  EXPECT_EQ(separation.exact_latex, "\\frac{2}{5}");
  EXPECT_EQ(separation.value.lower, separation.value.upper);
  EXPECT_FALSE(entry_named(entries, "distortion").log2.has_value());
}

TEST(LedgerEntries, estimate_the_sample_size_where_it_was_measured_only) {
  const auto has_estimate = [](int dimension) {
    const auto entries = ledger_entries(constants_for(Dimension{dimension}, Rational(1), Rational(1) / Rational(4)));
    return std::any_of(entries.begin(), entries.end(),
                       [](const auto& e) { return e.name == "sphere_sample_size_estimate"; });
  };
  EXPECT_FALSE(has_estimate(1));
  EXPECT_TRUE(has_estimate(2));
  EXPECT_TRUE(has_estimate(3));
  EXPECT_FALSE(has_estimate(4));
}

}  // namespace
}  // namespace delcert
