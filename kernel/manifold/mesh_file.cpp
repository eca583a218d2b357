#include "kernel/manifold/mesh_file.hpp"

#include <algorithm>
#include <charconv>

#include "kernel/number/exact_text.hpp"
#include "support/error.hpp"
#include "support/spelling.hpp"

namespace delcert {

namespace {

constexpr std::size_t most_digits_of_decimals = 400;
constexpr long greatest_exponent_of_decimals = 400;
constexpr std::size_t most_vertices_of_mesh = 10000000;

bool is_digit_of_decimal(char c) { return c >= '0' && c <= '9'; }

[[noreturn]] void refuse_decimal(std::string_view text) {
  throw InputError("found \"" + shortened(text) + "\", expected a decimal such as -0.125, or an exact number");
}

/// Lines of a file with something on them, comments taken off, cut at blanks.
class Lines {
 public:
  Lines(std::string_view text, const std::string& source) : text_(text), source_(source) {}

  /// The next line that has a word; empty at the end.
  const std::vector<std::string_view>& next() {
    words_.clear();
    while (words_.empty() && at_ < text_.size()) {
      const std::size_t end = std::min(text_.find('\n', at_), text_.size());
      std::string_view line = text_.substr(at_, end - at_);
      line = line.substr(0, line.find('#'));
      at_ = end + 1;
      ++number_;
      constexpr std::string_view blanks = " \t\r";
      for (std::size_t from = line.find_first_not_of(blanks); from != std::string_view::npos;) {
        const std::size_t to = std::min(line.find_first_of(blanks, from), line.size());
        words_.push_back(line.substr(from, to - from));
        from = line.find_first_not_of(blanks, to);
      }
    }
    return words_;
  }
  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(source_ + ":" + std::to_string(number_) + ": " + message);
  }
  [[nodiscard]] std::vector<Rational> point(std::size_t first) const {
    std::vector<Rational> result;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      try {
        result.push_back(parse_decimal(words_[first + axis]));
      } catch (const InputError& error) {
        fail("coordinate " + std::to_string(axis + 1) + ": " + error.what());
      }
    }
    return result;
  }
  [[nodiscard]] long integer(std::string_view word, const char* what) const {
    long result = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), result);
    if (error != std::errc() || end != word.data() + word.size())
      fail("found \"" + shortened(word) + "\", expected " + what);
    return result;
  }

 private:
  std::string_view text_;
  const std::string& source_;
  std::size_t at_ = 0;
  std::size_t number_ = 0;
  std::vector<std::string_view> words_;
};

void add_triangle(TriangleMesh& mesh, const Lines& lines, const std::array<long, 3>& corners) {
  const auto count = static_cast<long>(mesh.points.size());
  std::array<std::uint32_t, 3> triangle{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (corners[k] < 0 || corners[k] >= count) {
      lines.fail("vertex " + std::to_string(corners[k]) + " of a face, counted from 0, where there are " +
                 std::to_string(count));
    }
    triangle[k] = static_cast<std::uint32_t>(corners[k]);
  }
  if (triangle[0] == triangle[1] || triangle[0] == triangle[2] || triangle[1] == triangle[2])
    lines.fail("a face that has a vertex twice");
  mesh.triangles.push_back(triangle);
}

TriangleMesh off_mesh(Lines& lines) {
  TriangleMesh result;
  std::vector<std::string_view> words = lines.next();
  if (words.empty() || words[0] != "OFF") lines.fail("expected the word OFF");
  words.erase(words.begin());
  if (words.empty()) words = lines.next();
  if (words.size() < 2) lines.fail("expected the numbers of vertices, faces and edges");
  const long vertices = lines.integer(words[0], "the number of vertices");
  const long faces = lines.integer(words[1], "the number of faces");
  if (vertices < 0 || faces < 0 || vertices > static_cast<long>(most_vertices_of_mesh) ||
      faces > 2 * vertices + 1000000)
    lines.fail("numbers of vertices and faces that no mesh of at most 10 000 000 vertices has");
  for (long at = 0; at < vertices; ++at) {
    const auto& coordinates = lines.next();
    if (coordinates.size() != 3) {
      lines.fail("vertex " + std::to_string(at) + ": found " + std::to_string(coordinates.size()) +
                 " words, expected three coordinates");
    }
    result.points.push_back(lines.point(0));
  }
  for (long at = 0; at < faces; ++at) {
    const auto& face = lines.next();
    if (face.empty()) lines.fail("the end of the file at face " + std::to_string(at) + " of " + std::to_string(faces));
    if (face[0] != "3" || face.size() < 4) lines.fail("a face that is no triangle: expected 3 and three vertices");
    add_triangle(
        result, lines,
        {lines.integer(face[1], "a vertex"), lines.integer(face[2], "a vertex"), lines.integer(face[3], "a vertex")});
  }
  if (!lines.next().empty()) lines.fail("more than the faces that were announced");
  return result;
}

TriangleMesh obj_mesh(Lines& lines) {
  TriangleMesh result;
  for (const auto* words = &lines.next(); !words->empty(); words = &lines.next()) {
    const std::string_view what = words->front();
    if (what == "v") {
      if (words->size() != 4) lines.fail("a vertex without exactly three coordinates");
      result.points.push_back(lines.point(1));
    } else if (what == "f") {
      if (words->size() != 4) lines.fail("a face that is no triangle");
      std::array<long, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::string_view word = (*words)[k + 1];
        const long number = lines.integer(word.substr(0, word.find('/')), "a vertex");
        // From 1 on; or, below 0, from the last one back.
        corners[k] = number < 0 ? static_cast<long>(result.points.size()) + number : number - 1;
      }
      add_triangle(result, lines, corners);
    } else if (what != "vn" && what != "vt" && what != "o" && what != "g" && what != "s" && what != "usemtl" &&
               what != "mtllib") {
      lines.fail("found \"" + shortened(what) + "\", expected v, f or another word of polygonal OBJ");
    }
  }
  return result;
}

}  // namespace

Rational parse_decimal(std::string_view text) {
  if (text.find('/') != std::string_view::npos || text.find("0x") != std::string_view::npos) return parse_exact(text);
  std::size_t at = 0;
  const bool is_negative = !text.empty() && text[0] == '-';
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) ++at;
  std::string digits;
  long scale = 0;
  bool has_point = false;
  for (; at < text.size() && (is_digit_of_decimal(text[at]) || (text[at] == '.' && !has_point)); ++at) {
    if (text[at] == '.') {
      has_point = true;
      continue;
    }
    digits += text[at];
    if (has_point) --scale;
  }
  if (digits.empty() || digits.size() > most_digits_of_decimals) refuse_decimal(text);
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    ++at;
    if (at < text.size() && text[at] == '+') ++at;
    long exponent = 0;
    const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), exponent);
    if (error != std::errc() || exponent < -greatest_exponent_of_decimals || exponent > greatest_exponent_of_decimals)
      refuse_decimal(text);
    at = static_cast<std::size_t>(end - text.data());
    scale += exponent;
  }
  if (at != text.size()) refuse_decimal(text);
  const std::size_t first = digits.find_first_not_of('0');
  const Rational whole(first == std::string::npos ? Integer(0) : Integer(digits.substr(first)));
  const Rational value = whole * power(Rational(10), scale);
  return is_negative ? -value : value;
}

TriangleMesh parse_mesh(std::string_view text, const std::string& source) {
  Lines lines(text, source);
  TriangleMesh result = source.ends_with(".obj") ? obj_mesh(lines) : off_mesh(lines);
  std::vector<bool> is_used(result.points.size());
  for (const auto& triangle : result.triangles) {
    for (const std::uint32_t vertex : triangle) is_used[vertex] = true;
  }
  const auto unused = std::find(is_used.begin(), is_used.end(), false);
  if (unused != is_used.end())
    throw InputError(source + ": vertex " + std::to_string(unused - is_used.begin()) +
                     ", counted from 0, is in no face");
  if (result.triangles.empty()) throw InputError(source + ": no triangles");
  return result;
}

}  // namespace delcert
