#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>

#include "proofs/certificate/stated_levels.hpp"
#include "proofs/certificate/summary_json.hpp"
#include "proofs/certification/report_json.hpp"
#include "proofs/drawing/figure/picture.hpp"
#include "proofs/drawing/formats/cell_data.hpp"
#include "proofs/drawing/formats/certificate_export.hpp"
#include "proofs/drawing/simplex_bounds.hpp"
#include "proofs/publication/certificate_page.hpp"
#include "proofs/publication/certificate_table.hpp"
#include "proofs/publication/citation.hpp"
#include "proofs/publication/exact_latex.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/conversion.hpp"
#include "python/bindings/parts.hpp"
#include "support/atomic_file.hpp"
#include "support/error.hpp"
#include "support/spelling.hpp"

namespace delcert::python {

namespace py = pybind11;

namespace {

template <class Value, std::size_t count>
Value named(const char* what, const std::array<Value, count>& values, const std::string& name) {
  std::vector<std::string_view> names;
  for (const Value value : values) {
    if (name_of(value) == name) return value;
    names.push_back(name_of(value));
  }
  throw InputError(
      fmt::format("no {} {} (there is {}){}", what, shortened(name), fmt::join(names, ", "), suggestion(name, names)));
}

DrawingOptions drawing_options(const std::string& copies, const std::optional<std::string>& model) {
  constexpr std::array all_copies{DrawingCopies::quotient, DrawingCopies::cell, DrawingCopies::glued};
  constexpr std::array all_models{DrawingModel::unit, DrawingModel::conformal, DrawingModel::stereographic,
                                  DrawingModel::gnomonic, DrawingModel::space};
  DrawingOptions result{named("copies", all_copies, copies), {}};
  if (model) result.model = named("model", all_models, *model);
  return result;
}

/// The certificate in a file, as it was read; nothing of it is verified.
class ReadCertificate {
 public:
  explicit ReadCertificate(const std::string& path)
      : content_(apart([&] { return read_certificate(path); })),
        dimension_(static_cast<std::size_t>(content_.manifold.dimension.value)) {}

  [[nodiscard]] std::string summary() const {
    nlohmann::ordered_json json = summary_json(content_);
    json["simplices"] = content_.simplices.size();
    json["levels"] = levels_json(stated_levels(content_), content_.parameter("sampling_radius"));
    return ascii_text(json);
  }

  [[nodiscard]] py::array_t<std::int32_t> simplices() const {
    const std::size_t columns = dimension_ + 1;
    std::vector<std::uint32_t> labels;
    for (const auto& row : content_.simplices) {
      if (row.size() < columns) throw InputError("a simplex of fewer labels than its dimension asks for");
      labels.insert(labels.end(), row.begin(), row.begin() + static_cast<std::ptrdiff_t>(columns));
    }
    if (std::any_of(labels.begin(), labels.end(), [this](auto label) { return label >= content_.points.size(); }))
      throw InputError("a simplex has a label that no point has");
    return table_of<std::int32_t>(labels, columns);
  }

  [[nodiscard]] py::tuple point(std::size_t label) const { return fractions_of(content_.points.at(label)); }
  [[nodiscard]] std::size_t point_count() const { return content_.points.size(); }

  [[nodiscard]] py::dict drawing(const std::string& copies, const std::optional<std::string>& model) const {
    const Drawing drawn = apart([&] { return drawing_of(content_, drawing_options(copies, model)); });
    py::dict measures;
    for (const NamedMeasure& one : named_measures(drawn)) measures[py::str(one.name)] = array_of<double>(one.values);
    py::list matching;
    for (const MatchingFaces& faces : drawn.matching_faces)
      matching.append(py::make_tuple(faces.first, faces.second, faces.step));
    py::dict result;
    result["coordinates"] = table_of<double>(drawn.coordinates, drawn.ambient_dimension);
    result["simplices"] = table_of<std::int32_t>(drawn.simplices, drawn.dimension + 1);
    result["labels"] = array_of<std::int32_t>(drawn.labels);
    result["lifts"] = array_of<std::int32_t>(drawn.lifts);
    result["lift_texts"] = drawn.lift_texts;
    result["positions"] = array_of<std::int32_t>(drawn.positions);
    result["measures"] = measures;
    result["matching_faces"] = matching;
    result["model"] = std::string(name_of(drawn.model));
    result["projection"] = drawn.projection;
    return result;
  }

  /// Of each measure a row (lower, upper) for each simplex.
  [[nodiscard]] py::dict bounds() const {
    const SimplexBounds bounds = apart([&] { return simplex_bounds(content_); });
    const auto rows = [](const MeasureEnclosures& one) {
      std::vector<double> values;
      for (std::size_t at = 0; at < one.lower.size(); ++at) values.insert(values.end(), {one.lower[at], one.upper[at]});
      return table_of<double>(values, 2);
    };
    py::dict result;
    result["protection"] = rows(bounds.protection);
    result["thickness"] = rows(bounds.thickness);
    result["circumradius"] = rows(bounds.circumradius);
    return result;
  }

  [[nodiscard]] py::bytes exported(const std::string& format, const std::string& copies,
                                   const std::optional<std::string>& model, bool is_exact, bool simplify,
                                   bool is_verified) const {
    ExportRequest request;
    try {
      request.format = &export_format(format);
    } catch (const std::invalid_argument& error) {
      throw InputError(error.what());
    }
    request.drawing = drawing_options(copies, model);
    request.is_exact = is_exact;
    request.simplify = simplify;
    request.verification = is_verified ? Verification::verified : Verification::not_asked;
    return apart([&] { return delcert::exported(content_, request); }).text;
  }

  [[nodiscard]] std::string picture(const std::string& colour, const std::optional<std::string>& model,
                                    bool is_plain) const {
    return apart([&] {
      require_seal(content_);
      Figure figure = picture_of(drawing_of(content_, drawing_options("cell", model)), {!is_plain, !is_plain, colour});
      figure.description = origin_text(content_, Verification::not_asked) + "; " + figure.description;
      return svg_of(figure);
    });
  }

  [[nodiscard]] std::string latex() const {
    return apart([&] { return certificate_latex(content_); });
  }
  [[nodiscard]] std::string reference(bool is_text) const {
    const Reference reference = apart([&] { return reference_of(content_); });
    return is_text ? text_of(reference) : bibtex_of(reference);
  }

 private:
  CertificateSummary content_;
  std::size_t dimension_;
};

/// `result`: what delcert-check printed; empty where it was not asked.
void write_page(const std::string& certificate, const std::string& checker, const std::string& date,
                const std::string& result, const std::string& page) {
  apart([&] {
    std::function<CheckRecord()> check;
    if (!result.empty()) check = [&] { return CheckRecord{checker, date, nlohmann::ordered_json::parse(result)}; };
    write_file_atomically(page, html_page({certificate_page_item(certificate, check)}));
  });
}

std::string references(bool is_text) {
  std::string result;
  for (const Reference& reference : {reference_of_paper(), reference_of_software()})
    result += (result.empty() || is_text ? "" : "\n") + (is_text ? text_of(reference) : bibtex_of(reference));
  return result;
}

}  // namespace

void add_certificate(py::module_& module) {
  py::class_<ReadCertificate>(module, "ReadCertificate")
      .def(py::init<const std::string&>())
      .def("summary", &ReadCertificate::summary)
      .def("simplices", &ReadCertificate::simplices)
      .def("point", &ReadCertificate::point)
      .def("point_count", &ReadCertificate::point_count)
      .def("drawing", &ReadCertificate::drawing)
      .def("bounds", &ReadCertificate::bounds)
      .def("exported", &ReadCertificate::exported)
      .def("picture", &ReadCertificate::picture)
      .def("latex", &ReadCertificate::latex)
      .def("reference", &ReadCertificate::reference);
  module.def("write_page", &write_page);
  module.def("references", &references);
  module.def("exact_latex", [](const std::string& text) { return exact_latex(rational_of(text)); });
}

}  // namespace delcert::python
