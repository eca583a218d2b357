#include "proofs/checker/certificate/chunks.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

#include "proofs/checker/certificate/input.hpp"
#include "proofs/checker/report/report.hpp"

namespace delcert::checker {
namespace {

constexpr std::uint64_t most_chunks = 1'000'000;

std::string bytes_of(const std::string& digest) {
  const auto value = [](char digit) { return digit <= '9' ? digit - '0' : digit - 'a' + 10; };
  std::string bytes;
  for (std::size_t at = 0; at < digest.size(); at += 2)
    bytes += static_cast<char>(16 * value(digest[at]) + value(digest[at + 1]));
  return bytes;
}

/// 64 lower-case hexadecimal digits.
std::string digest_at(Cursor& cursor) {
  const std::string_view text = cursor.string();
  if (text.size() != 64 || text.find_first_not_of("0123456789abcdef") != std::string_view::npos)
    cursor.fail("form.types", "64 hexadecimal digits before this");
  return std::string(text);
}

/// Of a folder, the file with this name, plain or compressed.
std::string read_one(const std::string& folder, const std::string& name) {
  try {
    return decompressed(read_bytes(folder + "/" + name + ".json.zst"));
  } catch (const Unreadable&) {
    return decompressed(read_bytes(folder + "/" + name + ".json"));
  }
}

}  // namespace

std::string leaf_digest(std::string_view bytes) { return sha256(std::string(1, '\0') + std::string(bytes)); }

std::string merkle_root(std::vector<std::string> leaves) {
  while (leaves.size() > 1) {
    std::vector<std::string> above;
    for (std::size_t at = 0; at < leaves.size(); at += 2) {
      above.push_back(at + 1 == leaves.size() ? leaves[at]
                                              : sha256('\1' + bytes_of(leaves[at]) + bytes_of(leaves[at + 1])));
    }
    leaves = std::move(above);
  }
  return leaves.empty() ? sha256("") : leaves.front();
}

const std::string& Chunks::header() {
  if (header_.empty()) header_ = read_one(folder_, "header");
  return header_;
}

void Chunks::read_table(Cursor& cursor) {
  entries_.clear();
  cursor.expect(R"({"format":"delcert-chunks","version":1,"points":)");
  points_ = static_cast<Label>(cursor.count(UINT32_MAX - 1));
  cursor.expect(",\"chunks\":");
  std::vector<std::string> leaves;
  cursor.array([&] {
    Entry& entry = entries_.emplace_back();
    cursor.expect("[");
    entry.first = static_cast<Label>(cursor.count(UINT32_MAX));
    cursor.expect(",");
    entry.simplices = cursor.count(INT64_MAX / most_chunks);
    cursor.expect(",");
    leaves.push_back(entry.digest = digest_at(cursor));
    cursor.expect("]");
  });
  cursor.expect(",\"root\":");
  root_ = digest_at(cursor);
  const bool ranges = entries_.size() >= 2 && entries_.size() <= most_chunks && entries_.front().first == 0 &&
                      std::is_sorted(entries_.begin(), entries_.end(),
                                     [](const Entry& a, const Entry& b) { return a.first <= b.first; }) &&
                      entries_.back().first < points_;
  if (!ranges) throw Malformed("chunk.ranges", "the first labels of chunks do not increase from 0 to below points");
  Report::require("chunk.root", merkle_root(leaves) == root_, "the root is not that of the digests of the chunks");
}

std::uint64_t Chunks::simplices_before(std::size_t k) const {
  std::uint64_t sum = 0;
  for (std::size_t at = 0; at < k; ++at) sum += entries_[at].simplices;
  return sum;
}
std::uint64_t Chunks::simplices() const { return simplices_before(entries_.size()); }

std::size_t Chunks::chunk_of(Label label) const {
  const auto after = std::upper_bound(entries_.begin(), entries_.end(), label,
                                      [](Label i, const Entry& entry) { return i < entry.first; });
  return static_cast<std::size_t>(after - entries_.begin()) - 1;
}

std::size_t Chunks::find(const Chunk& chunk, const Label* labels) const {
  const std::size_t corners = m_ + 1, number = chunk.labels.size() / corners;
  std::size_t low = 0, high = number;
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    const Label* there = &chunk.labels[middle * corners];
    if (std::lexicographical_compare(there, there + corners, labels, labels + corners)) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low < number && std::equal(labels, labels + corners, &chunk.labels[low * corners]) ? low : number;
}

const Chunk& Chunks::chunk(std::size_t k) {
  const auto found = read_.find(k);
  if (found != read_.end()) return found->second;
  const std::string name = "chunk " + std::to_string(k + 1);
  Chunk& chunk = read_[k];
  try {
    chunk.text = read_one(folder_, std::to_string(k + 1));
  } catch (const Unreadable& reason) {
    throw Malformed("chunk.file", name + ": " + reason.what());
  }
  Report::require("chunk.digest", leaf_digest(chunk.text) == entries_[k].digest,
                  name + " has not the digest that the header states");
  try {
    parse(k, chunk);
  } catch (const Malformed& reason) {
    throw Malformed(reason.rule, name + ": " + reason.what());
  }
  return chunk;
}

void Chunks::parse(std::size_t k, Chunk& chunk) const {
  const auto m = static_cast<int>(m_);
  const std::size_t corners = m_ + 1;
  Cursor cursor(chunk.text);
  cursor.expect(R"({"format":"delcert-chunk","version":1,"net":)");
  const auto parse_points = [&](std::vector<std::string_view>& of) {
    cursor.array([&] { cursor.row(m, [&] { of.push_back(cursor.number()); }); });
  };
  parse_points(chunk.net);
  cursor.expect(",\"points\":");
  parse_points(chunk.points);
  cursor.expect(",\"simplices\":");
  cursor.array([&] {
    int at = 0;
    cursor.row(2 * m + 1, [&] {
      (at++ <= m ? chunk.labels : chunk.elements).push_back(static_cast<std::uint32_t>(cursor.count(UINT32_MAX)));
    });
  });
  cursor.expect("}");
  cursor.expect_end();

  const Label first = this->first(k), end = this->end(k);
  const auto require = [](const char* rule, bool holds, const std::string& what) {
    if (!holds) throw Malformed(rule, what);
  };
  const std::size_t number = (end - first) * m_;
  require("chunk.labels", chunk.points.size() == number && chunk.net.size() == number,
          "has not a point for each of its labels");
  std::uint64_t own = 0;
  chunk.star_begin.assign(end - first + std::size_t{1}, 0);
  const auto is_own = [&](Label j) { return first <= j && j < end; };
  for (std::size_t s = 0; s * corners < chunk.labels.size(); ++s) {
    const Label* labels = &chunk.labels[s * corners];
    require("form.simplex-labels",
            std::adjacent_find(labels, labels + corners, std::greater_equal<>()) == labels + corners,
            "has a simplex with labels that are not increasing");
    require("form.simplex-order",
            s == 0 || std::lexicographical_compare(labels - corners, labels, labels, labels + corners),
            "has simplices that are out of order");
    require("form.labels", labels[m_] < points_, "has a label that is not below " + std::to_string(points_));
    require("chunk.labels", std::any_of(labels, labels + corners, is_own), "has a simplex with none of its labels");
    own += is_own(labels[0]) ? 1U : 0U;
    for (std::size_t at = 0; at < corners; ++at) {
      if (is_own(labels[at])) ++chunk.star_begin[labels[at] - first + 1];
    }
  }
  require("chunk.labels", own == entries_[k].simplices, "has not as many simplices as the header states");
  std::partial_sum(chunk.star_begin.begin(), chunk.star_begin.end(), chunk.star_begin.begin());
  chunk.star.resize(chunk.star_begin.back());
  std::vector<std::uint64_t> next(chunk.star_begin.begin(), chunk.star_begin.end() - 1);
  for (std::size_t at = 0; at < chunk.labels.size(); ++at) {
    if (is_own(chunk.labels[at]))
      chunk.star[next[chunk.labels[at] - first]++] = static_cast<std::uint32_t>(at / corners);
  }
}

const std::vector<std::uint32_t>& Chunks::trees(std::size_t k) {
  const auto found = trees_.find(k);
  if (found != trees_.end()) return found->second;
  const Chunk& chunk = this->chunk(k);
  const Label first = this->first(k), end = this->end(k);
  std::vector<Label> parent(end - first);
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](Label i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  const std::size_t corners = m_ + 1;
  for (std::size_t s = 0; s < chunk.labels.size(); s += corners) {
    std::optional<Label> before;
    for (std::size_t at = s; at < s + corners; ++at) {
      const Label j = chunk.labels[at];
      if (j < first || j >= end) continue;
      if (before) {
        const Label a = root(*before), b = root(j - first);
        parent[std::max(a, b)] = std::min(a, b);
      }
      before = j - first;
    }
  }
  std::vector<std::uint32_t> number(parent.size());
  std::uint32_t trees = 0;
  for (Label i = 0; i < parent.size(); ++i) number[i] = parent[i] == i ? trees++ : number[root(i)];
  return trees_[k] = std::move(number);
}

}  // namespace delcert::checker
