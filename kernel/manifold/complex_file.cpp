#include "kernel/manifold/complex_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <sstream>

#include "kernel/manifold/group_reader.hpp"
#include "kernel/number/exact_text.hpp"
#include "support/spelling.hpp"

namespace delcert {

namespace {

constexpr int greatest_exponent = 1000;

bool is_word(std::string_view name, std::string_view marks) {
  return !name.empty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           marks.find(c) != std::string_view::npos;
  });
}

bool is_generator_name(std::string_view name) {
  return is_word(name, "_") && !(name.front() >= '0' && name.front() <= '9');
}

bool is_point_name(std::string_view name) { return is_word(name, "_-.'"); }

class ComplexReader : GroupReader {
 public:
  ComplexReader(std::string_view text, const std::string& source) : GroupReader(text, source), table_(parse()) {}

  ComplexDescription read() {
    refuse_unknown(table_, {"name", "family", "dimension", "curvature", "field", "root", "time", "gram", "generators",
                            "points", "simplices"});
    if (short_string(table_, "family") != "complex") fail(required(table_, "family"), "key \"family\"", "\"complex\"");
    const FieldElement::Field field = this->field(table_);
    ComplexDescription result{short_string(table_, "name"), form(table_, field), {}, {}, {}, {}, {}};
    if (result.form.curvature() == Curvature::zero && field)
      fail(required(table_, "field"), "key \"field\"", "no field: coordinates of flat manifolds are rational");
    read_generators(field, result);
    read_points(result);
    read_simplices(result);
    return result;
  }

 private:
  void read_generators(const FieldElement::Field& field, ComplexDescription& result) {
    const std::string expected = "a table of matrices, such as a = [[1, 0, 0], [\"1/2\", 1, 0], [0, 0, -1]]";
    const auto m = static_cast<std::size_t>(result.form.dimension());
    if (table_.contains("generators")) {
      const toml::table* list = table_["generators"].as_table();
      if (list == nullptr) fail(required(table_, "generators"), key_in_words("generators"), expected);
      for (const auto& [key, node] : *list) {
        const std::string name(key.str());
        if (!is_generator_name(name))
          fail(key.source(), "generator " + shortened(name) +
                                 ": expected a name of letters, digits and _ that does not begin with a digit");
        result.generator_names.push_back(name);
        result.generators.push_back(matrix(field, node, m + 1, "generator " + name));
        letters_[name] = static_cast<std::int32_t>(result.generators.size());
      }
    }
    if (result.form.curvature() != Curvature::zero) return;
    for (std::size_t axis = 1; axis <= m; ++axis) {
      const std::string name = "e" + std::to_string(axis);
      if (!letters_.emplace(name, static_cast<std::int32_t>(result.generators.size() + axis)).second) {
        fail(*(*table_["generators"].as_table()).get(name), "generator " + name,
             "another name: " + name + " is the translation by a basis vector of the lattice");
      }
    }
  }

  void read_points(ComplexDescription& result) {
    const toml::node& node = required(table_, "points");
    if (const auto* list = node.as_array()) {
      for (const toml::node& point : *list) add_point(std::to_string(result.points.size()), point, result);
    } else if (const auto* named = node.as_table()) {
      for (const auto& [key, point] : *named) {
        if (!is_point_name(key.str()))
          fail(key.source(), "point " + shortened(key.str()) + ": expected a name of letters, digits and _ - . '");
        add_point(std::string(key.str()), point, result);
      }
    } else {
      fail(node, "key \"points\"", "an array of points, or a table of named points");
    }
  }

  void add_point(const std::string& name, const toml::node& node, ComplexDescription& result) {
    const auto m = static_cast<std::size_t>(result.form.dimension());
    const auto* list = node.as_array();
    if (list == nullptr || list->size() != m)
      fail(node, "point " + name, "an array of " + std::to_string(m) + " conformal coordinates");
    std::vector<Rational>& point = result.points.emplace_back();
    Rational squared(0);
    for (std::size_t axis = 0; axis < m; ++axis) {
      point.push_back(coordinate((*list)[axis], "point " + name + ", coordinate " + std::to_string(axis + 1)));
      squared += square(point.back());
    }
    if (result.form.curvature() == Curvature::negative && squared >= Rational(4))
      fail(node, "point " + name, "conformal coordinates of a length below 2");
    labels_[name] = static_cast<std::uint32_t>(result.point_names.size());
    result.point_names.push_back(name);
  }

  /// A floating-point number is exactly the double that it is read as.
  Rational coordinate(const toml::node& node, const std::string& what) const {
    const auto* number = node.as_floating_point();
    if (number != nullptr && std::isfinite(number->get())) return Rational::exactly(number->get());
    return of_text(node, what, [](const std::string& x) { return parse_exact(x); });
  }

  void read_simplices(ComplexDescription& result) const {
    const toml::node& node = required(table_, "simplices");
    const auto* list = node.as_array();
    if (list == nullptr || list->empty()) fail(node, "key \"simplices\"", "an array of at least one simplex");
    std::map<std::vector<std::uint32_t>, std::size_t> known;
    std::vector<bool> used(result.points.size(), false);
    for (const toml::node& entry : *list) {
      const std::size_t number = result.simplices.size() + 1;
      const std::string what = "simplex " + std::to_string(number);
      result.simplices.push_back(simplex(entry, what, result));
      std::vector<std::uint32_t> labels;
      for (const auto& vertex : result.simplices.back()) labels.push_back(vertex.label);
      for (const std::uint32_t label : labels) used[label] = true;
      const auto twice = std::adjacent_find(labels.begin(), labels.end());
      if (twice != labels.end()) {
        fail(entry.source(), what + " has the point " + result.point_names[*twice] +
                                 " twice: the points of a simplex are different, subdivide");
      }
      const auto [same, is_new] = known.emplace(labels, number);
      if (is_new) continue;
      std::string names;
      for (const std::uint32_t label : labels) names += (names.empty() ? "" : ", ") + result.point_names[label];
      fail(entry.source(), what + " has the points " + names + ", as has simplex " + std::to_string(same->second) +
                               ": different simplices have different sets of points, subdivide");
    }
    const auto unused = std::find(used.begin(), used.end(), false);
    if (unused != used.end()) {
      fail(required(table_, "points").source(),
           "point " + result.point_names[static_cast<std::size_t>(unused - used.begin())] + " is in no simplex");
    }
  }

  std::vector<ComplexDescription::Vertex> simplex(const toml::node& node, const std::string& what,
                                                  const ComplexDescription& result) const {
    const std::size_t count = static_cast<std::size_t>(result.form.dimension()) + 1;
    const auto* list = node.as_array();
    if (list == nullptr || list->size() != count)
      fail(node, what, "an array of " + std::to_string(count) + " vertices");
    std::vector<ComplexDescription::Vertex> vertices;
    for (const toml::node& entry : *list)
      vertices.push_back(vertex(entry, what + ", vertex " + std::to_string(vertices.size() + 1)));
    std::stable_sort(vertices.begin(), vertices.end(), [](const auto& a, const auto& b) { return a.label < b.label; });
    return vertices;
  }

  /// "p", "a b^-1 p", or the index of a point.
  ComplexDescription::Vertex vertex(const toml::node& node, const std::string& what) const {
    std::vector<std::string> words;
    if (const auto* index = node.as_integer()) {
      words.push_back(std::to_string(index->get()));
    } else if (const auto* text = node.as_string()) {
      std::istringstream stream(text->get());
      for (std::string word; stream >> word;) words.push_back(word);
    }
    if (words.empty()) fail(node, what, "a point, or a string of letters and a point, such as \"a b^-1 p\"");
    ComplexDescription::Vertex result;
    const auto point = labels_.find(words.back());
    if (point == labels_.end()) fail(node.source(), what + ": no point " + among(words.back(), labels_));
    result.label = point->second;
    words.pop_back();
    for (const std::string& word : words) append(word, node, what, result.word);
    return result;
  }

  void append(const std::string& word, const toml::node& node, const std::string& what,
              std::vector<std::int32_t>& letters) const {
    const std::size_t caret = std::min(word.find('^'), word.size());
    int exponent = 1;
    if (caret < word.size()) {
      const char* end = word.data() + word.size();
      const auto [rest, error] = std::from_chars(word.data() + caret + 1, end, exponent);
      if (error != std::errc() || rest != end || exponent == 0 || std::abs(exponent) > greatest_exponent) {
        fail(node.source(), what + ": \"" + shortened(word) + "\": expected an exponent from -1000 to 1000, not 0");
      }
    }
    const std::string name = word.substr(0, caret);
    const auto letter = letters_.find(name);
    if (letter == letters_.end()) fail(node.source(), what + ": no generator " + among(name, letters_));
    letters.insert(letters.end(), static_cast<std::size_t>(std::abs(exponent)),
                   exponent > 0 ? letter->second : -letter->second);
  }

  template <class Value>
  static std::string among(const std::string& name, const std::map<std::string, Value>& known) {
    std::vector<std::string_view> names;
    for (const auto& entry : known) names.push_back(entry.first);
    return shortened(name) + suggestion(name, names);
  }

  toml::table table_;
  std::map<std::string, std::int32_t> letters_;
  std::map<std::string, std::uint32_t> labels_;
};

}  // namespace

std::string ComplexDescription::letter_name(std::size_t letter) const {
  return letter <= generator_names.size() ? generator_names[letter - 1]
                                          : "e" + std::to_string(letter - generator_names.size());
}

ComplexDescription parse_complex(std::string_view text, const std::string& source) {
  return ComplexReader(text, source).read();
}

}  // namespace delcert
