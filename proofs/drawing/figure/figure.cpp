#include "proofs/drawing/figure/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "proofs/drawing/figure/figure_page.hpp"
#include "support/latex_text.hpp"

namespace delcert {

namespace {

std::string in_markup(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}

std::string rgb(const Figure::Colour& colour) { return fmt::format("rgb({} {} {})", colour[0], colour[1], colour[2]); }

std::string svg_of(const Figure::Path& path, const FigurePage& page) {
  std::string lines;
  for (const auto& line : path.lines) {
    for (std::size_t at = 0; at < line.size(); ++at) {
      const auto [x, y] = page.place(line[at]);
      lines += fmt::format("{}{:.2f} {:.2f}", at == 0 ? "M" : "L", x, y);
    }
    if (path.is_closed) lines += "Z";
  }
  return fmt::format("<path d=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"{:.2f}\"{}/>\n", lines,
                     path.fill ? rgb(*path.fill) : "none", rgb(path.stroke), path.width,
                     path.is_dashed ? " stroke-dasharray=\"6 4\"" : "");
}

/// An option of TikZ.
std::string tikz_colour(const char* use, const Figure::Colour& colour) {
  return fmt::format("{}={{rgb,255:red,{};green,{};blue,{}}}", use, colour[0], colour[1], colour[2]);
}

}  // namespace

std::string svg_of(const Figure& figure) {
  const FigurePage page(figure);
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "role=\"img\">\n<title>{2}</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
      "<g stroke-linejoin=\"round\">\n",
      page.width(), page.height(), in_markup(figure.description));
  for (const Figure::Path& path : figure.paths) out += svg_of(path, page);
  for (const Figure::Circle& circle : figure.circles) {
    const auto [x, y] = page.place(circle.centre);
    out += fmt::format(
        "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:.2f}\"/>\n", x,
        y, circle.radius * page.scale(), rgb(circle.stroke), circle.width);
  }
  for (const Figure::Dot& dot : figure.dots) {
    const auto [x, y] = page.place(dot.centre);
    out += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" fill=\"{}\"/>\n", x, y, dot.radius,
                       rgb(dot.fill));
  }
  for (const Figure::Name& name : figure.names) {
    const auto [x, y] = page.place(name.at);
    out += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" font-family=\"serif\" font-size=\"18\" fill=\"{}\">{}</text>\n",
                       x + name_distance, y - name_distance, rgb(name.ink), in_markup(name.text));
  }
  if (figure.scale) {
    const auto [from, to] = page.bar(figure.scale->length);
    out += fmt::format(
        "<path class=\"scale\" d=\"M{:.2f} {:.2f}L{:.2f} {:.2f}\" stroke=\"#000000\" stroke-width=\"3\"/>\n"
        "<text x=\"{:.2f}\" y=\"{:.2f}\" font-family=\"serif\" font-size=\"18\">{}</text>\n",
        from[0], from[1], to[0], to[1], to[0] + 8, to[1] + 6, in_markup(figure.scale->text));
  }
  return out + "</g>\n</svg>\n";
}

std::string tikz_of(const Figure& figure) {
  const FigurePage page(figure);
  const double unit = figure_centimetres / figure_pixels;
  std::string out = fmt::format("% {}\n\\begin{{tikzpicture}}[x={:.6f}cm,y=-{:.6f}cm,line join=round]\n",
                                latex_text(figure.description), unit, unit);
  const auto points_of = [&unit](double pixels) { return pixels * unit * 72.27 / 2.54; };
  for (const Figure::Path& path : figure.paths) {
    std::string lines;
    for (const auto& line : path.lines) {
      for (std::size_t at = 0; at < line.size(); ++at) {
        const auto [x, y] = page.place(line[at]);
        lines += fmt::format("{}({:.2f},{:.2f})", at == 0 ? " " : "--", x, y);
      }
      if (path.is_closed) lines += "--cycle";
    }
    out += fmt::format("\\path[{}{},line width={:.2f}pt{}]{};\n",
                       path.fill ? tikz_colour("fill", *path.fill) + "," : std::string(),
                       tikz_colour("draw", path.stroke), points_of(path.width), path.is_dashed ? ",dashed" : "", lines);
  }
  for (const Figure::Circle& circle : figure.circles) {
    const auto [x, y] = page.place(circle.centre);
    out += fmt::format("\\path[{},line width={:.2f}pt] ({:.2f},{:.2f}) circle[radius={:.2f}];\n",
                       tikz_colour("draw", circle.stroke), points_of(circle.width), x, y, circle.radius * page.scale());
  }
  for (const Figure::Dot& dot : figure.dots) {
    const auto [x, y] = page.place(dot.centre);
    out += fmt::format("\\path[{}] ({:.2f},{:.2f}) circle[radius={:.2f}];\n", tikz_colour("fill", dot.fill), x, y,
                       dot.radius);
  }
  for (const Figure::Name& name : figure.names) {
    const auto [x, y] = page.place(name.at);
    out += fmt::format("\\node[above right,inner sep=1.5pt,{}] at ({:.2f},{:.2f}) {{{}}};\n",
                       tikz_colour("text", name.ink), x, y, latex_text(name.text));
  }
  if (figure.scale) {
    const auto [from, to] = page.bar(figure.scale->length);
    out += fmt::format("\\draw[line width=1.5pt] ({:.2f},{:.2f})--({:.2f},{:.2f}) node[right] {{{}}};\n", from[0],
                       from[1], to[0], to[1], latex_text(figure.scale->text));
  }
  return out + "\\end{tikzpicture}\n";
}

Figure::Scale round_scale(double x) {
  const int exponent = static_cast<int>(std::floor(std::log10(x)));
  // The quotient may be a little below 1 or not quite below 10.
  for (const auto& [digit, shift] : {std::pair{1, 1}, {5, 0}, {2, 0}, {1, 0}, {5, -1}}) {
    const double length = digit * std::pow(10.0, exponent + shift);
    if (length <= x) return {length, fmt::format("{:.{}f}", length, std::max(0, -(exponent + shift)))};
  }
  return {x, fmt::format("{:.3g}", x)};
}

}  // namespace delcert
