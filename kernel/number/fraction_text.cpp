#include "kernel/number/fraction_text.hpp"

namespace delcert {

std::string fraction_text(const Rational& x) {
  return x.numerator().str() + (x.denominator() == 1 ? "" : "/" + x.denominator().str());
}

}  // namespace delcert
