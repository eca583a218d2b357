#include "proofs/checker/certificate/expectation.hpp"

#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "proofs/checker/arithmetic/exact_number.hpp"

namespace delcert::checker {
namespace {

using Json = nlohmann::json;

/// Coefficients of a number that are left out are 0.
bool are_equal(const Json& a, const Json& b) {
  if (a.is_array() && b.is_array()) {
    const Json zero = "0";
    for (std::size_t k = 0; k < std::max(a.size(), b.size()); ++k) {
      if (!are_equal(k < a.size() ? a[k] : zero, k < b.size() ? b[k] : zero)) return false;
    }
    return true;
  }
  if (a.is_object() && b.is_object()) {
    if (a.size() != b.size()) return false;
    for (const auto& [key, value] : a.items()) {
      if (!b.contains(key) || !are_equal(value, b[key])) return false;
    }
    return true;
  }
  if (!a.is_string() || !b.is_string()) return a == b;
  const std::string x = a.get<std::string>(), y = b.get<std::string>();
  return is_exact_number(x) && is_exact_number(y) ? exact_value(x) == exact_value(y) : x == y;
}

Rational number_at(const Json& list, std::size_t k) { return exact_value(list.at(k).get<std::string>()); }

/// Both intervals have one root of the polynomial, at which it changes its sign: the same one if it does so where they
/// overlap.
bool have_the_same_root(const Json& field, const Json& a, const Json& b) {
  const Rational lower = maximum(number_at(a, 0), number_at(b, 0)),
                 upper = -maximum(-number_at(a, 1), -number_at(b, 1));
  const auto sign = [&](const Rational& x) {
    Rational sum(0);
    for (std::size_t k = field.size(); k-- > 0;) sum = sum * x + number_at(field, k);
    return sum.sign();
  };
  return less(lower, upper) == Verdict::proved && sign(lower) * sign(upper) < 0;
}

}  // namespace

std::string difference_from_expected(std::string_view document, std::string_view block) {
  const Json stated = Json::parse(block);
  Json expected = Json::parse(document, nullptr, false);
  if (expected.is_object() && expected.contains("manifold")) expected = Json(expected["manifold"]);
  if (!expected.is_object() || !expected.contains("family"))
    throw std::invalid_argument("what is expected is neither a certificate nor the manifold block of one");
  const std::set<std::string> chosen = {
      "name", "injectivity_radius", "rounding", "patch_radius", "metric_distortion", "root", "slope", "vertices"};
  std::set<std::string> keys;
  for (const auto& [key, value] : stated.items()) keys.insert(key);
  for (const auto& [key, value] : expected.items()) keys.insert(key);
  for (const std::string& key : keys) {
    if (chosen.contains(key)) continue;
    if (!stated.contains(key) || !expected.contains(key) || !are_equal(stated[key], expected[key])) return key;
  }
  if (stated.contains("root")) {
    try {
      if (!have_the_same_root(stated["field"], stated["root"], expected.at("root"))) return "root";
    } catch (const Json::exception&) {
      return "root";
    }
  }
  return "";
}

}  // namespace delcert::checker
