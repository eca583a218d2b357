#pragma once

#include "kernel/manifold/quotient/space_form.hpp"
#include "proofs/certificate/reader.hpp"

namespace delcert {

/// The group of a certificate, of which nothing is believed: `verify_space_form` decides. Throws InputError where the
/// key `manifold` is not as the format says.
[[nodiscard]] SpaceFormDescription space_form_of(const CertificateSummary& certificate);

/// The group elements that its simplices name, the identity first. Throws InputError where one is no product of an
/// earlier one and a letter.
[[nodiscard]] std::vector<FieldMatrix> elements_of(const CertificateSummary& certificate,
                                                   const SpaceFormDescription& description);

}  // namespace delcert
