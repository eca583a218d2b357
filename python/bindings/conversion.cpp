#include "python/bindings/conversion.hpp"

#include "kernel/number/exact_text.hpp"

namespace delcert::python {

namespace py = pybind11;

namespace {

/// Base 16: Python reads no decimal number of more than 4300 digits.
py::object integer_of(const Integer& x) {
  const std::string digits = (x < 0 ? Integer(-x) : x).str(0, std::ios_base::hex);
  const auto result = py::reinterpret_steal<py::object>(PyLong_FromString(digits.c_str(), nullptr, 16));
  if (!result) throw py::error_already_set();
  return x < 0 ? py::object(-result) : result;
}

}  // namespace

py::object fraction_of(const Rational& x) {
  static const py::handle made = py::object(py::module_::import("fractions").attr("Fraction")).release();
  return made(integer_of(x.numerator()), integer_of(x.denominator()));
}

py::tuple fractions_of(const std::vector<Rational>& numbers) {
  py::tuple result(numbers.size());
  for (std::size_t at = 0; at < numbers.size(); ++at) result[at] = fraction_of(numbers[at]);
  return result;
}

Rational rational_of(const std::string& text) { return parse_exact(text); }

}  // namespace delcert::python
