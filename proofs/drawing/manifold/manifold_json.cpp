#include "proofs/drawing/manifold/manifold_json.hpp"

#include "kernel/number/exact_text.hpp"
#include "support/error.hpp"

namespace delcert {

nlohmann::ordered_json manifold_json(const CertificateSummary& certificate) {
  try {
    return nlohmann::ordered_json::parse(certificate.manifold_text);
  } catch (const nlohmann::ordered_json::exception& error) {
    throw InputError(std::string("manifold: ") + error.what());
  }
}

double number_of(const nlohmann::ordered_json& text) {
  return approximate_double(parse_exact(text.get<std::string>()));
}

std::vector<double> numbers_of(const nlohmann::ordered_json& texts) {
  std::vector<double> result;
  for (const auto& text : texts) result.push_back(number_of(text));
  return result;
}

std::vector<double> doubles_of(const std::vector<Rational>& exact) {
  std::vector<double> result;
  result.reserve(exact.size());
  for (const Rational& number : exact) result.push_back(approximate_double(number));
  return result;
}

double value_of(const std::vector<double>& polynomial, double at) {
  double result = 0;
  for (std::size_t k = polynomial.size(); k-- > 0;) result = result * at + polynomial[k];
  return result;
}

double root_of(const std::vector<double>& polynomial, double from, double to) {
  const bool is_positive = value_of(polynomial, to) > 0;
  for (int halvings = 0; halvings < 200; ++halvings) {
    const double middle = from + (to - from) / 2;
    if (value_of(polynomial, middle) == 0) return middle;
    ((value_of(polynomial, middle) > 0) == is_positive ? to : from) = middle;
  }
  return from + (to - from) / 2;
}

}  // namespace delcert
