#include "apps/command_line.hpp"

#include <gtest/gtest.h>

#include "apps/choice_option.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

std::string line_of(const std::string& arguments) {
  CLI::App program("p", "p");
  CLI::App* command = program.add_subcommand("certify", "");
  std::string manifold, output;
  std::vector<std::string> files;
  bool flag = false;
  command->add_option("--manifold,-m", manifold, "");
  command->add_option("--output", output, "");
  command->add_flag("--no-perturbation", flag, "");
  command->add_option("FILES", files, "");
  enum class Shade : std::uint8_t { light, dark };
  Shade shade = Shade::light;
  add_choice_option<Shade>(*command, "--shade", shade, {{"light", Shade::light}, {"dark", Shade::dark}}, "");
  program.parse(arguments);
  EXPECT_EQ(shade == Shade::dark, arguments.ends_with("--shade dark"));
  return command_line("delcert", *command, {"--output"});
}

TEST(CommandLine, is_what_was_typed_but_for_what_is_left_out) {
  EXPECT_EQ(line_of("certify --manifold torus-2"), "delcert certify --manifold torus-2");
  EXPECT_EQ(line_of("certify --output=x.json -m torus-2"), "delcert certify --manifold torus-2");
  EXPECT_EQ(line_of("certify --no-perturbation --manifold=a"), "delcert certify --manifold a --no-perturbation");
  EXPECT_EQ(line_of("certify one two"), "delcert certify one two");
}

TEST(CommandLine, has_the_words_of_choices) {
  EXPECT_EQ(line_of("certify --shade dark"), "delcert certify --shade dark");
  EXPECT_THROW((void)line_of("certify --shade 1"), CLI::ValidationError);
}

TEST(CommandLine, quotes_what_a_shell_would_change) {
  EXPECT_EQ(shell_word("curvature:1/10,1/10"), "curvature:1/10,1/10");
  EXPECT_EQ(shell_word("my torus.toml"), "'my torus.toml'");
  EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
  EXPECT_EQ(shell_word("$(rm x)"), "'$(rm x)'");
  EXPECT_EQ(shell_word(""), "''");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
