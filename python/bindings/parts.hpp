#pragma once

#include <pybind11/pybind11.h>

namespace delcert::python {

// The parts of the module `_delcert`; python/delcert/ is what users see.

void add_certification(pybind11::module_& module);
void add_certificate(pybind11::module_& module);
void add_claims(pybind11::module_& module);
void add_constants(pybind11::module_& module);

}  // namespace delcert::python
