#include "kernel/ranks/message.hpp"

#include "kernel/number/exact_text.hpp"

namespace delcert {

namespace {

/// A number that is a double is sent as one, which coordinates of nets and most of those of perturbed points are.
enum class NumberForm : unsigned char { as_double, as_text };

}  // namespace

void MessageWriter::put(const Rational& x) {
  const double near = approximate_double(x);
  if (Rational::exactly(near) == x) {
    put(NumberForm::as_double);
    put(near);
  } else {
    put(NumberForm::as_text);
    put(exact_text(x));
  }
}

void MessageWriter::put(const std::string& text) {
  put(static_cast<std::uint64_t>(text.size()));
  text_ += text;
}

Rational MessageReader::get_rational() {
  switch (get<NumberForm>()) {
    case NumberForm::as_double: {
      const auto value = get<double>();
      // `Rational::exactly` would throw std::domain_error, which is not the error that this class promises.
      if (!(value - value == 0)) throw std::runtime_error("a message between ranks has a number that is not finite");
      return Rational::exactly(value);
    }
    case NumberForm::as_text:
      return parse_exact(get_text());
  }
  throw std::runtime_error("a message between ranks has something else in the place of a number");
}

std::string MessageReader::get_text() {
  const auto size = get<std::uint64_t>();
  return {bytes(size), size};
}

const char* MessageReader::bytes(std::size_t count) {
  if (count > message_.size() - at_) throw std::runtime_error("a message between ranks ends too early");
  const char* const result = message_.data() + at_;
  at_ += count;
  return result;
}

}  // namespace delcert
