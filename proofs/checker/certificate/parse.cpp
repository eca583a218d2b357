#include <future>
#include <set>

#include "proofs/checker/arithmetic/abelian_group.hpp"
#include "proofs/checker/arithmetic/exact_number.hpp"
#include "proofs/checker/certificate/certificate.hpp"
#include "proofs/checker/parts/meanwhile.hpp"
#include "proofs/checker/report/report.hpp"

namespace delcert::checker {
namespace {

constexpr std::string_view points_key = ",\"points\":";

Quantity parse_quantity(Cursor& cursor) { return Quantity(exact_value(cursor.number())); }

void parse_software(Cursor& cursor) {
  std::set<std::string_view> names;
  cursor.expect("{");
  do {
    const std::string_view name = cursor.string();
    // One spelling for each key, so that repetitions cannot hide.
    if (name.find('\\') != std::string_view::npos)
      cursor.fail("form.keys", "a key without escape sequences before this");
    if (!names.insert(name).second) cursor.fail("form.keys", "a key not used before");
    cursor.expect(":");
    cursor.string();
  } while (cursor.accept(","));
  cursor.expect("}");
  if (!names.contains("delcert")) cursor.fail("form.keys", "the key delcert before this");
}

/// One of the words, as a string; its number.
std::size_t parse_word(Cursor& cursor, const std::vector<std::string>& words) {
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (cursor.accept("\"" + words[k] + "\"")) return k;
  }
  cursor.fail("form.types", "one of the words " + words.front() + " … " + words.back());
}

/// A finitely generated abelian group in its one spelling.
std::string parse_group(Cursor& cursor) {
  const std::string_view text = cursor.string();
  if (!is_group(text)) cursor.fail("form.types", "a group such as Z^2 + Z/3 before this");
  return std::string(text);
}

}  // namespace

void Certificate::parse_manifold(Cursor& cursor) {
  cursor.expect("{\"name\":");
  name = cursor.string();
  cursor.expect(",\"family\":");
  const std::size_t family = parse_word(cursor, {"flat-torus", "euclidean-ball", "spherical", "flat", "hyperbolic",
                                                 "metric-field", "submanifold", "atlas"});
  torus = family == 0;
  cursor.expect(",\"dimension\":");
  m = static_cast<int>(cursor.count(4));
  if (m == 0) cursor.fail("form.types", "a dimension from 1 to 4 before this");
  if (family > 1 && m != 2 && m != 3 && !(family == 6 && m == 1))
    cursor.fail("form.types", "a dimension of this family before this");
  if (family == 5) {
    metric_field = std::make_unique<MetricField>(m, cursor);
  } else if (family == 6) {
    submanifold = std::make_unique<Submanifold>(m, cursor);
  } else if (family == 7) {
    gluing = std::make_unique<Gluing>(m, cursor);
  } else if (family > 1) {
    space_form = std::make_unique<SpaceForm>(3 - static_cast<int>(family), m, cursor);
  } else if (torus) {
    cursor.expect(",\"gram\":");
    cursor.row(m, [&] { cursor.row(m, [&] { gram.push_back(exact_value(cursor.number())); }); });
  } else {
    cursor.expect(",\"radius\":");
    radius = parse_quantity(cursor);
  }
  cursor.expect("}");
}

void Certificate::parse_parameters(Cursor& cursor) {
  cursor.expect("{\"mode\":");
  const std::size_t mode = parse_word(cursor, {"theory", "measured", "none"});
  theory = mode == 0;
  unperturbed = mode == 2;
  cursor.expect(",\"candidates\":");
  parse_word(cursor, {"pruned", "whole", "printed"});
  cursor.expect(",\"seed\":");
  if (cursor.number().find_first_of("x/") != std::string_view::npos)
    cursor.fail("form.numbers", "an integer before this");
  const std::pair<std::string_view, Quantity*> numbers[] = {{",\"sampling_radius\":", &epsilon},
                                                            {",\"separation\":", &mu},
                                                            {",\"radius_variation\":", &radius_variation},
                                                            {",\"distortion\":", &distortion},
                                                            {",\"perturbation\":", &rho},
                                                            {",\"flake_parameter_squared\":", &flake_squared},
                                                            {",\"tolerance\":", &tolerance}};
  for (const auto& [key, value] : numbers) {
    cursor.expect(key);
    *value = parse_quantity(cursor);
  }
  cursor.expect("}");
}

void Certificate::parse_levels(Cursor& cursor) {
  cursor.expect("{");
  std::string separator;
  for (std::size_t level = 0; level < level_names.size(); ++level) {
    claimed[level] = cursor.accept(separator + "\"" + std::string(level_names[level]) + "\":");
    if (!claimed[level]) continue;
    separator = ",";
    if ((level == level_1f || level == level_5i) && !submanifold)
      cursor.fail("form.family", "a level for this family before this");
    if (gluing && level != level_1 && level != level_2) {
      parse_atlas_level(cursor, level);
    } else if (submanifold && level != level_1 && level != level_2) {
      parse_submanifold_level(cursor, level);
    } else if (metric_field && level != level_1 && level != level_2) {
      parse_metric_field_level(cursor, level);
    } else if (space_form && level != level_1 && level != level_2 && level != level_3) {
      parse_space_form_level(cursor, level);
    } else if (level == level_0) {
      cursor.expect("{\"hypotheses_2\":");
      hypotheses_2 = cursor.boolean();
      sharper = hypotheses_2 && cursor.accept(",\"hypotheses\":\"sharper\"");
    } else if (level == level_1) {
      cursor.expect("{\"protection\":");
      protection = parse_quantity(cursor);
      cursor.expect(",\"thickness\":");
      thickness = parse_quantity(cursor);
      cursor.expect(",\"circumradius\":");
      circumradius = parse_quantity(cursor);
    } else if (level == level_2) {
      cursor.expect("{\"simplices\":");
      simplices = cursor.count(INT64_MAX);
      cursor.expect(",\"euler_characteristic\":");
      euler_characteristic = cursor.integer();
      cursor.expect(",\"closed\":");
      closed = cursor.boolean();
      if (cursor.accept(",\"homology\":")) cursor.row(m + 1, [&] { homology.push_back(parse_group(cursor)); });
    } else if (level == level_3) {
      cursor.expect("{\"tested\":");
      cursor.string();
    } else {
      cursor.expect(level == level_5   ? "{\"route\":\"space-form\""
                    : level == level_6 ? "{\"self_delaunay\":true,\"bilipschitz\":\"1\""
                                       : "{");
    }
    cursor.expect("}");
  }
  cursor.expect("}");
}

/// Without the brace at its end.
void Certificate::parse_metric_field_level(Cursor& cursor, std::size_t level) {
  if (level == level_2s) {
    cursor.expect("{\"reach\":");
    reach_2s = parse_quantity(cursor);
  } else if (level == level_4) {
    cursor.expect("{\"edge\":");
    edge = parse_quantity(cursor);
    cursor.expect(",\"margin\":");
    stability_margin = parse_quantity(cursor);
  } else if (level == level_5) {
    cursor.expect("{\"route\":\"affine-charts\"");
  } else {
    cursor.fail("form.family", "a level for metric fields before this");
  }
}

/// Without the brace at its end.
void Certificate::parse_atlas_level(Cursor& cursor, std::size_t level) {
  if (level == level_2s) {
    cursor.expect("{\"reach\":");
    reach_2s = parse_quantity(cursor);
  } else if (level == level_5) {
    cursor.expect("{\"route\":\"blended-charts\",\"contraction\":");
    contraction = parse_quantity(cursor);
    cursor.expect(",\"displacement\":");
    displacement = parse_quantity(cursor);
  } else {
    cursor.fail("form.family", "a level for atlases before this");
  }
}

/// Without the brace at its end.
void Certificate::parse_submanifold_level(Cursor& cursor, std::size_t level) {
  const auto number = [&](std::string_view key, Quantity& value) {
    cursor.expect(key);
    value = parse_quantity(cursor);
  };
  if (level == level_2s) {
    number("{\"reach\":", reach_2s);
  } else if (level == level_5) {
    number("{\"route\":\"graph\",\"contraction\":", contraction);
    number(",\"displacement\":", displacement);
  } else if (level == level_5i) {
    isotopic_by_normals = cursor.accept("{\"cosine\":");
    if (isotopic_by_normals)
      cosine = parse_quantity(cursor);
    else
      number("{\"margin\":", embedding_margin);
  } else if (level == level_4) {
    cursor.expect("{\"metric\":");
    const std::size_t metric_word = parse_word(cursor, {"extrinsic", "intrinsic", "both"});
    extrinsic = metric_word != 1;
    intrinsic = metric_word != 0;
    number(",\"density\":", density);
  } else if (level == level_6) {
    parse_stretch(cursor);
    number(",\"normal\":", normal);
  } else {
    cursor.expect("{");
  }
}

/// Without the brace at its end.
void Certificate::parse_space_form_level(Cursor& cursor, std::size_t level) {
  const auto number = [&](std::string_view key, Quantity& value) {
    cursor.expect(key);
    value = parse_quantity(cursor);
  };
  if (level == level_0) {
    number("{\"density\":", density);
    number(",\"distortion\":", transition_distortion);
    number(",\"metric_distortion\":", metric_distortion);
  } else if (level == level_2s) {
    number("{\"reach\":", reach_2s);
  } else if (level == level_4) {
    number("{\"protection\":", empty_margin);
    number(",\"circumradius\":", ball_radius);
  } else if (level == level_5) {
    cursor.expect("{\"route\":\"space-form\"");
    riemannian_simplices = cursor.accept(",\"thickness\":");
    if (!riemannian_simplices) return;
    riemannian_thickness = parse_quantity(cursor);
    number(",\"radius\":", riemannian_radius);
  } else {
    parse_stretch(cursor);
  }
}

/// Of level 6, with the brace before it.
void Certificate::parse_stretch(Cursor& cursor) {
  const auto number = [&](std::string_view key, Quantity& value) {
    cursor.expect(key);
    value = parse_quantity(cursor);
  };
  cursor.expect("{\"self_delaunay\":");
  self_delaunay = cursor.boolean();
  if (self_delaunay) number(",\"weight\":", weight);
  number(",\"bilipschitz\":[", least_stretch);
  number(",", greatest_stretch);
  cursor.expect("]");
}

/// The keys software, manifold, parameters, levels; the first one has been read.
void Certificate::parse_claims(Cursor& cursor) {
  parse_software(cursor);
  cursor.expect(",\"manifold\":");
  const std::size_t before = cursor.passed().size();
  parse_manifold(cursor);
  manifold_text = cursor.passed().substr(before);
  cursor.expect(",\"parameters\":");
  parse_parameters(cursor);
  cursor.expect(",\"levels\":");
  parse_levels(cursor);
}

namespace {

void parse_points(Cursor& cursor, std::size_t length, std::vector<std::string_view>& points) {
  cursor.array([&] { cursor.row(static_cast<int>(length), [&] { points.push_back(cursor.number()); }); });
}

}  // namespace

/// The keys net, charts, radii, net_simplices.
void Certificate::parse_net(Cursor& cursor) {
  cursor.expect(",\"net\":");
  parse_points(cursor, net_size(), net_text);
  if (!submanifold) net_read_ = read_enclosures(net_text);
  if (chart_size() != 0) {
    cursor.expect(",\"charts\":");
    parse_points(cursor, chart_size(), chart_text);
  }
  if ((submanifold || torus) && cursor.accept(",\"radii\":")) {
    cursor.array([&] { radii_text.push_back(cursor.number()); });
    if (radii_text.empty()) cursor.fail("form.lengths", "a radius before this");
  }
  cursor.expect(",\"net_simplices\":");
  cursor.array(
      [&] { cursor.row(m + 1, [&] { net_simplices.push_back(static_cast<Label>(cursor.count(UINT32_MAX))); }); });
}

/// The keys points, elements, simplices, loops.
void Certificate::parse_points_and_complex(Cursor& cursor) {
  cursor.expect(points_key);
  parse_points(cursor, m_size(), points_text);
  parse_complex(cursor);
  points_read_ = read_enclosures(points_text);
}

/// The second half is read meanwhile. A mistake in it is only spoken of if there is none in the first half, in which
/// the key of the second half cannot stand.
void Certificate::parse(Cursor& cursor) {
  cursor.expect("{\"format\":\"delcert-certificate\",\"version\":");
  if (cursor.accept("1,")) throw Malformed("form.version", "version 1 is read by delcert 0.1");
  cursor.expect("2,\"software\":");
  parse_claims(cursor);
  Cursor second = cursor.before_next(points_key);
  const std::size_t begin = second.passed().size();
  std::future<void> half = meanwhile([this, &second] { parse_points_and_complex(second); });
  parse_net(cursor);
  if (cursor.passed().size() != begin) cursor.fail("form.keys", points_key);
  half.get();
  cursor = second;
}

}  // namespace delcert::checker
