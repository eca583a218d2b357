#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "proofs/drawing/drawing.hpp"
#include "proofs/report/stream_block.hpp"

namespace delcert {

/// How much of a drawing a page holds.
struct PackingDetail {
  std::size_t measure_bytes = 2;  ///< a measure in so many bytes a simplex: steps of 1/65534 or 1/254 of its range
  bool has_exact_coordinates = true;
  bool has_all_measures = true;  ///< else only protection and thickness
};

/// A drawing for the page of a certificate (report/src/payload.js reads it). Vertices and simplices are put into
/// another order, in which neighbours are near each other; `worst` has, for each measure, the ten worst simplices in
/// that order with their values, the worst first.
struct PackedDrawing {
  nlohmann::ordered_json description;
  std::string block;
};

/// `exact`: the coordinates of each label as texts, with a blank between them; not used without
/// `has_exact_coordinates`.
[[nodiscard]] PackedDrawing packed_drawing(const Drawing& drawing, const std::vector<std::string>& exact,
                                           const PackingDetail& detail);

}  // namespace delcert
