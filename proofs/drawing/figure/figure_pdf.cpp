#include "proofs/drawing/figure/figure_pdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include "proofs/drawing/figure/figure_page.hpp"
#include "support/utf8.hpp"

namespace delcert {

namespace {

constexpr double font_size = 18;  ///< in pixels
constexpr double points_of_centimetre = 72 / 2.54;
/// How far a cubic Bézier curve leaves a quarter of the unit circle along the tangent at its ends: 4/3·(√2 − 1).
constexpr double quarter_handle = 0.5522847498307936;

std::u32string code_points(std::string_view text) {
  std::u32string result;
  while (!text.empty()) {
    const auto [length, code] = first_code_point(text);
    result += static_cast<char32_t>(code);
    text.remove_prefix(length);
  }
  return result;
}

/// The operators of a page's content, in pixels, y upwards.
class Content {
 public:
  explicit Content(const FigurePage& page) : page_(page) {}

  void add(const Figure::Path& path) {
    if (std::all_of(path.lines.begin(), path.lines.end(), [](const auto& line) { return line.empty(); })) return;
    if (path.fill) set(*path.fill, "rg");
    set(path.stroke, "RG");
    text_ += fmt::format("{:.2f} w\n", path.width);
    if (path.is_dashed) text_ += "[6 4] 0 d\n";
    for (const auto& line : path.lines) {
      for (std::size_t at = 0; at < line.size(); ++at) {
        const auto [x, y] = up(page_.place(line[at]));
        text_ += fmt::format("{:.2f} {:.2f} {}\n", x, y, at == 0 ? "m" : "l");
      }
      if (path.is_closed && !line.empty()) text_ += "h\n";
    }
    text_ += path.fill ? "B\n" : "S\n";
    if (path.is_dashed) text_ += "[] 0 d\n";
  }
  void add(const Figure::Circle& circle) {
    set(circle.stroke, "RG");
    text_ += fmt::format("{:.2f} w\n", circle.width);
    add_circle(circle.centre, circle.radius * page_.scale());
    text_ += "S\n";
  }
  void add(const Figure::Dot& dot) {
    set(dot.fill, "rg");
    add_circle(dot.centre, dot.radius);
    text_ += "f\n";
  }
  void add(const Figure::Name& name) {
    const auto [x, y] = up(page_.place(name.at));
    set(name.ink, "rg");
    add_text({x + name_distance, y + name_distance}, name.text);
  }
  void add(const Figure::Scale& scale) {
    const auto [from, to] = page_.bar(scale.length);
    const Figure::Point left = up(from);
    const Figure::Point right = up(to);
    set({0, 0, 0}, "RG");
    set({0, 0, 0}, "rg");
    text_ += fmt::format("3 w\n{:.2f} {:.2f} m\n{:.2f} {:.2f} l\nS\n", left[0], left[1], right[0], right[1]);
    add_text({right[0] + 8, right[1] - 6}, scale.text);
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  [[nodiscard]] Figure::Point up(const Figure::Point& pixels) const { return {pixels[0], page_.height() - pixels[1]}; }

  void set(const Figure::Colour& colour, const char* what) {
    text_ += fmt::format("{:.4f} {:.4f} {:.4f} {}\n", colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0, what);
  }
  void add_circle(const Figure::Point& centre, double radius) {
    const auto [x, y] = up(page_.place(centre));
    text_ += fmt::format("{:.2f} {:.2f} m\n", x + radius, y);
    // From (c, s) on the circle to (−s, c), a quarter on.
    for (const auto& [c, s] : {Figure::Point{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
      text_ += fmt::format("{:.2f} {:.2f} {:.2f} {:.2f} {:.2f} {:.2f} c\n", x + radius * (c - quarter_handle * s),
                           y + radius * (s + quarter_handle * c), x + radius * (quarter_handle * c - s),
                           y + radius * (quarter_handle * s + c), x - radius * s, y + radius * c);
    }
    text_ += "h\n";
  }
  void add_text(const Figure::Point& at, const std::string& text) {
    text_ += fmt::format("BT /F1 {:.0f} Tf {:.2f} {:.2f} Td (", font_size, at[0], at[1]);
    for (const char32_t sign : code_points(text)) {
      const bool is_printable = sign >= 0x20 && sign < 0x7f;
      if (sign == U'(' || sign == U')' || sign == U'\\') text_ += '\\';
      text_ += is_printable ? static_cast<char>(sign) : '?';
    }
    text_ += ") Tj ET\n";
  }

  const FigurePage& page_;
  std::string text_;
};

/// A text string of PDF: UTF-16 with a mark of its order, in hexadecimal.
std::string pdf_text(const std::string& text) {
  std::string result = "<FEFF";
  for (const char32_t sign : code_points(text)) {
    if (sign < 0x10000) {
      result += fmt::format("{:04X}", static_cast<std::uint32_t>(sign));
    } else {
      const auto above = static_cast<std::uint32_t>(sign - 0x10000);
      result += fmt::format("{:04X}{:04X}", 0xd800 + (above >> 10U), 0xdc00 + (above & 0x3ffU));
    }
  }
  return result + ">";
}

}  // namespace

std::string pdf_of(const Figure& figure) {
  const FigurePage page(figure);
  const double unit = figure_centimetres / figure_pixels * points_of_centimetre;
  Content content(page);
  for (const Figure::Path& path : figure.paths) content.add(path);
  for (const Figure::Circle& circle : figure.circles) content.add(circle);
  for (const Figure::Dot& dot : figure.dots) content.add(dot);
  for (const Figure::Name& name : figure.names) content.add(name);
  if (figure.scale) content.add(*figure.scale);
  const std::string operators = fmt::format("{0:.6f} 0 0 {0:.6f} 0 0 cm\n1 j\n{1}", unit, content.text());

  const std::vector<std::string> objects = {
      "<< /Type /Catalog /Pages 2 0 R >>",
      "<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
      fmt::format("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {:.2f} {:.2f}] /Contents 4 0 R "
                  "/Resources << /Font << /F1 5 0 R >> >> >>",
                  page.width() * unit, page.height() * unit),
      fmt::format("<< /Length {} >>\nstream\n{}endstream", operators.size(), operators),
      "<< /Type /Font /Subtype /Type1 /BaseFont /Times-Roman >>",
      fmt::format("<< /Title {} >>", pdf_text(figure.description)),
  };
  std::string out = "%PDF-1.4\n";
  std::string places = fmt::format("xref\n0 {}\n0000000000 65535 f \n", objects.size() + 1);
  for (std::size_t at = 0; at < objects.size(); ++at) {
    places += fmt::format("{:010} 00000 n \n", out.size());
    out += fmt::format("{} 0 obj\n{}\nendobj\n", at + 1, objects[at]);
  }
  return fmt::format("{}{}trailer\n<< /Size {} /Root 1 0 R /Info 6 0 R >>\nstartxref\n{}\n%%EOF\n", out, places,
                     objects.size() + 1, out.size());
}

}  // namespace delcert
