#pragma once

#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "kernel/number/rational.hpp"
#include "kernel/simplex/vector.hpp"

namespace delcert {

/// What one rank sends to another: bytes of machines of one kind. They are written and read in the same order.
using Message = std::string;

class MessageWriter {
 public:
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void put(const T& value) { text_.append(reinterpret_cast<const char*>(&value), sizeof(value)); }
  void put(const Rational& x);
  void put(const std::string& text);
  template <std::size_t m>
  void put(const std::array<Rational, m>& x) {
    for (const Rational& coordinate : x) put(coordinate);
  }

  [[nodiscard]] bool is_empty() const { return text_.empty(); }
  [[nodiscard]] Message take() { return std::move(text_); }

 private:
  Message text_;
};

/// Throws std::runtime_error if a message ends too early, or if a text in it is not a number where one is read.
class MessageReader {
 public:
  /// The message must outlive it.
  explicit MessageReader(const Message& message) : message_(message) {}

  template <class T>
  requires std::is_trivially_copyable_v<T>
  [[nodiscard]] T get() {
    T value;
    std::memcpy(&value, bytes(sizeof(value)), sizeof(value));
    return value;
  }
  [[nodiscard]] Rational get_rational();
  [[nodiscard]] std::string get_text();
  template <std::size_t m>
  [[nodiscard]] std::array<Rational, m> get_point() {
    std::array<Rational, m> result;
    for (Rational& coordinate : result) coordinate = get_rational();
    return result;
  }
  [[nodiscard]] bool is_at_end() const { return at_ == message_.size(); }
  [[nodiscard]] std::size_t position() const { return at_; }

 private:
  const char* bytes(std::size_t count);

  const Message& message_;
  std::size_t at_ = 0;
};

}  // namespace delcert
