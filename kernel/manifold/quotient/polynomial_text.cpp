#include "kernel/manifold/quotient/polynomial_text.hpp"

#include <algorithm>
#include <string>

#include "kernel/number/exact_text.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

class PolynomialReader {
 public:
  explicit PolynomialReader(std::string_view text) : text_(text) {}

  std::vector<Rational> read() {
    std::vector<bool> seen;
    std::vector<Rational> result;
    skip_blanks();
    bool negative = take('-');
    while (true) {
      skip_blanks();
      const std::size_t start = at_;
      const Term term = this->term();
      const auto power = static_cast<std::size_t>(term.power);
      if (power >= result.size()) {
        result.resize(power + 1);
        seen.resize(power + 1);
      }
      if (seen[power]) fail(start, "the first term with t^" + std::to_string(power));
      seen[power] = true;
      result[power] = negative ? -term.factor : term.factor;
      skip_blanks();
      if (at_ == text_.size()) return result;
      if (take('-')) {
        negative = true;
      } else if (take('+')) {
        negative = false;
      } else {
        fail(at_, "\"+\", \"-\" or the end");
      }
    }
  }

 private:
  struct Term {
    Rational factor;
    int power;
  };

  [[noreturn]] void fail(std::size_t at, const std::string& expected) const {
    const std::string found =
        at < text_.size() ? "\"" + std::string(text_.substr(at, 1)) + "\"" : std::string("the end");
    throw InputError("\"" + std::string(text_.substr(0, 80)) + "\" at character " + std::to_string(at + 1) +
                     ": found " + found + ", expected " + expected);
  }

  void skip_blanks() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  bool take(char c) {
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  std::string_view number() {
    const std::size_t start = at_;
    while (at_ < text_.size() && ((text_[at_] >= '0' && text_[at_] <= '9') || text_[at_] == '/')) ++at_;
    return text_.substr(start, at_ - start);
  }

  Term term() {
    Term result{Rational(1), 0};
    const std::size_t start = at_;
    const std::string_view digits = number();
    if (!digits.empty()) {
      try {
        result.factor = parse_exact(digits);
      } catch (const ExactTextError& error) {
        fail(start + error.position(), error.expected());
      }
      if (!take('*')) return result;
    }
    if (!take('t')) fail(at_, digits.empty() ? "a number or \"t\"" : "\"t\"");
    result.power = take('^') ? exponent() : 1;
    return result;
  }

  int exponent() {
    const std::size_t start = at_;
    int result = 0;
    while (at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9' && at_ - start < 3)
      result = 10 * result + (text_[at_++] - '0');
    if (at_ == start) fail(at_, "an exponent of at most three digits");
    return result;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<Rational> parse_polynomial(std::string_view text) { return PolynomialReader(text).read(); }

}  // namespace delcert
