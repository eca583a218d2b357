#pragma once

#include <filesystem>
#include <string_view>

namespace delcert {

/// A file that appears under its name whole or not at all: bytes go to a temporary file in the same folder, which
/// `commit` flushes to the disk and renames. What is not committed is removed again.
///
/// Throws InputError where the file cannot be created, std::system_error where writing fails (a full disk, say);
/// both name the path and the reason.
class AtomicFile {
 public:
  /// An existing file of this name stays as it is until `commit`.
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Precondition: not committed yet.
  void write(std::string_view bytes);
  /// Precondition: not committed yet.
  void commit();

 private:
  [[noreturn]] void fail(const char* action) const;

  std::filesystem::path path_;
  std::filesystem::path temporary_;
  int descriptor_ = -1;
};

/// Creates or replaces the file with these bytes, atomically.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace delcert
