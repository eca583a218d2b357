#include "apps/claim_options.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "properties/attack/claim_library.hpp"
#include "support/error.hpp"
#include "tests/properties/attack/small_claims.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

ClaimOptions named(std::vector<std::string> names) {
  ClaimOptions options;
  options.names = std::move(names);
  return options;
}

TEST(ClaimOptions, claims_are_those_named_each_once_or_all) {
  const std::string first = builtin_claim_list().front().name;
  EXPECT_EQ(claims_of(named({first, first})).size(), 1U);
  ClaimOptions all;
  all.all = true;
  EXPECT_EQ(claims_of(all).size(), builtin_files().size());
  EXPECT_EQ(claims_about_instances(all).size(), builtin_claim_list().size());
  EXPECT_THROW((void)claims_of(named({})), InputError);
  EXPECT_THROW((void)claims_of(named({"no-such-claim"})), InputError);
  all.names = {first};
  EXPECT_THROW((void)claims_of(all), InputError);
}

TEST(ClaimOptions, two_claims_of_the_same_name_are_refused) {
  const test::TemporaryFolder folder;
  for (const char* name : {"a.toml", "b.toml"}) {
    std::ofstream(folder / name) << "name = \"same\"\ninstance = \"simplex\"\n[[show]]\nclaim = \"k >= 1\"\n";
  }
  const std::string a = (folder / "a.toml").string();
  EXPECT_EQ(claims_of(named({a, a})).size(), 1U);
  EXPECT_THROW((void)claims_of(named({a, (folder / "b.toml").string()})), InputError);
}

TEST(ClaimOptions, shapes_are_those_asked_for_each_once_or_those_of_the_class) {
  const Claim claim = test::wrong_claim();
  ClaimOptions options;
  EXPECT_EQ(shapes_of(options, claim), instance_class("simplex").shapes());
  options.shapes = {"2,3", "1,1", "2,3", "7,8"};
  EXPECT_EQ(shapes_of(options, claim), (std::vector<Shape>{{2, 3}, {1, 1}, {7, 8}}));
}

TEST(ClaimOptions, a_shape_that_is_none_or_that_the_class_has_not_is_an_error) {
  const Claim claim = test::wrong_claim();
  for (const char* text : {"", ",", "2,", ",2", "2,3,4", "a", "2.5", " 2,3", "-1,2", "17", "99999999999", "2;3", "+2,3",
                           "3,2", "2", "0,2", "0,0", "9,9"}) {
    ClaimOptions options;
    options.shapes = {text};
    try {
      (void)shapes_of(options, claim);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(std::string("--shape ") + text + ": ")) << error.what();
    }
  }
}

TEST(ClaimOptions, of_all_claims_those_without_the_shape_are_left_out) {
  ClaimOptions options;
  options.all = true;
  options.shapes = {"3,2"};
  EXPECT_TRUE(shapes_of(options, test::wrong_claim()).empty());
  options.shapes = {"x"};
  EXPECT_THROW((void)shapes_of(options, test::wrong_claim()), InputError);
}

TEST(ClaimOptions, shapes_are_written_with_their_dimensions) {
  EXPECT_EQ(text_of(Shape{2, 3}), "k=2 m=3");
  EXPECT_EQ(text_of(Shape{0, 2}), "m=2");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
