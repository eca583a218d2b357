#include "kernel/ranks/shared_measures.hpp"

#include <algorithm>

#include "kernel/sample/separation.hpp"

namespace delcert {

template <int m>
Rational shared_separation(Communicator& ranks, const LabelsHere& labels, const Atlas<m>& atlas,
                           const Progress& progress) {
  MessageWriter mine;
  mine.put(squared_separation<m>(atlas, labels.own, progress));
  Rational least(1);
  for (const Message& message : gather_everywhere(ranks, mine.take()))
    least = minimum(least, MessageReader(message).get_rational());
  return separation_of(least);
}

template <int m>
StarStability shared_stability(Communicator& ranks, const LabelsHere& labels, const Atlas<m>& atlas,
                               const SharedRun<m>& run, const Progress& progress) {
  const StabilityInCharts mine =
      check_stability_in<m>(atlas, run.points, run.geometry, run.complex, labels.own, progress);
  MessageWriter out;
  out.put(static_cast<std::uint64_t>(mine.pairs));
  out.put(mine.margins.has_value());
  out.put(mine.margins.value_or(LocalMargins{}));
  for (const StarFailure& failure : mine.failures) {
    out.put(labels.name(failure.label));
    out.put(failure.cause);
  }
  StabilityInCharts all;
  for (const Message& message : gather_everywhere(ranks, out.take())) {
    MessageReader in(message);
    all.pairs += in.get<std::uint64_t>();
    const bool has_margins = in.get<bool>();
    const auto margins = in.get<LocalMargins>();
    if (has_margins && all.margins) all.margins->include(margins);
    if (has_margins && !all.margins) all.margins = margins;
    while (!in.is_at_end()) {
      const Label label(in.get<std::uint32_t>());
      all.failures.push_back({label, {}, {}, in.get<FailureCause>()});
    }
  }
  return star_stability(std::move(all));
}

template <int m>
RiemannianSimplices shared_riemannian_simplices(Communicator& ranks, const LabelsHere& labels, const Atlas<m>& atlas,
                                                const SharedRun<m>& run, const Progress& progress) {
  const auto mine = measure_stars_about_points<m>(atlas, run.points, run.geometry, run.complex, labels.own, progress);
  return riemannian_simplices(combined_everywhere(ranks, mine,
                                                  [](StarsAboutPoints a, const StarsAboutPoints& b) {
                                                    a.include(b);
                                                    return a;
                                                  }),
                              run.geometry);
}

template <int m>
PiecewiseFlatReport shared_piecewise_flat(Communicator& ranks, const LabelsHere& labels, const Atlas<m>& atlas,
                                          const SharedRun<m>& run, const Progress& progress) {
  auto mine = measure_flat_simplices<m>(atlas, run.points, run.geometry, run.complex, labels.own, progress);
  std::vector<MessageWriter> out(ranks.size());
  for (FlatSide<m> side : mine.sides) {
    for (std::uint32_t& label : side.facet) label = labels.names[label];
    out[rank_of(side.facet[0], labels.all, ranks.size())].put(side);
  }
  std::vector<Message> messages;
  for (MessageWriter& writer : out) messages.push_back(writer.take());
  std::vector<FlatSide<m>> sides;
  for (const Message& message : ranks.exchange(std::move(messages))) {
    for (MessageReader in(message); !in.is_at_end();) sides.push_back(in.get<FlatSide<m>>());
  }
  const auto include = [](auto a, const auto& b) {
    a.include(b);
    return a;
  };
  mine.hinges.include(count_hinges<m>(std::move(sides)));
  return piecewise_flat_report(combined_everywhere(ranks, mine.stretch, include),
                               combined_everywhere(ranks, mine.hinges, include), run.geometry.curvature,
                               run.model.circumradius);
}

template <int m>
ComplexCount shared_count(Communicator& ranks, const LabelsHere& labels, const ChartComplex<m>& complex) {
  ComplexCount mine;
  for (std::uint32_t label = labels.own.first; label < labels.own.last; ++label) {
    mine.euler_characteristic += 1;
    // The faces of which this is the least label, by their other labels.
    std::vector<std::vector<std::uint32_t>> faces;
    for (const auto& others : complex.star(Label(label))) {
      if (others[0] > label) ++mine.simplices;
      for (unsigned chosen = 1; chosen < 1U << static_cast<unsigned>(m); ++chosen) {
        std::vector<std::uint32_t> face;
        for (std::size_t at = 0; at < m; ++at) {
          if (((chosen >> at) & 1U) != 0) face.push_back(others[at]);
        }
        if (face.front() > label) faces.push_back(std::move(face));
      }
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    for (const auto& face : faces) mine.euler_characteristic += face.size() % 2 == 0 ? 1 : -1;
  }
  return combined_everywhere(ranks, mine, [](ComplexCount a, const ComplexCount& b) {
    a.simplices += b.simplices;
    a.euler_characteristic += b.euler_characteristic;
    return a;
  });
}

#define DELCERT_INSTANTIATE(m)                                                                                       \
  template Rational shared_separation<m>(Communicator&, const LabelsHere&, const Atlas<m>&, const Progress&);        \
  template StarStability shared_stability<m>(Communicator&, const LabelsHere&, const Atlas<m>&, const SharedRun<m>&, \
                                             const Progress&);                                                       \
  template RiemannianSimplices shared_riemannian_simplices<m>(Communicator&, const LabelsHere&, const Atlas<m>&,     \
                                                              const SharedRun<m>&, const Progress&);                 \
  template PiecewiseFlatReport shared_piecewise_flat<m>(Communicator&, const LabelsHere&, const Atlas<m>&,           \
                                                        const SharedRun<m>&, const Progress&);                       \
  template ComplexCount shared_count<m>(Communicator&, const LabelsHere&, const ChartComplex<m>&);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
