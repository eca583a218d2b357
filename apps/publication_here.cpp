// A part of delcert-publish and delcert-claims, not of delcert-certify.

#include "apps/certificate_picture.hpp"
#include "apps/other_programs.hpp"
#include "proofs/certificate/reader.hpp"
#include "proofs/drawing/figure/picture.hpp"

namespace delcert {

bool is_left_to_publishing(std::string_view) { return false; }

std::string certificate_picture(const CertificateSummary& certificate) {
  return picture_svg(drawing_of(certificate, {}));
}

}  // namespace delcert
