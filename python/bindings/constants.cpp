#include <pybind11/stl.h>

#include "proofs/constants/ledger_entries.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/conversion.hpp"
#include "python/bindings/parts.hpp"

namespace delcert::python {

namespace py = pybind11;

namespace {

py::object bounds_of(const Bounds& bounds) {
  return py::make_tuple(fraction_of(bounds.lower), fraction_of(bounds.upper));
}

/// Exact numbers as texts; no perturbation: the largest.
py::list constants(int dimension, const std::string& separation, const std::optional<std::string>& perturbation,
                   const std::string& radius_variation, const std::string& distortion) {
  const Rational mu = rational_of(separation);
  const Rational variation = rational_of(radius_variation);
  const Rational xi = rational_of(distortion);
  const Rational rho = perturbation ? rational_of(*perturbation) : largest_perturbation(mu, variation, xi);
  const auto entries =
      apart([&] { return ledger_entries(constants_for(Dimension(dimension), mu, rho, variation, xi)); });
  py::list result;
  for (const LedgerEntry& entry : entries) {
    py::dict row;
    row["name"] = entry.name;
    row["symbol"] = entry.symbol;
    row["latex_symbol"] = entry.latex_symbol;
    row["exact"] = entry.exact;
    row["exact_latex"] = entry.exact_latex;
    row["value"] = bounds_of(entry.value);
    row["log2"] = entry.log2 ? bounds_of(*entry.log2) : py::none();
    row["source"] = entry.source;
    row["is_estimate"] = entry.is_estimate;
    result.append(row);
  }
  return result;
}

}  // namespace

void add_constants(py::module_& module) { module.def("constants", &constants); }

}  // namespace delcert::python
