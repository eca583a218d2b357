#include <algorithm>
#include <numeric>

#include "proofs/checker/certificate/certificate.hpp"
#include "proofs/checker/parts/chunk_items.hpp"
#include "proofs/checker/report/report.hpp"

namespace delcert::checker {

void Certificate::parse_elements(Cursor& cursor) {
  const auto entry = [&cursor] {
    const std::int64_t value = cursor.integer();
    if (value < -INT32_MAX || value > INT32_MAX) cursor.fail("form.types", "an integer of 32 bits before this");
    return static_cast<std::int32_t>(value);
  };
  cursor.expect(",\"elements\":");
  if (element_size() == 0) {
    cursor.expect("[]");
  } else {
    cursor.array([&] { cursor.row(static_cast<int>(element_size()), [&] { element_entries.push_back(entry()); }); });
  }
}

void Certificate::parse_complex(Cursor& cursor) {
  parse_elements(cursor);
  const auto index = [&cursor] { return static_cast<std::uint32_t>(cursor.count(UINT32_MAX)); };
  cursor.expect(",\"simplices\":");
  cursor.array([&] {
    int at = 0;
    cursor.row(2 * m + 1, [&] { (at++ <= m ? simplex_labels : simplex_elements).push_back(index()); });
  });
  cursor.expect(",\"loops\":");
  cursor.array([&] {
    loops.emplace_back();
    cursor.array([&] {
      LoopStep step{};
      step.simplex = index();
      cursor.expect(",");
      step.from = index();
      cursor.expect(",");
      step.to = index();
      loops.back().push_back(step);
    });
  });
}

/// Without these nothing says where the vertices of a simplex are: no switch leaves them out.
void Certificate::require_elements() const {
  const auto require = [](std::size_t e, bool holds, const char* what) {
    if (!holds) throw Malformed("form.elements", "element " + std::to_string(e) + what);
  };
  const std::size_t size = element_size();
  const std::vector<std::int32_t> zero(size, 0);
  for (std::size_t e = 1; e < element_count(); ++e) {
    const std::int32_t* entries = element(e);
    if (space_form) {
      const std::int64_t letter = entries[1],
                         letters = std::ssize(space_form->generators) + (space_form->K == 0 ? m : 0);
      require(e, entries[0] >= 0 && entries[0] < static_cast<std::int64_t>(e),
              " has a parent that does not come before");
      require(e, letter != 0 && -letters <= letter && letter <= letters, " has a letter that is no generator");
    } else {
      require(e, !std::equal(zero.begin(), zero.end(), entries), " is the identity");
      require(e, e == 1 || std::lexicographical_compare(entries - size, entries, entries, entries + size),
              " is out of order");
    }
  }
  for (const std::uint32_t e : simplex_elements) {
    if (e >= element_count())
      throw Malformed("form.elements",
                      "a simplex has element " + std::to_string(e) + " of " + std::to_string(element_count()));
  }
}

/// Without these there are no paths to look at.
void Certificate::require_loops() const {
  const auto require = [](bool holds, const std::string& what) {
    if (!holds) throw Malformed("form.loops", what);
  };
  if (chunk != nullptr) return;  // ChunkView::check_loops
  require(loops.size() == loop_count(), std::to_string(loops.size()) + " loops, not " + std::to_string(loop_count()));
  for (std::size_t at = 0; at < loops.size(); ++at) {
    const std::string which = "loop " + std::to_string(at);
    Label label = 0;
    for (const LoopStep& step : loops[at]) {
      require(step.simplex < simplex_count(), which + " has a step in no simplex of the list");
      require(step.from <= m_size() && step.to <= m_size() && step.from != step.to,
              which + " has no edge of a simplex");
      require(simplex(step.simplex)[step.from] == label, which + " is not connected, or does not begin at 0");
      label = simplex(step.simplex)[step.to];
    }
    require(label == 0, which + " does not end at 0");
  }
}

/// Where labels are interior, and sorted as the simplices are.
void Certificate::derive_stars() {
  star_begin.assign(std::size_t{n} + 1, 0);
  for (const Label j : simplex_labels) star_begin[j + 1] += interior[j] ? 1U : 0U;
  for (Label i = 0; i < n; ++i) star_begin[i + 1] += star_begin[i];
  star_labels.resize(star_begin.back() * m_size());
  std::vector<std::uint64_t> next(star_begin.begin(), star_begin.end() - 1);
  for (std::size_t s = 0; s < simplex_count(); ++s) {
    for (std::size_t k = 0; k <= m_size(); ++k) {
      const Label i = simplex(s)[k];
      if (!interior[i]) continue;
      Label* others = &star_labels[next[i]++ * m_size()];
      for (std::size_t other = 0; other <= m_size(); ++other) {
        if (other != k) *others++ = simplex(s)[other];
      }
    }
  }
}

void Certificate::require_simplices() const {
  // Level 1 would hold of nothing.
  const bool any = std::find(interior.begin(), interior.end(), true) != interior.end();
  Report::require("form.interior", any || !claimed[level_1], "no label is interior");
  for (Label i = 0; i < n; ++i) {
    if (interior[i] && star_size(i) == 0)
      Report::require("form.interior", false, "label " + name_of(i) + " is in no simplex");
  }
  const std::size_t corners = m_size() + 1;
  for (std::size_t s = 0; s < simplex_count(); ++s) {
    const Label* labels = simplex(s);
    const auto require = [&](const char* rule, bool holds, const char* what) {
      if (!holds) Report::require(rule, false, "simplex " + label_set(labels, labels + corners) + what);
    };
    require("form.interior", std::any_of(labels, labels + corners, [this](Label j) { return interior[j]; }),
            " has no interior label");
    require("form.simplex-labels",
            std::adjacent_find(labels, labels + corners, std::greater_equal<>()) == labels + corners,
            " has labels that are not increasing");
    require("form.simplex-order",
            s == 0 || std::lexicographical_compare(labels - corners, labels, labels, labels + corners),
            " is out of order");
  }
}

std::vector<Label> Certificate::components() const {
  std::vector<Label> parent(n);
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](Label k) {
    while (parent[k] != k) k = parent[k] = parent[parent[k]];
    return k;
  };
  for (std::size_t s = 0; s < simplex_count(); ++s) {
    for (int k = 1; k <= m; ++k) parent[root(simplex(s)[k])] = root(simplex(s)[0]);
  }
  for (Label k = 0; k < n; ++k) parent[k] = root(k);
  return parent;
}

}  // namespace delcert::checker
