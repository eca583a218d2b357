#include "kernel/ranks/block_log.hpp"

#include <iterator>
#include <optional>

#include "support/error.hpp"

namespace delcert {

namespace {

constexpr std::size_t size_of_ends = 2 * sizeof(std::uint64_t);

/// The next piece of a file, if it is whole: its size, its bytes, their checksum.
std::optional<Message> next_piece(const Message& file, std::size_t& at) {
  if (file.size() - at < size_of_ends) return std::nullopt;
  const Message rest_size = file.substr(at, sizeof(std::uint64_t));
  const auto size = MessageReader(rest_size).get<std::uint64_t>();
  if (size > file.size() - at - size_of_ends) return std::nullopt;
  Message piece = file.substr(at + sizeof(std::uint64_t), size);
  const Message sum = file.substr(at + sizeof(std::uint64_t) + size, sizeof(std::uint64_t));
  if (MessageReader(sum).get<std::uint64_t>() != checksum_of(piece)) return std::nullopt;
  at += size + size_of_ends;
  return piece;
}

}  // namespace

std::uint64_t checksum_of(const Message& bytes) {
  std::uint64_t result = 14695981039346656037ULL;
  for (const char byte : bytes) result = (result ^ static_cast<unsigned char>(byte)) * 1099511628211ULL;
  return result;
}

BlockLog::BlockLog(std::filesystem::path path, const std::string& origin) : path_(std::move(path)) {
  Message file;
  {
    std::ifstream in(path_, std::ios::binary);
    if (in) file.assign(std::istreambuf_iterator<char>(in), {});
  }
  std::size_t at = 0;
  const auto first = next_piece(file, at);
  if (first && *first != origin) throw InputError(path_.string() + ": is of another run: " + *first);
  ends_.push_back(at);
  if (first) {
    while (auto piece = next_piece(file, at)) {
      pieces_.push_back(std::move(*piece));
      ends_.push_back(at);
    }
    open();
    return;
  }
  // A file whose first piece is not whole has nothing.
  std::ofstream(path_, std::ios::binary | std::ios::trunc).flush();
  open();
  add(origin);
  pieces_.clear();
  ends_.erase(ends_.begin());
}

void BlockLog::open() {
  if (std::filesystem::exists(path_)) std::filesystem::resize_file(path_, ends_.back());
  out_.close();
  out_.clear();
  out_.open(path_, std::ios::binary | std::ios::app);
  if (!out_) throw InputError(path_.string() + ": cannot be written");
}

void BlockLog::keep(std::size_t count) {
  if (count >= pieces_.size()) return;
  pieces_.resize(count);
  ends_.resize(count + 1);
  open();
}

void BlockLog::add(Message piece) {
  MessageWriter writer;
  writer.put(piece);
  writer.put(checksum_of(piece));
  const Message bytes = writer.take();
  out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out_.flush();
  if (!out_) throw std::runtime_error(path_.string() + ": cannot be written");
  ends_.push_back(ends_.back() + bytes.size());
  pieces_.push_back(std::move(piece));
}

}  // namespace delcert
