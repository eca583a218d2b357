#include "proofs/drawing/formats/complex_formats.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "kernel/topology/components.hpp"
#include "proofs/drawing/formats/cell_data.hpp"
#include "proofs/drawing/formats/gluings.hpp"
#include "proofs/drawing/formats/isomorphism_signature.hpp"
#include "proofs/drawing/formats/number_text.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// In an attribute of XML: the text is ASCII.
std::string attribute_text(const std::string& text) {
  std::string result;
  for (const char byte : text) {
    switch (byte) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += byte;
    }
  }
  return result;
}

PureComplex pure_complex(const LabelComplex& complex) {
  return {Dimension(static_cast<int>(complex.dimension)), complex.simplices};
}

}  // namespace

std::string simplex_tree_text(const ExportContent& content) {
  const LabelComplex& complex = *content.complex;
  const PureComplex faces = pure_complex(complex);
  std::string out;
  for (int k = 0; k <= faces.dimension(); ++k) {
    for (std::size_t face = 0; face < faces.count(k); ++face) {
      append_number(out, k);
      for (const std::uint32_t vertex : faces.vertices(k, face)) {
        out += ' ';
        append_number(out, complex.labels[vertex]);
      }
      out += " 0\n";
    }
  }
  return out;
}

std::string regina_text(const ExportContent& content) {
  const Gluings gluings(*content.complex);
  const std::size_t size = gluings.dimension() + 1;
  std::string out = fmt::format(
      "<?xml version=\"1.0\"?>\n<regina engine=\"7.3\">\n<tri dim=\"{}\" size=\"{}\" perm=\"index\" label=\"{}\">\n",
      gluings.dimension(), gluings.count(), attribute_text(content.origin()));
  for (std::size_t simplex = 0; simplex < gluings.count(); ++simplex) {
    out += "  <simplex>";
    for (std::size_t facet = 0; facet < size; ++facet) {
      const Gluings::Gluing& gluing = gluings.at(simplex, facet);
      if (gluing.simplex == Gluings::boundary) {
        out += " -1 -1";
      } else {
        out += ' ';
        append_number(out, gluing.simplex);
        out += ' ';
        append_number(out, alternating_index(gluing.vertices, size));
      }
    }
    out += " </simplex>\n";
  }
  return out + "</tri>\n</regina>\n";
}

std::string isosig_text(const ExportContent& content) {
  const LabelComplex& complex = *content.complex;
  if (complex.simplex_count() > most_simplices_of_a_signature) {
    throw InputError(fmt::format("a signature is written of at most {} simplices, and these are {}: try --simplify",
                                 most_simplices_of_a_signature, complex.simplex_count()));
  }
  if (component_count(pure_complex(complex)) != 1)
    throw InputError("a signature is written of connected complexes only");
  return isomorphism_signature(Gluings(complex)) + "\n";
}

std::string snappea_text(const ExportContent& content) {
  const LabelComplex& complex = *content.complex;
  if (!complex.is_closed) throw InputError("SnapPea reads closed complexes, and this one has a boundary");
  Gluings gluings(complex);
  if (!gluings.orient()) throw InputError("this complex cannot be oriented, and is not written for SnapPea");
  // The first line is the magic one, the second the name; a name is one word there.
  std::string name = content.origin();
  std::replace(name.begin(), name.end(), ' ', '_');
  std::string out = fmt::format("% Triangulation\n{}\nnot_attempted 0.0\noriented_manifold\nCS_unknown\n\n0 0\n\n{}\n",
                                name, gluings.count());
  constexpr std::size_t size = 4;
  for (std::size_t simplex = 0; simplex < gluings.count(); ++simplex) {
    for (std::size_t facet = 0; facet < size; ++facet) {
      out += ' ';
      append_number(out, gluings.at(simplex, facet).simplex);
    }
    out += '\n';
    for (std::size_t facet = 0; facet < size; ++facet) {
      out += ' ';
      for (std::size_t k = 0; k < size; ++k) append_number(out, gluings.at(simplex, facet).vertices[k]);
    }
    // Finite vertices; no peripheral curves; no shape.
    out += "\n -1 -1 -1 -1\n";
    for (int curve = 0; curve < 4; ++curve) out += " 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n";
    out += "0.0 0.0\n\n";
  }
  return out;
}

}  // namespace delcert
