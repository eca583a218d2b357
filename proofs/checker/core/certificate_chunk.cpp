#include "proofs/checker/certificate/certificate.hpp"
#include "proofs/checker/certificate/input.hpp"
#include "proofs/checker/core/chunk_view.hpp"
#include "proofs/checker/parts/chunk_items.hpp"
#include "proofs/checker/parts/share.hpp"
#include "proofs/checker/report/report.hpp"

namespace delcert::checker {

Certificate::Certificate(ChunkView& view, unsigned edges) : chunk(&view) {
  Chunks& chunks = view.chunks();
  Cursor cursor(chunks.header());
  chunks.read_table(cursor);
  if (view.number() >= chunks.size())
    throw Malformed("chunk.ranges", "there are " + std::to_string(chunks.size()) + " chunks");
  own_share = {view.number() + 1, chunks.size()};
  cursor.expect(",\"software\":");
  parse_claims(cursor);
  if (!space_form) throw Malformed("form.family", "certificates in chunks are of space forms");
  if (!homology.empty()) throw Malformed("form.family", "a certificate in chunks states no homology");
  parse_elements(cursor);
  chunks.set_dimension(m_size());
  view.loops.clear();
  cursor.expect(",\"loops\":");
  cursor.array([&] {
    view.loops.emplace_back();
    cursor.array([&] {
      ChunkStep& step = view.loops.back().emplace_back();
      int at = 0;
      const auto number = [&] { return static_cast<std::uint32_t>(cursor.count(UINT32_MAX)); };
      cursor.row(2 * m + 3, [&] {
        const std::uint32_t x = number();
        if (at <= m) {
          step.labels.push_back(x);
        } else if (at <= 2 * m) {
          step.elements.push_back(x);
        } else {
          (at == 2 * m + 1 ? step.from : step.to) = x;
        }
        ++at;
      });
      const bool fits =
          step.from <= m_size() && step.to <= m_size() && step.from != step.to &&
          std::all_of(step.labels.begin(), step.labels.end(), [&](Label j) { return j < chunks.points(); }) &&
          std::all_of(step.elements.begin(), step.elements.end(), [&](std::uint32_t e) { return e < element_count(); });
      if (!fits) throw Malformed("form.loops", "a step is no edge of a simplex");
    });
  });
  if (view.loops.size() != loop_count())
    throw Malformed("form.loops", std::to_string(view.loops.size()) + " loops, not " + std::to_string(loop_count()));
  content = sha256(cursor.passed());
  cursor.expect(",\"sha256\":");
  Report::require("seal", content == cursor.string(), "the SHA-256 of the content is not the one it is sealed with");
  cursor.expect("}");
  cursor.expect_end();

  ChunkView::Near near = view.near(m_size(), edges);
  net_text = std::move(near.net);
  points_text = std::move(near.points);
  net_read_ = read_enclosures(net_text);
  points_read_ = read_enclosures(points_text);
  simplex_labels = std::move(near.labels);
  simplex_elements = std::move(near.elements);
  take();
}

}  // namespace delcert::checker
