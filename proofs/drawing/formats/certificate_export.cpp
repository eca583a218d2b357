#include "proofs/drawing/formats/certificate_export.hpp"

#include <fmt/format.h>

namespace delcert {

namespace {

ExportedText with_coordinates(const ExportRequest& request, ExportContent content) {
  DrawingOptions options = request.drawing;
  options.is_measured = request.format->has_measures;
  const Drawing drawing = drawing_of(content.certificate, options);
  content.drawing = &drawing;
  return {request.format->text(content),
          fmt::format("{} vertices, {} simplices of dimension {}, approximate", drawing.vertex_count(),
                      drawing.simplex_count(), drawing.dimension)};
}

ExportedText without_coordinates(const ExportRequest& request, ExportContent content) {
  LabelComplex complex = label_complex(content.certificate);
  if (request.simplify) {
    const std::size_t before = complex.simplex_count();
    Simplification less = simplified(content.certificate, complex);
    complex = std::move(less.complex);
    content.note =
        fmt::format("simplified from {} to {} simplices by {} contractions of edges, homology {} before and after",
                    before, complex.simplex_count(), less.contractions, fmt::join(less.homology, ", "));
  }
  content.complex = &complex;
  return {request.format->text(content),
          fmt::format("{} vertices, {} simplices of dimension {}{}{}", complex.labels.size(), complex.simplex_count(),
                      complex.dimension, content.note.empty() ? "" : ", ", content.note)};
}

}  // namespace

ExportedText exported(const CertificateSummary& certificate, const ExportRequest& request) {
  require_seal(certificate);
  request.format->check(certificate);
  ExportContent content{certificate};
  content.is_exact = request.is_exact;
  content.verification = request.verification;
  return request.format->has_coordinates ? with_coordinates(request, content) : without_coordinates(request, content);
}

}  // namespace delcert
