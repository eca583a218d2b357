#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace delcert {

/// Where the bytes of a certificate go: hashed, compressed if the name ends in ".zst", and into a file that appears
/// whole or not at all. Nothing is held in memory but a buffer.
class ByteSink {
 public:
  /// Throws InputError if the file cannot be created.
  explicit ByteSink(const std::filesystem::path& path);
  ~ByteSink();
  ByteSink(const ByteSink&) = delete;
  ByteSink& operator=(const ByteSink&) = delete;

  void write(std::string_view bytes);
  /// SHA-256 of what was written so far, as 64 lower-case hexadecimal digits.
  [[nodiscard]] std::string digest() const;
  /// Flushes and renames. Nothing may be written afterwards.
  void commit();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace delcert
