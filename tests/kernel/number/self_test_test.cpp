#include "kernel/number/self_test.hpp"

#include <flint/flint.h>
#include <gtest/gtest.h>
#include <xmmintrin.h>

#include <algorithm>
#include <set>

#include "kernel/number/rounding_guard.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

std::string joined(const std::vector<std::string>& failures) {
  std::string text;
  for (const std::string& failure : failures) text += failure + "\n";
  return text;
}

/// Sets the control word of the floating-point unit while it lives.
class ControlWord {
 public:
  explicit ControlWord(unsigned bits) : previous_(_mm_getcsr()) { _mm_setcsr(previous_ | bits); }
  ~ControlWord() { _mm_setcsr(previous_); }
  ControlWord(const ControlWord&) = delete;
  ControlWord& operator=(const ControlWord&) = delete;

 private:
  unsigned previous_;
};

std::vector<std::string> self_test_with(unsigned bits) {
  const ControlWord control_word(bits);
  return arithmetic_self_test();
}

constexpr unsigned flush_to_zero = 0x8000;
constexpr unsigned denormals_are_zero = 0x0040;

TEST(SelfTest, passes_in_a_build_with_the_flags_of_the_project) { EXPECT_EQ(joined(arithmetic_self_test()), ""); }

TEST(SelfTest, reports_a_unit_that_flushes_results_to_zero) {
  EXPECT_NE(joined(self_test_with(flush_to_zero)).find("flushed to zero"), std::string::npos);
}

TEST(SelfTest, reports_a_unit_that_takes_subnormals_for_zero) {
  EXPECT_NE(joined(self_test_with(denormals_are_zero)).find("taken for zero"), std::string::npos);
}

TEST(SelfTest, reports_each_directed_mode_that_someone_left_behind) {
  for (const unsigned mode : {0x2000U, 0x4000U, 0x6000U})  // down, up, towards zero

    EXPECT_NE(joined(self_test_with(mode)).find("not to nearest"), std::string::npos) << mode;
}

TEST(SelfTest, passes_again_after_each_of_these) { EXPECT_EQ(joined(arithmetic_self_test()), ""); }

TEST(SelfTest, leaves_the_control_word_as_it_was) {
  const unsigned control_bits = ~0x3FU;
  const unsigned before = _mm_getcsr() & control_bits;
  EXPECT_EQ(joined(arithmetic_self_test()), "");
  EXPECT_EQ(_mm_getcsr() & control_bits, before);
}

TEST(SelfTest, names_a_library_that_is_not_the_one_of_its_headers) {
  EXPECT_EQ(detail::version_mismatch("GMP", "6.2.1", "6.2.1"), "");
  EXPECT_EQ(detail::version_mismatch("GMP", "6.2.1", "6.3.0"),
            "GMP 6.3.0 is loaded, but compiled were the headers of 6.2.1");
}

TEST(SelfTest, library_versions_are_complete_sorted_and_look_like_versions) {
  const auto versions = library_versions();
  EXPECT_TRUE(std::is_sorted(versions.begin(), versions.end()));
  std::set<std::string> names;
  for (const auto& [name, version] : versions) {
    names.insert(name);
    EXPECT_EQ(version.find_first_not_of("0123456789."), std::string::npos) << name << " " << version;
    EXPECT_NE(version.find('.'), std::string::npos) << name << " " << version;
  }
  std::set<std::string> expected{"boost", "cgal", "flint", "gmp", "mpfi", "mpfr"};
  // FLINT 3 holds what were Arb and Calcium.
  if (std::string(flint_version) < "3") expected.merge(std::set<std::string>{"arb", "calcium"});
  EXPECT_EQ(names, expected);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
