#include "kernel/sample/point_file.hpp"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

#include "kernel/number/exact_text.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr std::string_view blanks = " \t";

/// One line of the file, without its end and without its comment.
struct Line {
  const std::string& source;
  std::size_t number;
  std::string_view text;
};

[[noreturn]] void fail(const Line& line, std::size_t offset, const std::string& message) {
  throw InputError(line.source + ":" + std::to_string(line.number) + ":" + std::to_string(offset + 1) + ": " + message);
}

std::string numbers(std::size_t count) { return std::to_string(count) + (count == 1 ? " number" : " numbers"); }

/// The point of a line; empty for a line without numbers.
std::vector<Rational> point_of(const Line& line, std::size_t dimension) {
  std::vector<Rational> point;
  std::size_t position = line.text.find_first_not_of(blanks);
  while (position != std::string_view::npos) {
    if (point.size() == dimension)
      fail(line, position, "found more than " + numbers(dimension) + ", expected a point of " + numbers(dimension));
    const std::size_t end = std::min(line.text.find_first_of(blanks, position), line.text.size());
    try {
      point.push_back(parse_exact(line.text.substr(position, end - position)));
    } catch (const ExactTextError& error) {
      fail(line, position + error.position(), error.what());
    }
    position = line.text.find_first_not_of(blanks, end);
  }
  if (!point.empty() && point.size() < dimension)
    fail(line, line.text.size(), "found " + numbers(point.size()) + ", expected a point of " + numbers(dimension));
  return point;
}

}  // namespace

PointList parse_points(std::string_view text, Dimension dimension, const std::string& source) {
  PointList points;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    line = line.substr(0, line.find('#'));
    auto point = point_of({source, number, line}, static_cast<std::size_t>(dimension.value));
    if (!point.empty()) points.push_back(std::move(point));
  }
  if (points.empty()) throw InputError(source + ": no point found, expected one a line");
  return points;
}

PointList read_points(const std::filesystem::path& path, Dimension dimension) {
  std::error_code reason;
  if (std::filesystem::is_directory(path, reason))
    throw InputError("cannot read " + path.string() + ": is a directory");
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError("cannot read " + path.string() + ": " + std::generic_category().message(errno));
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return parse_points(text, dimension, path.string());
}

std::string points_text(const PointList& points) {
  std::string text;
  for (const auto& point : points) {
    std::string_view separator;
    for (const Rational& coordinate : point) {
      text += separator;
      append_exact_text(text, coordinate);
      separator = " ";
    }
    text += '\n';
  }
  return text;
}

}  // namespace delcert
