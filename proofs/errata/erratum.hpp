#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace delcert {

/// The judgement on a passage of the paper, the severest first.
enum class Judgement : unsigned char {
  theorem,   ///< a theorem needs a hypothesis that is not stated, or its conclusion does not follow
  constant,  ///< a number changes, or could be better
  word,      ///< what is meant is true, and a reader needs a hypothesis or an argument that is not printed
  misprint,  ///< what is meant is clear
  holds      ///< read, and found to hold: an argument and no computation
};

/// Lines of the paper's LaTeX source, counted from 1; first <= last.
struct LineRange {
  int first = 0;
  int last = 0;
  friend bool operator==(const LineRange&, const LineRange&) = default;
};

/// One finding about the paper: a file of proofs/errata.
struct Erratum {
  std::string file;
  /// The LaTeX label of what it is about, or of the section around it.
  std::string label;
  std::string number;            ///< what LaTeX prints for the label: "Theorem 2", "Section 3.1"
  std::vector<LineRange> lines;  ///< not empty, in increasing order
  Judgement judgement = Judgement::theorem;
  /// The statement as printed, in Markdown. What stands between “ and ” here and below is quoted, with macros expanded.
  std::string printed;
  std::string wrong;    ///< what is wrong with it; where it holds, why
  std::string witness;  ///< a counterexample; may be empty
  std::string mended;   ///< the mended statement and how it is proved; may be empty
  /// The best that the authors could answer, and what remains; not empty where a theorem changes.
  std::string defence;
  std::string effect;  ///< what it does to the theorems that use it; may be empty
  /// Whether a computation decides it.
  bool decidable = false;
  /// What reproduces that it is wrong, from the root of the sources: its exit status is 1. Empty unless decidable.
  std::string command;
};

/// Reads a finding. The keys are those of docs/cli.md, all values strings but `decidable`; `kind` is a judgement by
/// name; `lines` is "17", "17-23" or several of these with commas between them. Throws InputError, "file:line:column:
/// what is wrong", for anything else: an unknown or missing key, empty required text, a wrong type, lines out of order,
/// a decidable finding without a command, a command for one that is not, a computation for one that holds, a change of
/// a theorem without a defence.
[[nodiscard]] Erratum parse_erratum(const std::string& text, const std::string& file);

/// The same from a file. Throws InputError also if it cannot be read or is larger than 1 MiB.
[[nodiscard]] Erratum read_erratum(const std::string& file);

/// All findings of the library, in the order of the paper; those of one place in the order of their files' names.
[[nodiscard]] const std::vector<Erratum>& builtin_errata_list();

/// Sorts into that order.
void sort_by_line(std::vector<Erratum>& errata);

/// "changes a theorem", "changes a constant", "needs a word", "misprint", "read: holds".
[[nodiscard]] std::string_view name_of(Judgement judgement);

}  // namespace delcert
