#include "proofs/errata/errata_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <sstream>

#include "proofs/errata/verdicts.hpp"

namespace delcert {

namespace {

constexpr const char* head_of_page = R"(# Errata

Remarks of a reader on *Delaunay triangulation of manifolds* by Boissonnat, Dyer and Ghosh. **Which text:** the LaTeX source
of a preprint, whose comments have dates from 2013 to October 2014. The article of the same name, published in 2017, was not
compared; its abstract differs, and nothing is known here of what it changed.

The verdicts come first, then the remarks, the severest kind first. Lines are those of the LaTeX source; theorems have the
numbers that LaTeX gives them, and their labels. What stands between “ and ” is the paper's, word for word with its macros expanded (so the
transition from U_i to U_j is φ_ji), with […] where something is left out and labels in brackets for references; a test
compares these quotations with the source, and the paragraphs marked as printed have nothing else in them. All other words are ours.
*Ours* is a step that computes what the text implies, and is no formula of the text.

This page is what `delcert errata` prints, out of the files of `proofs/errata/`; a test compares them. Where a command
stands, it reproduces the finding, from the root of the sources and with exit status 1, and a test runs it; what has none was
read, and rests on the argument given. An entry that changes a theorem also has the best defence that we found for the printed text.
)";

/// What the lines of a finding are lines of.
constexpr const char* text_that_was_read =
    "the LaTeX source of a preprint of Delaunay triangulation of manifolds, with dates from 2013 to October 2014 in "
    "its "
    "comments; the article of 2017 was not compared";

/// The severest first.
constexpr std::array wrong_judgements{Judgement::theorem, Judgement::constant, Judgement::word, Judgement::misprint};

/// The text without line breaks: paragraphs and cells are one line each.
std::string on_one_line(const std::string& text) {
  std::istringstream words(text);
  std::string result;
  for (std::string word; words >> word;) result += (result.empty() ? "" : " ") + word;
  return result;
}

/// The text in a cell of a table, where a bar would end it.
std::string in_cell(const std::string& text) {
  std::string result;
  for (const char c : on_one_line(text)) result += c == '|' ? std::string("\\|") : std::string(1, c);
  return result;
}

std::string place(const Erratum& erratum) {
  const bool one = erratum.lines.size() == 1 && erratum.lines[0].first == erratum.lines[0].last;
  return erratum.number + (one ? ", line " : ", lines ") + lines_text(erratum.lines) + ", " + erratum.label;
}

std::string section(const Erratum& erratum) {
  std::string text = fmt::format("\n### {}: {}\n", place(erratum), name_of(erratum.judgement));
  const auto paragraph = [&](const char* heading, const std::string& content) {
    if (!content.empty()) text += fmt::format("\n**{}.** {}\n", heading, on_one_line(content));
  };
  text += fmt::format("\n> **Printed.** {}\n", on_one_line(erratum.printed));
  paragraph("Remark", erratum.wrong);
  paragraph("Witness", erratum.witness);
  paragraph("Mended", erratum.mended);
  paragraph("In the authors' defence", erratum.defence);
  paragraph("Effect", erratum.effect);
  if (erratum.decidable) text += "\n```\n" + on_one_line(erratum.command) + "\n```\n";
  return text;
}

std::string counts(const std::vector<Erratum>& errata) {
  std::string text = "\n| kind | findings | of these with a command |\n|---|--:|--:|\n";
  const auto row = [&](Judgement judgement) {
    std::size_t all = 0;
    std::size_t decidable = 0;
    for (const Erratum& erratum : errata) {
      if (erratum.judgement != judgement) continue;
      ++all;
      if (erratum.decidable) ++decidable;
    }
    text += fmt::format("| {} | {} | {} |\n", name_of(judgement), all, decidable);
  };
  for (const Judgement judgement : wrong_judgements) row(judgement);
  row(Judgement::holds);
  return text;
}

}  // namespace

std::string errata_markdown(const std::vector<Erratum>& errata) {
  std::string text = head_of_page + verdicts_markdown() + "\n## Remarks\n" + counts(errata);
  for (const Judgement judgement : wrong_judgements)
    for (const Erratum& erratum : errata)
      if (erratum.judgement == judgement) text += section(erratum);
  std::string read;
  for (const Erratum& erratum : errata)
    if (erratum.judgement == Judgement::holds)
      read += fmt::format("| {} | {} | {} | {} | {} |\n", lines_text(erratum.lines), erratum.number, erratum.label,
                          in_cell(erratum.printed), in_cell(erratum.wrong));
  if (!read.empty())
    text +=
        "\n## Read, and found to hold\n\n| lines | place | label | what is printed, in our words | why it holds "
        "|\n|---|---|---|---|---|\n" +
        read;
  return text;
}

std::string errata_json(const std::vector<Erratum>& errata) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Erratum& erratum : errata) {
    list.push_back({{"file", erratum.file},
                    {"label", erratum.label},
                    {"number", erratum.number},
                    {"lines", lines_text(erratum.lines)},
                    {"kind", name_of(erratum.judgement)},
                    {"printed", erratum.printed},
                    {"wrong", erratum.wrong},
                    {"witness", erratum.witness},
                    {"mended", erratum.mended},
                    {"defence", erratum.defence},
                    {"effect", erratum.effect},
                    {"decidable", erratum.decidable},
                    {"command", erratum.command}});
  }
  return nlohmann::ordered_json{{"text", text_that_was_read}, {"errata", std::move(list)}}.dump(2) + "\n";
}

std::string lines_text(const std::vector<LineRange>& lines) {
  std::string text;
  for (const LineRange& range : lines) {
    text += (text.empty() ? "" : ", ") + std::to_string(range.first);
    if (range.last != range.first) text += "-" + std::to_string(range.last);
  }
  return text;
}

}  // namespace delcert
