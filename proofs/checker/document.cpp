#include "proofs/checker/document.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "proofs/checker/cursor.hpp"

namespace delcert::checker {
namespace {

void parse_software(Cursor& cursor) {
  std::set<std::string_view> names;
  cursor.expect("{");
  do {
    const std::string_view name = cursor.string();
    // One spelling for each key, so that repetitions cannot hide.
    if (name.find('\\') != std::string_view::npos) cursor.fail("form.keys", "a key without escape sequences");
    if (!names.insert(name).second) cursor.fail("form.keys", "a key not yet used");
    cursor.expect(":");
    cursor.string();
  } while (cursor.accept(","));
  cursor.expect("}");
  if (!names.contains("delcert")) cursor.fail("form.keys", "the key delcert");
}

/// A row of exactly m items between brackets.
template <class Item>
void parse_row(Cursor& cursor, int length, const Item& item) {
  for (int k = 0; k < length; ++k) {
    cursor.expect(k == 0 ? "[" : ",");
    item();
  }
  cursor.expect("]");
}

void parse_manifold(Cursor& cursor, Document& document) {
  cursor.expect("{\"name\":");
  document.name = cursor.string();
  cursor.expect(",\"family\":\"");
  document.torus = cursor.accept("flat-torus\"");
  if (!document.torus) cursor.expect("euclidean-ball\"");
  cursor.expect(",\"dimension\":");
  document.dimension = static_cast<int>(cursor.count(4));
  if (document.dimension == 0) cursor.fail("form.types", "a dimension from 1 to 4");
  if (document.torus) {
    cursor.expect(",\"gram\":");
    parse_row(cursor, document.dimension,
              [&] { parse_row(cursor, document.dimension, [&] { document.gram.push_back(cursor.number()); }); });
  } else {
    cursor.expect(",\"radius\":");
    document.radius = cursor.number();
  }
  cursor.expect("}");
}

std::string_view parse_choice(Cursor& cursor, std::initializer_list<std::string_view> choices) {
  const std::string_view text = cursor.string();
  if (std::find(choices.begin(), choices.end(), text) == choices.end()) cursor.fail("form.types", "one of the words");
  return text;
}

void parse_parameters(Cursor& cursor, Document& document) {
  cursor.expect("{\"mode\":");
  document.mode = parse_choice(cursor, {"theory", "measured", "none"});
  cursor.expect(",\"candidates\":");
  parse_choice(cursor, {"pruned", "whole", "printed"});
  cursor.expect(",\"seed\":");
  if (cursor.number().find_first_not_of("-0123456789") != std::string_view::npos) cursor.fail("form.numbers", "a seed");
  const std::pair<std::string_view, std::string_view*> numbers[] = {
      {",\"sampling_radius\":", &document.sampling_radius},
      {",\"separation\":", &document.separation},
      {",\"radius_variation\":", &document.radius_variation},
      {",\"distortion\":", &document.distortion},
      {",\"perturbation\":", &document.perturbation},
      {",\"flake_parameter_squared\":", &document.flake_parameter_squared},
      {",\"tolerance\":", &document.tolerance}};
  for (const auto& [key, value] : numbers) {
    cursor.expect(key);
    *value = cursor.number();
  }
  cursor.expect("}");
}

void parse_level(Cursor& cursor, Document& document, std::size_t level) {
  switch (level) {
    case level_0:
      cursor.expect("{\"hypotheses_2\":");
      document.hypotheses_2 = cursor.boolean();
      break;
    case level_1:
      cursor.expect("{\"protection\":");
      document.protection = cursor.number();
      cursor.expect(",\"thickness\":");
      document.thickness = cursor.number();
      cursor.expect(",\"circumradius\":");
      document.circumradius = cursor.number();
      break;
    case level_2:
      cursor.expect("{\"simplices\":");
      document.simplices = cursor.count(INT64_MAX);
      cursor.expect(",\"euler_characteristic\":");
      document.euler_characteristic = cursor.integer();
      cursor.expect(",\"closed\":");
      document.closed = cursor.boolean();
      break;
    case level_3:
      cursor.expect("{\"tested\":");
      cursor.string();
      break;
    case level_5:
      cursor.expect("{\"route\":\"space-form\"");
      break;
    case level_6:
      cursor.expect("{\"self_delaunay\":true,\"bilipschitz\":\"1\"");
      break;
    default:
      cursor.expect("{");
  }
  cursor.expect("}");
}

void parse_levels(Cursor& cursor, Document& document) {
  cursor.expect("{");
  std::string separator;
  for (std::size_t level = 0; level < level_names.size(); ++level) {
    document.claimed[level] = cursor.accept(separator + "\"" + std::string(level_names[level]) + "\":");
    if (!document.claimed[level]) continue;
    parse_level(cursor, document, level);
    separator = ",";
  }
  cursor.expect("}");
}

}  // namespace

Document parse_document(std::string_view text) {
  Cursor cursor(text);
  Document document;
  const auto parse_label = [&] { return static_cast<Label>(cursor.count(UINT32_MAX)); };
  const auto parse_points = [&](std::vector<std::string_view>& points) {
    cursor.array([&] { parse_row(cursor, document.dimension, [&] { points.push_back(cursor.number()); }); });
  };
  cursor.expect("{\"format\":\"delcert-certificate\",\"version\":1,\"software\":");
  parse_software(cursor);
  cursor.expect(",\"manifold\":");
  parse_manifold(cursor, document);
  cursor.expect(",\"parameters\":");
  parse_parameters(cursor, document);
  cursor.expect(",\"levels\":");
  parse_levels(cursor, document);
  cursor.expect(",\"net\":");
  parse_points(document.net);
  cursor.expect(",\"net_simplices\":");
  cursor.array(
      [&] { parse_row(cursor, document.dimension + 1, [&] { document.net_simplices.push_back(parse_label()); }); });
  cursor.expect(",\"points\":");
  parse_points(document.points);
  cursor.expect(",\"stars\":");
  cursor.array([&] {
    const auto m = static_cast<std::size_t>(document.dimension);
    document.star_begin.push_back(document.star_labels.size() / m);
    cursor.array(
        [&] { parse_row(cursor, document.dimension, [&] { document.star_labels.push_back(parse_label()); }); });
  });
  document.star_begin.push_back(document.star_labels.size() / static_cast<std::size_t>(document.dimension));
  document.sealed = text.substr(0, cursor.position());
  cursor.expect(",\"sha256\":");
  document.sha256 = cursor.string();
  cursor.expect("}");
  cursor.expect_end();
  return document;
}

}  // namespace delcert::checker
