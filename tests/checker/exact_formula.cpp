#include "tests/checker/exact_formula.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace delcert::checker_tests {
namespace {

using Value = std::optional<Rational>;

class Reader {
 public:
  Reader(const std::string& text, const std::vector<std::string>& variables, const std::vector<Rational>& point)
      : text_(text), variables_(variables), point_(point) {}

  Value whole() {
    const Value result = sum();
    if (at_ != text_.size()) throw std::invalid_argument("no formula: " + text_);
    return result;
  }

 private:
  bool takes(char c) {
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  Value sum() {
    Value result = product();
    while (true) {
      const bool is_plus = takes('+');
      if (!is_plus && !takes('-')) return result;
      const Value next = product();
      if (!result || !next) {
        result.reset();
      } else {
        result = is_plus ? *result + *next : *result - *next;
      }
    }
  }
  Value product() {
    Value result = factor();
    while (true) {
      const bool is_times = takes('*');
      if (!is_times && !takes('/')) return result;
      const Value next = factor();
      if (!result || !next || (!is_times && *next == Rational(0))) {
        result.reset();
      } else {
        result = is_times ? *result * *next : *result / *next;
      }
    }
  }
  Value factor() {
    if (takes('-')) {
      const Value result = factor();
      return result ? Value(-*result) : result;
    }
    const Value base = atom();
    if (!takes('^')) return base;
    const std::string exponent = digits();
    return base ? Value(power(*base, std::stol(exponent))) : base;
  }
  Value atom() {
    if (takes('(')) return closed();
    const std::size_t begin = at_;
    if (at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])) != 0)
      return Rational(Integer(digits()));
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '_'))
      ++at_;
    const std::string name = text_.substr(begin, at_ - begin);
    if (name == "abs" && takes('(')) {
      const Value inside = closed();
      return inside ? Value(absolute(*inside)) : inside;
    }
    const auto found = std::find(variables_.begin(), variables_.end(), name);
    if (found == variables_.end()) throw std::invalid_argument("no variable: " + name);
    return point_.at(static_cast<std::size_t>(found - variables_.begin()));
  }
  Value closed() {
    const Value result = sum();
    if (!takes(')')) throw std::invalid_argument("a parenthesis is open: " + text_);
    return result;
  }
  std::string digits() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    if (at_ == begin) throw std::invalid_argument("no number: " + text_);
    // Zeros in front would make the number octal.
    const std::size_t first = std::min(text_.find_first_not_of('0', begin), at_ - 1);
    return text_.substr(first, at_ - first);
  }

  const std::string& text_;
  const std::vector<std::string>& variables_;
  const std::vector<Rational>& point_;
  std::size_t at_ = 0;
};

}  // namespace

std::optional<Rational> exact_value(const std::string& formula, const std::vector<std::string>& variables,
                                    const std::vector<Rational>& point) {
  return Reader(formula, variables, point).whole();
}

}  // namespace delcert::checker_tests
