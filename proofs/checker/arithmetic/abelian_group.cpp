#include "proofs/checker/arithmetic/abelian_group.hpp"

#include <algorithm>

#include "proofs/checker/arithmetic/exact_number.hpp"

namespace delcert::checker {
namespace {

bool pass(std::string_view& text, std::string_view literal) {
  if (!text.starts_with(literal)) return false;
  text.remove_prefix(literal.size());
  return true;
}

/// The number greater than 1 with which the text begins, without leading zeros; empty if there is none.
std::string pass_number(std::string_view& text) {
  const std::string digits(text.substr(0, std::min(text.find_first_not_of("0123456789"), text.size())));
  if (digits.empty() || digits.size() > 1000 || digits[0] == '0' || digits == "1") return {};
  text.remove_prefix(digits.size());
  return digits;
}

bool divides(const std::string& a, const std::string& b) {
  return fmpz_is_one(fmpq_denref((exact_value(b) / exact_value(a)).raw())) != 0;
}

}  // namespace

bool is_group(std::string_view text) {
  if (text == "0") return true;
  std::string before = "1", order;
  for (bool first = true;; first = false, before = order) {
    if (pass(text, "(Z/")) {
      order = pass_number(text);
      if (!pass(text, ")^") || pass_number(text).empty()) return false;
    } else if (pass(text, "Z/")) {
      order = pass_number(text);
    } else {
      if (!first || !pass(text, "Z") || (pass(text, "^") && pass_number(text).empty())) return false;
      order = "1";
    }
    if (order.empty() || (!first && order == before) || !divides(before, order)) return false;
    if (text.empty()) return true;
    if (!pass(text, " + ")) return false;
  }
}

std::string group_text(std::size_t free_rank, const std::vector<std::string>& torsion) {
  std::string text;
  const auto add = [&text](const std::string& summand) { text += (text.empty() ? "" : " + ") + summand; };
  if (free_rank > 0) add(free_rank == 1 ? "Z" : "Z^" + std::to_string(free_rank));
  for (auto first = torsion.begin(); first != torsion.end();) {
    const auto last = std::find_if(first, torsion.end(), [&](const std::string& order) { return order != *first; });
    add(last - first == 1 ? "Z/" + *first : "(Z/" + *first + ")^" + std::to_string(last - first));
    first = last;
  }
  return text.empty() ? "0" : text;
}

}  // namespace delcert::checker
