#include "proofs/publication/zip_archive.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <set>
#include <stdexcept>

namespace delcert {

namespace {

// What the format calls its records and fields: APPNOTE.TXT 4.3 and 4.4, by PKWARE.
constexpr std::uint32_t local_header = 0x04034b50;
constexpr std::uint32_t central_header = 0x02014b50;
constexpr std::uint32_t end_of_directory = 0x06054b50;
constexpr std::uint16_t version_needed = 10;        // 1.0: stored, without folders
constexpr std::uint16_t made_by = 3U << 8U | 63;    // Unix, by version 6.3 of the format
constexpr std::uint16_t name_is_utf_8 = 1U << 11U;  // a flag
constexpr std::uint16_t stored = 0;                 // the method of compression
constexpr std::uint32_t readable_by_all = 0100644U << 16U;
// The first day that the format can state: midnight of 1 January 1980.
constexpr std::uint16_t first_date = 0x21;
constexpr std::uint16_t first_time = 0;

/// Appends the number, its lowest byte first.
template <class Number>
void put(std::string& bytes, Number number) {
  for (std::size_t k = 0; k < sizeof number; ++k) bytes += static_cast<char>(number >> (8 * k) & 0xffU);
}

template <class Number>
Number fitting(std::size_t number) {
  if (number >= std::numeric_limits<Number>::max()) throw std::length_error("more than a ZIP archive can hold");
  return static_cast<Number>(number);
}

bool is_ascii(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char byte) { return static_cast<unsigned char>(byte) < 128; });
}

/// What the header of a file and its entry in the directory have in common.
std::string facts_of(const ArchiveFile& file) {
  const auto size = fitting<std::uint32_t>(file.bytes.size());
  std::string facts;
  put(facts, version_needed);
  put(facts, is_ascii(file.name) ? std::uint16_t{0} : name_is_utf_8);
  put(facts, stored);
  put(facts, first_time);
  put(facts, first_date);
  put(facts, static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(file.bytes.data()), size)));
  put(facts, size);  // as it is stored
  put(facts, size);  // as it is
  put(facts, fitting<std::uint16_t>(file.name.size()));
  put(facts, std::uint16_t{0});  // no more fields
  return facts;
}

}  // namespace

std::string zip_archive(const std::vector<ArchiveFile>& files) {
  std::set<std::string> names;
  std::string bytes;
  std::string directory;
  for (const ArchiveFile& file : files) {
    if (!names.insert(file.name).second) throw std::invalid_argument("two files are called " + file.name);
    const std::string facts = facts_of(file);
    put(directory, central_header);
    put(directory, made_by);
    directory += facts;
    put(directory, std::uint16_t{0});  // no comment
    put(directory, std::uint16_t{0});  // on the first disk
    put(directory, std::uint16_t{0});  // bytes, not text
    put(directory, readable_by_all);
    put(directory, fitting<std::uint32_t>(bytes.size()));
    directory += file.name;

    put(bytes, local_header);
    bytes += facts + file.name + file.bytes;
  }
  const auto start = fitting<std::uint32_t>(bytes.size());
  const auto count = fitting<std::uint16_t>(files.size());
  bytes += directory;
  put(bytes, end_of_directory);
  put(bytes, std::uint32_t{0});  // one disk
  put(bytes, count);             // of the files on it
  put(bytes, count);
  put(bytes, fitting<std::uint32_t>(directory.size()));
  put(bytes, start);
  put(bytes, std::uint16_t{0});  // no comment
  return bytes;
}

}  // namespace delcert
