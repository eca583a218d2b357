#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "proofs/certificate/reader.hpp"

namespace delcert {

/// The key `manifold` of a certificate. Throws InputError where it is not JSON.
[[nodiscard]] nlohmann::ordered_json manifold_json(const CertificateSummary& certificate);

/// An exact number, as a double next to it.
[[nodiscard]] double number_of(const nlohmann::ordered_json& text);
[[nodiscard]] std::vector<double> numbers_of(const nlohmann::ordered_json& texts);
[[nodiscard]] std::vector<double> doubles_of(const std::vector<Rational>& exact);

/// The root between two numbers of a polynomial, by bisection: the number that the elements of a field are polynomials
/// in. Precondition: as form.field of docs/certificate-format.md asks.
[[nodiscard]] double root_of(const std::vector<double>& polynomial, double from, double to);
[[nodiscard]] double value_of(const std::vector<double>& polynomial, double at);

}  // namespace delcert
