#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "kernel/number/rational.hpp"

namespace delcert::python {

/// A fractions.Fraction.
[[nodiscard]] pybind11::object fraction_of(const Rational& x);
[[nodiscard]] pybind11::tuple fractions_of(const std::vector<Rational>& numbers);

/// The exact number of a text, as docs/cli.md has them. Throws ExactTextError.
[[nodiscard]] Rational rational_of(const std::string& text);

/// An array of so many columns, row by row. Precondition: the columns divide the numbers.
template <class To, class From>
[[nodiscard]] pybind11::array_t<To> table_of(const std::vector<From>& numbers, std::size_t columns) {
  const auto rows = static_cast<pybind11::ssize_t>(columns == 0 ? 0 : numbers.size() / columns);
  pybind11::array_t<To> result({rows, static_cast<pybind11::ssize_t>(columns)});
  To* place = result.mutable_data();
  for (const From& number : numbers) *place++ = static_cast<To>(number);
  return result;
}
template <class To, class From>
[[nodiscard]] pybind11::array_t<To> array_of(const std::vector<From>& numbers) {
  pybind11::array_t<To> result(static_cast<pybind11::ssize_t>(numbers.size()));
  To* place = result.mutable_data();
  for (const From& number : numbers) *place++ = static_cast<To>(number);
  return result;
}

}  // namespace delcert::python
