#include "proofs/errata/erratum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "support/error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

const std::string complete = R"(label = "lem:bound.cc"
number = "Lemma 14"
lines = "10-12, 20"
kind = "changes a theorem"
printed = "R ≤ 1"
wrong = "R = 2 occurs"
decidable = true
command = "delcert --version"
defence = "R is meant"
)";

/// The complete text with one line, found by its beginning, replaced.
std::string with(const std::string& begin, const std::string& line) {
  std::string text = complete;
  const auto at = text.find(begin + " =");
  return text.replace(at, text.find('\n', at) - at, line);
}

std::string message_of(const std::string& text) {
  try {
    (void)parse_erratum(text, "file.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Erratum, is_read_with_all_that_it_says) {
  const Erratum erratum = parse_erratum(complete + "witness = 'w'\nmended = 'm'\neffect = 'e'\n", "file.toml");
  EXPECT_EQ(erratum.file, "file.toml");
  EXPECT_EQ(erratum.label, "lem:bound.cc");
  EXPECT_EQ(erratum.number, "Lemma 14");
  EXPECT_EQ(erratum.lines, (std::vector<LineRange>{{10, 12}, {20, 20}}));
  EXPECT_EQ(erratum.judgement, Judgement::theorem);
  EXPECT_EQ(erratum.printed, "R ≤ 1");
  EXPECT_EQ(erratum.wrong, "R = 2 occurs");
  EXPECT_EQ(erratum.witness, "w");
  EXPECT_EQ(erratum.mended, "m");
  EXPECT_EQ(erratum.defence, "R is meant");
  EXPECT_EQ(erratum.effect, "e");
  EXPECT_TRUE(erratum.decidable);
  EXPECT_EQ(erratum.command, "delcert --version");
}

TEST(Erratum, has_one_of_five_kinds) {
  for (const char* kind : {"changes a theorem", "changes a constant", "needs a word", "misprint"})
    EXPECT_EQ(name_of(parse_erratum(with("kind", "kind = '" + std::string(kind) + "'"), "f").judgement), kind);
  EXPECT_EQ(
      message_of(with("kind", "kind = 'wrong'")),
      "file.toml:4:8: a kind is one of \"changes a theorem\", \"changes a constant\", \"needs a word\", \"misprint\", "
      "\"read: holds\", not \"wrong\"");
}

TEST(Erratum, is_refused_with_the_place_of_what_is_wrong) {
  EXPECT_EQ(message_of(with("label", "")), "file.toml:1:1: the key label is missing");
  EXPECT_EQ(message_of(with("label", "lable = 'x'")), "file.toml:1:1: unknown key lable, did you mean label?");
  EXPECT_EQ(message_of(with("printed", "printed = 3")), "file.toml:5:11: the key printed expects a string");
  EXPECT_EQ(message_of(with("wrong", "wrong = ''")), "file.toml:6:9: the key wrong expects a string that is not empty");
  EXPECT_EQ(message_of(with("decidable", "decidable = 'yes'")),
            "file.toml:7:13: the key decidable expects true or false");
  EXPECT_EQ(message_of(with("decidable", "decidable = false")), "file.toml:8:11: a command, but decidable is false");
  EXPECT_EQ(message_of(with("command", "")), "file.toml:1:1: the key command is missing");
  EXPECT_EQ(message_of(with("number", "")), "file.toml:1:1: the key number is missing");
  EXPECT_EQ(message_of(with("defence", "")), "file.toml:1:1: the key defence is missing");
  EXPECT_EQ(message_of(with("kind", "kind = 'read: holds'")),
            "file.toml:7:13: what a computation decides is a claim or a step, not \"read: holds\"");
  EXPECT_NE(message_of("label = ").find("file.toml:1:"), std::string::npos);
}

TEST(Erratum, names_lines_in_order) {
  for (const char* wrong :
       {"", "0", "01", "-3", "12-10", "3-", "3,", "3, 2", "3-7, 7", "3  ,4", "x", "3 4", "1.5", "99999999999"}) {
    EXPECT_EQ(message_of(with("lines", "lines = '" + std::string(wrong) + "'")).substr(0, 12), "file.toml:3:") << wrong;
  }
  EXPECT_EQ(parse_erratum(with("lines", "lines = '7'"), "f").lines, (std::vector<LineRange>{{7, 7}}));
  EXPECT_EQ(parse_erratum(with("lines", "lines = '7,9-9'"), "f").lines, (std::vector<LineRange>{{7, 7}, {9, 9}}));
}

TEST(Erratum, is_sorted_by_line_and_then_by_file) {
  const auto at = [](const std::string& lines, const std::string& file) {
    return parse_erratum(with("lines", "lines = '" + lines + "'"), file);
  };
  std::vector<Erratum> errata{at("20", "a"), at("10-30", "b"), at("10-12", "d"), at("10-12", "c")};
  sort_by_line(errata);
  std::string order;
  for (const Erratum& erratum : errata) order += erratum.file;
  EXPECT_EQ(order, "cdba");
}

TEST(Erratum, files_that_cannot_be_read_are_refused) {
  EXPECT_THROW((void)read_erratum("no-such-file.toml"), InputError);
  const test::TemporaryFolder folder;
  const auto large = folder / "large.toml";
  std::ofstream(large) << std::string((1U << 20U) + 1, '#');
  EXPECT_THROW((void)read_erratum(large), InputError);
}

/// The files of the library are the files of the folder, and the library has them in the order of the paper.
TEST(Erratum, files_of_the_library_are_well_formed_and_in_order) {
  std::size_t files = 0;
  for (const auto& file : std::filesystem::directory_iterator(DELCERT_SOURCE_DIR "/proofs/errata")) {
    if (file.path().extension() != ".toml") continue;
    ++files;
    EXPECT_NO_THROW((void)read_erratum(file.path())) << file.path();
  }
  EXPECT_EQ(builtin_errata_list().size(), files);
  EXPECT_TRUE(std::is_sorted(builtin_errata_list().begin(), builtin_errata_list().end(),
                             [](const Erratum& a, const Erratum& b) { return a.lines[0].first < b.lines[0].first; }));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
