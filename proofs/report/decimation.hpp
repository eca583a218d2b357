#pragma once

#include <cstddef>

#include "proofs/drawing/drawing.hpp"

namespace delcert {

/// The part of a drawing that a page has: all of it, if it has at most `most` simplices. Otherwise the
/// `worst_simplices` worst simplices of each measure, with all simplices that have a label in common with them, so that
/// these stars are whole; and of the others so many that there are `most` in all, evenly spaced in the order of the
/// drawing. If the stars alone are more than `most`, they are all kept. Vertices of no remaining simplex are left out,
/// and so are pairs of matching faces one of which is a face of no remaining simplex. Measures and positions stay those
/// of the certificate.
[[nodiscard]] Drawing decimated(const Drawing& drawing, std::size_t most);

}  // namespace delcert
