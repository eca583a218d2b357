#include "python/bindings/call.hpp"

namespace delcert::python {

namespace py = pybind11;

StartingEnvironment::StartingEnvironment() {
  std::fegetenv(&of_caller_);
  std::fesetenv(FE_DFL_ENV);
}

StartingEnvironment::~StartingEnvironment() { std::fesetenv(&of_caller_); }

Progress Caller::progress() {
  return [this](std::string_view stage, std::size_t done, std::size_t total) { tell(stage, done, total); };
}

void Caller::tell(std::string_view stage, std::size_t done, std::size_t total) {
  constexpr std::chrono::milliseconds between(50);
  const auto now = std::chrono::steady_clock::now();
  if (stage == stage_ && now - last_ < between) return;
  stage_ = stage;
  last_ = now;
  const py::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() != 0) keep_what_is_raised();
  if (told_.is_none()) return;
  try {
    told_(stage_, done, total);
  } catch (py::error_already_set& error) {
    error.restore();
    keep_what_is_raised();
  }
}

void Caller::keep_what_is_raised() {
  PyObject* type = nullptr;
  PyObject* value = nullptr;
  PyObject* trace = nullptr;
  PyErr_Fetch(&type, &value, &trace);
  type_ = py::reinterpret_steal<py::object>(type);
  value_ = py::reinterpret_steal<py::object>(value);
  trace_ = py::reinterpret_steal<py::object>(trace);
  has_raised_ = true;
  throw Ended();
}

void Caller::throw_what_was_raised() {
  if (!has_raised_) return;
  has_raised_ = false;
  PyErr_Restore(type_.release().ptr(), value_.release().ptr(), trace_.release().ptr());
  throw py::error_already_set();
}

}  // namespace delcert::python
