#include <fmt/format.h>
#include <pybind11/pybind11.h>

#include "delcert_version.hpp"
#include "kernel/number/self_test.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/exceptions.hpp"
#include "python/bindings/parts.hpp"
#include "support/build_commit.hpp"

// Rigour rests on rounding that is really directed, on no contraction, on the libraries: refuse to go on without.
PYBIND11_MODULE(_delcert, module) {
  using namespace delcert::python;
  const auto failures = [] {
    const StartingEnvironment environment;
    return delcert::arithmetic_self_test();
  }();
  if (!failures.empty())
    throw pybind11::import_error(fmt::format("delcert: arithmetic self-test: {}", fmt::join(failures, "; ")));
  module.attr("version") = delcert::version;
  module.attr("build_commit") = delcert::build_commit();
  translate_exceptions();
  add_certification(module);
  add_certificate(module);
  add_claims(module);
  add_constants(module);
}
