#pragma once

#include <string>
#include <vector>

#include "proofs/certificate/reader.hpp"
#include "proofs/publication/zip_archive.hpp"

namespace delcert {

/// A certificate for a bundle.
struct BundledCertificate {
  std::string file;   ///< its name in the bundle, without a folder: "torus.json.zst"
  std::string bytes;  ///< of the file
  CertificateSummary certificate;
};

/// What certificates do not say.
struct BundleFacts {
  std::string title;
  std::vector<std::string> authors;  ///< "Family, Given"
  std::string license;               ///< of SPDX; empty where none is stated
  std::string date;                  ///< of publication: "2026-05-31"
};

/// The files of supplementary material, in order: the certificates in `certificates/`, for each its manifold block in
/// `manifolds/` and its complex for other programs in `exports/` (VTK's grid, of surfaces also OFF, as far as its
/// dimension has these), references.bib, README.md with the commands that check it, CITATION.cff, .zenodo.json,
/// codemeta.json, the source of the checker, ro-crate-metadata.json, and SHA256SUMS of all others. `checker` is that
/// source, with names below `checker/`; where it is empty the README leaves open where delcert-check comes from. Equal
/// input gives equal files. Throws InputError, naming the file, for a certificate whose seal is wrong or that comes
/// twice, and for facts that are missing or no day.
[[nodiscard]] std::vector<ArchiveFile> bundle_files(const std::vector<BundledCertificate>& certificates,
                                                    const BundleFacts& facts,
                                                    const std::vector<ArchiveFile>& checker = {});

}  // namespace delcert
