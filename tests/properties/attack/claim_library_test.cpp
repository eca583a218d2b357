#include "properties/attack/claim_library.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"
#include "tests/properties/attack/small_claims.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::right_claim;
using test::triangle_bindings;

const Rational half = Rational(1) / Rational(2);

TEST(ClaimLibrary, the_names_of_a_claim_are_those_of_its_class_and_its_parameters_in_their_ranges) {
  const Claim claim = right_claim();
  Bindings bindings = triangle_bindings(0, 1);
  EXPECT_THROW(require_names_of(claim, bindings), InputError);
  bindings["eta"] = Rational(1);
  EXPECT_NO_THROW(require_names_of(claim, bindings));
  for (const Rational& outside : {Rational(0), Rational(-1), Rational(1) + Rational::power_of_two(-100)}) {
    bindings["eta"] = outside;
    EXPECT_THROW(require_names_of(claim, bindings), InputError);
  }
  bindings["eta"] = half;
  bindings["theta"] = half;
  EXPECT_THROW(require_names_of(claim, bindings), InputError);
}

TEST(ClaimLibrary, claims_are_found_by_name_and_by_file_and_others_get_a_suggestion) {
  ASSERT_FALSE(builtin_claim_list().empty());
  const std::string name = builtin_claim_list().front().name;
  EXPECT_EQ(find_claim(name).name, name);
  EXPECT_THROW((void)find_claim("no/such/file.toml"), InputError);
  EXPECT_THROW((void)find_claim(std::string(5000, 'a')), InputError);
  EXPECT_THROW((void)find_claim(""), InputError);
  try {
    (void)find_claim(name + "x");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean " + name + "?"), std::string::npos) << error.what();
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
