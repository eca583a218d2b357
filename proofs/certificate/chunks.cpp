#include "proofs/certificate/chunks.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string_view>
#include <vector>

#include "proofs/certificate/byte_sink.hpp"
#include "proofs/certificate/sha256.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

[[noreturn]] void refuse_to_divide(const std::string& what) { throw InputError(what); }

/// The value of a key of the document, from the end of the value before: arrays of arrays, or objects, are found by
/// what follows them. Quotation marks in strings are escaped, so that no string has a key in it.
class Sections {
 public:
  explicit Sections(std::string_view text) : text_(text) {}

  /// What is between these, the first of which is where the last section ended.
  std::string_view between(std::string_view before, std::string_view after) {
    if (text_.substr(at_, before.size()) != before)
      refuse_to_divide("is no certificate of a space form: expected " + std::string(before));
    at_ += before.size();
    const std::size_t end = text_.find(after, at_);
    if (end == std::string_view::npos)
      refuse_to_divide("is no certificate of a space form: expected " + std::string(after));
    const auto section = text_.substr(at_, end - at_);
    at_ = end;
    return section;
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

/// Of "[[…],[…]]" the inner brackets, whose contents have none.
std::vector<std::string_view> rows_of(std::string_view section) {
  std::vector<std::string_view> rows;
  for (std::size_t at = 1; at < section.size() && section[at] == '[';) {
    const std::size_t end = section.find(']', at);
    if (end == std::string_view::npos) refuse_to_divide("a bracket is not closed");
    rows.push_back(section.substr(at, end + 1 - at));
    at = end + 2;
  }
  return rows;
}

std::vector<std::uint32_t> numbers_of(std::string_view row) {
  std::vector<std::uint32_t> result;
  const char* const end = row.data() + row.size();
  for (const char* at = row.data() + 1; at < end;) {
    std::uint32_t number = 0;
    const auto [next, error] = std::from_chars(at, end, number);
    if (error != std::errc()) break;
    result.push_back(number);
    at = next + 1;
  }
  return result;
}

std::string digest_of(std::string_view first, std::string_view second) {
  Sha256 hash;
  hash.update(first);
  hash.update(second);
  return hash.digest();
}

std::string bytes_of(const std::string& digest) {
  std::string bytes;
  for (std::size_t at = 0; at < digest.size(); at += 2) {
    unsigned value = 0;
    std::from_chars(digest.data() + at, digest.data() + at + 2, value, 16);
    bytes += static_cast<char>(value);
  }
  return bytes;
}

/// Leaves and nodes have different first bytes, so that no leaf is a node.
std::string root_of(std::vector<std::string> digests) {
  while (digests.size() > 1) {
    std::vector<std::string> above;
    for (std::size_t at = 0; at < digests.size(); at += 2) {
      above.push_back(at + 1 == digests.size() ? digests[at]
                                               : digest_of("\1", bytes_of(digests[at]) + bytes_of(digests[at + 1])));
    }
    digests = std::move(above);
  }
  return digests.front();
}

void write_file(const std::filesystem::path& path, std::string_view text) {
  ByteSink sink(path);
  sink.write(text);
  sink.commit();
}

/// Without the homology, which is of the whole. No other key is called so.
std::string levels_in_chunks(std::string_view head) {
  std::string result(head);
  constexpr std::string_view key = R"(,"homology":[)";
  const std::size_t at = result.find(key);
  if (at != std::string::npos) result.erase(at, result.find(']', at) + 1 - at);
  return result;
}

/// Each step with the simplex that it names by number.
std::string loops_in_chunks(std::string_view loops, const std::vector<std::string_view>& simplices) {
  std::string result = "[";
  for (const std::string_view loop : rows_of(loops)) {
    result += result.size() > 1 ? ",[" : "[";
    const auto numbers = numbers_of(loop);
    for (std::size_t at = 0; at + 2 < numbers.size(); at += 3) {
      if (numbers[at] >= simplices.size()) refuse_to_divide("a loop has a step in no simplex");
      const std::string_view simplex = simplices[numbers[at]];
      if (at > 0) result += ',';
      result += simplex.substr(0, simplex.size() - 1);
      result += ',' + std::to_string(numbers[at + 1]) + ',' + std::to_string(numbers[at + 2]) + ']';
    }
    result += ']';
  }
  return result + "]";
}

}  // namespace

std::string write_chunks(const std::string& certificate, std::size_t chunks, const std::filesystem::path& folder) {
  Sections sections(certificate);
  sections.between(R"({"format":"delcert-certificate","version":2)", R"(,"software":{)");
  const auto software = sections.between("", R"(,"manifold":{)");
  const auto manifold = sections.between("", R"(,"parameters":{)");
  const auto parameters = sections.between("", R"(,"levels":{)");
  const auto levels = sections.between("", R"(,"net":[)");
  const auto net = rows_of(sections.between(R"(,"net":)", R"(,"net_simplices":[)"));
  sections.between(R"(,"net_simplices":[])", R"(,"points":[)");
  const auto points = rows_of(sections.between(R"(,"points":)", R"(,"elements":[)"));
  const auto elements = sections.between("", R"(,"simplices":[)");
  const auto simplices = rows_of(sections.between(R"(,"simplices":)", R"(,"loops":[)"));
  const auto loops = sections.between(R"(,"loops":)", R"(,"sha256":")");
  constexpr std::string_view families[] = {"spherical", "flat", "hyperbolic"};
  const bool is_space_form = std::any_of(std::begin(families), std::end(families), [&](std::string_view family) {
    return manifold.find(R"("family":")" + std::string(family) + '"') != std::string_view::npos;
  });
  if (!is_space_form || simplices.empty() || net.size() != points.size())
    refuse_to_divide("is no certificate of a space form: only these are divided into chunks");
  const std::size_t count = points.size();
  if (chunks < 2 || chunks > count)
    refuse_to_divide("cannot be divided into " + std::to_string(chunks) + " chunks: it has " + std::to_string(count) +
                     " labels");
  prepare_chunk_folder(folder);

  const std::size_t corners = (numbers_of(simplices.front()).size() + 1) / 2;
  const ChunkRanges ranges{count, chunks};
  // Of each chunk the simplices with one of its labels, in their order, and how many have their least label in it.
  std::vector<std::vector<std::uint32_t>> members(chunks);
  std::vector<std::size_t> own(chunks, 0);
  for (std::uint32_t number = 0; number < simplices.size(); ++number) {
    const auto row = numbers_of(simplices[number]);
    std::vector<std::size_t> in;
    for (std::size_t corner = 0; corner < corners; ++corner) {
      if (corner >= row.size() || row[corner] >= count) refuse_to_divide("a simplex has a label that is not there");
      const std::size_t chunk = ranges.chunk_of(row[corner]);
      if (corner == 0) ++own[chunk];
      if (std::find(in.begin(), in.end(), chunk) != in.end()) continue;
      in.push_back(chunk);
      members[chunk].push_back(number);
    }
  }
  std::vector<ChunkEntry> entries;
  for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
    const std::size_t first = ranges.first_of(chunk), labels = ranges.first_of(chunk + 1) - first;
    ChunkText text;
    text.add_rows("net", labels, [&](std::size_t at) { return net[first + at]; });
    text.add_rows("points", labels, [&](std::size_t at) { return points[first + at]; });
    text.add_rows("simplices", members[chunk].size(), [&](std::size_t at) { return simplices[members[chunk][at]]; });
    entries.push_back({first, own[chunk], write_chunk(folder, chunk, text.finished())});
  }
  std::string head(software);
  head += manifold;
  head += parameters;
  head += levels;
  return write_chunk_header(folder, count, entries, head, elements.substr(elements.find('[')),
                            loops_in_chunks(loops, simplices));
}

std::size_t ChunkRanges::first_of(std::size_t chunk) const {
  return labels / chunks * chunk + std::min(chunk, labels % chunks);
}

std::size_t ChunkRanges::chunk_of(std::size_t label) const {
  const std::size_t longer = (labels / chunks + 1) * (labels % chunks);
  return label < longer ? label / (labels / chunks + 1) : labels % chunks + (label - longer) / (labels / chunks);
}

void ChunkText::add_rows(std::string_view key, std::size_t count,
                         const std::function<std::string_view(std::size_t)>& row) {
  text_ += ",\"" + std::string(key) + "\":[";
  for (std::size_t at = 0; at < count; ++at) {
    if (at > 0) text_ += ',';
    text_ += row(at);
  }
  text_ += ']';
}

const std::string& ChunkText::finished() {
  text_ += "}\n";
  return text_;
}

void prepare_chunk_folder(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  if (std::filesystem::exists(folder / "header.json.zst") || std::filesystem::exists(folder / "header.json"))
    refuse_to_divide(folder.string() + ": has a certificate already");
}

std::string write_chunk(const std::filesystem::path& folder, std::size_t chunk, std::string_view text) {
  write_file(folder / (std::to_string(chunk + 1) + ".json.zst"), text);
  return digest_of(std::string_view("\0", 1), text);
}

std::string write_chunk_header(const std::filesystem::path& folder, std::size_t labels,
                               const std::vector<ChunkEntry>& entries, std::string_view head, std::string_view elements,
                               std::string_view loops) {
  std::vector<std::string> digests;
  std::string table = "[";
  for (const ChunkEntry& entry : entries) {
    digests.push_back(entry.digest);
    table += (table.size() > 1 ? ",[" : "[") + std::to_string(entry.first) + ',' + std::to_string(entry.own) + ",\"" +
             entry.digest + "\"]";
  }
  const std::string root = root_of(digests);
  std::string header = R"({"format":"delcert-chunks","version":1,"points":)" + std::to_string(labels) +
                       ",\"chunks\":" + table + "],\"root\":\"" + root + '"';
  header += levels_in_chunks(head);
  header += ",\"elements\":" + std::string(elements);
  header += ",\"loops\":" + std::string(loops);
  header += ",\"sha256\":\"" + digest_of(header, "") + "\"}\n";
  write_file(folder / "header.json.zst", header);
  return root;
}

}  // namespace delcert
