#include "python/bindings/exceptions.hpp"

#include <pybind11/pybind11.h>

#include <exception>
#include <string>

#include "kernel/number/exact_text.hpp"
#include "support/error.hpp"

namespace delcert::python {

namespace py = pybind11;

namespace {

void raise(const char* kind, const std::string& message) {
  const py::object made = py::module_::import("delcert.errors").attr("made")(kind, message);
  PyErr_SetObject(py::type::handle_of(made).ptr(), made.ptr());
}

}  // namespace

void translate_exceptions() {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const ExactTextError& error) {
      raise("Usage", error.what());
    } catch (const Rejection& error) {
      raise("Refuted", error.what());
    } catch (const Undecided& error) {
      raise("Undecided", error.what());
    } catch (const InputError& error) {
      raise("MalformedInput", error.what());
    }
  });
}

}  // namespace delcert::python
