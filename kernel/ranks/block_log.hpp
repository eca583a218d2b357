#pragma once

#include <filesystem>
#include <fstream>
#include <vector>

#include "kernel/ranks/message.hpp"

namespace delcert {

/// A file to which a process adds what it has finished, piece by piece, so that another one can go on from there if it
/// is killed. A piece that was not written to its end is not there.
class BlockLog {
 public:
  /// Reads what is there, or makes the file. `origin` says what the pieces are of. Throws InputError if the file is of
  /// something else, or cannot be made.
  BlockLog(std::filesystem::path path, const std::string& origin);

  [[nodiscard]] const std::vector<Message>& pieces() const { return pieces_; }
  /// Takes away all pieces but the first of them.
  void keep(std::size_t count);
  /// The operating system has it when this returns.
  void add(Message piece);

 private:
  void open();

  std::filesystem::path path_;
  std::vector<Message> pieces_;
  std::vector<std::uintmax_t> ends_;  // in the file: of the origin, of the pieces
  std::ofstream out_;
};

/// A 64-bit checksum (FNV-1a), for what may be cut off or confused, not for what is altered on purpose.
[[nodiscard]] std::uint64_t checksum_of(const Message& bytes);

}  // namespace delcert
