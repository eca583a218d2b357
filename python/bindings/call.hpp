#pragma once

#include <pybind11/pybind11.h>

#include <cfenv>
#include <chrono>
#include <stdexcept>
#include <string>

#include "support/progress.hpp"

namespace delcert::python {

/// While one of these lives, this thread has the floating-point environment that a program starts with, which certified
/// arithmetic expects: rounding to nearest, and no number flushed to zero, whatever other modules have set. What the
/// caller had is restored at the end, also when that is an exception.
class [[nodiscard]] StartingEnvironment {
 public:
  StartingEnvironment();
  ~StartingEnvironment();
  StartingEnvironment(const StartingEnvironment&) = delete;
  StartingEnvironment& operator=(const StartingEnvironment&) = delete;

 private:
  std::fenv_t of_caller_{};
};

/// Thrown through long work that Python has ended: what was raised is kept in the `Caller`.
class Ended : public std::runtime_error {
 public:
  Ended() : std::runtime_error("ended by the caller") {}
};

/// The Python code that waits for long work: is asked now and then for signals (Ctrl-C), and told how far the work is.
class Caller {
 public:
  /// `told`: None, or what is called with a stage, what is done of it, and all of it.
  explicit Caller(pybind11::object told) : told_(std::move(told)) {}
  /// For work without the interpreter's lock, in the thread that has let go of it. Throws Ended. Valid while this
  /// object lives.
  [[nodiscard]] Progress progress();
  /// Throws what Python has raised, if it has.
  void throw_what_was_raised();

 private:
  void tell(std::string_view stage, std::size_t done, std::size_t total);
  [[noreturn]] void keep_what_is_raised();

  pybind11::object told_;
  pybind11::object type_, value_, trace_;
  bool has_raised_ = false;
  std::string stage_;
  std::chrono::steady_clock::time_point last_;
};

/// Does work without the interpreter's lock, so that other threads of Python go on, in a `StartingEnvironment`.
/// `work(progress)` may touch nothing of Python.
template <class Work>
auto apart(const pybind11::object& told, const Work& work) {
  Caller caller(told);
  try {
    const StartingEnvironment environment;
    const pybind11::gil_scoped_release release;
    return work(caller.progress());
  } catch (...) {
    caller.throw_what_was_raised();
    throw;
  }
}

/// The same for work that does not report.
template <class Work>
auto apart(const Work& work) {
  const StartingEnvironment environment;
  const pybind11::gil_scoped_release release;
  return work();
}

}  // namespace delcert::python
