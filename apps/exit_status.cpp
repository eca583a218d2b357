#include "apps/exit_status.hpp"

#include <exception>
#include <new>

#include "apps/interruption.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

ExitStatus report(std::ostream& errors, const std::string& message, ExitStatus status) {
  report_error(errors, message);
  return status;
}

}  // namespace

void report_error(std::ostream& errors, const std::string& message) {
  errors << "delcert: error: " << message << std::endl;
}

ExitStatus run_reporting(const Action& action, std::ostream& errors) {
  try {
    return action();
  } catch (const Rejection& rejection) {
    return report(errors, rejection.what(), ExitStatus::rejected);
  } catch (const Undecided& undecided) {
    return report(errors, undecided.what(), ExitStatus::undecided);
  } catch (const InputError& malformed) {
    return report(errors, malformed.what(), ExitStatus::malformed);
  } catch (const Interrupted& interrupted) {
    return report(errors, interrupted.what(), ExitStatus::interrupted);
  } catch (const std::bad_alloc&) {
    return report(errors, "internal: out of memory", ExitStatus::internal);
  } catch (const std::exception& error) {
    return report(errors, std::string("internal: ") + error.what(), ExitStatus::internal);
  } catch (...) {
    return report(errors, "internal: an exception of unknown type", ExitStatus::internal);
  }
}

}  // namespace delcert
