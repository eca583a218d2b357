#include "kernel/ranks/shared_run.hpp"

#include <algorithm>
#include <limits>

#include "kernel/run/kept_stars.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

double greater(double a, double b) { return std::max(a, b); }

/// Stars of own labels, with those of the labels that they name, which other ranks have; what is known of others from
/// an earlier round is left out.
template <int m>
class NamedStars {
 public:
  NamedStars(Communicator& ranks, const LabelsHere& labels, std::vector<ChartStar<m>> stars)
      : ranks_(ranks), labels_(labels), stars_(std::move(stars)), interior_(labels.size(), false) {
    for (std::uint32_t label = 0; label < labels.size(); ++label) {
      interior_[label] = labels.own.contains(label);
      if (!interior_[label]) stars_[label].simplices.clear();
    }
  }

  ChartComplex<m> complex() {
    const auto asked = ranks_.exchange(questions());
    std::vector<Message> answers;
    for (std::size_t rank = 0; rank < asked.size(); ++rank) answers.push_back(answer(rank, asked[rank]));
    const auto received = ranks_.exchange(std::move(answers));
    for (std::size_t rank = 0; rank < received.size(); ++rank) take(rank, received[rank]);
    return ChartComplex<m>(std::move(stars_), interior_);
  }

 private:
  /// The positions, among what each rank has shown, of the labels that own stars name.
  std::vector<Message> questions() {
    wanted_.resize(ranks_.size());
    std::vector<bool> is_wanted(labels_.size(), false);
    for (std::uint32_t label = labels_.own.first; label < labels_.own.last; ++label) {
      for (const auto& others : stars_[label].simplices) {
        for (const auto& seen : others) is_wanted[seen.index] = !labels_.own.contains(seen.index);
      }
    }
    std::vector<Message> result;
    for (std::size_t rank = 0; rank < ranks_.size(); ++rank) {
      MessageWriter out;
      for (std::uint32_t label = labels_.from[rank].first; label < labels_.from[rank].last; ++label) {
        if (!is_wanted[label]) continue;
        wanted_[rank].push_back(label);
        out.put(label - labels_.from[rank].first);
      }
      result.push_back(out.take());
    }
    return result;
  }

  Message answer(std::size_t rank, const Message& positions) const {
    MessageWriter out;
    for (MessageReader in(positions); !in.is_at_end();) {
      const auto& star = stars_[labels_.shown_to[rank].at(in.get<std::uint32_t>())];
      out.put(static_cast<std::uint32_t>(star.simplices.size()));
      for (const auto& others : star.simplices) {
        for (const auto& seen : others) {
          out.put(labels_.names[seen.index]);
          out.put(seen.element);
        }
      }
    }
    return out.take();
  }

  void take(std::size_t rank, const Message& stars) {
    MessageReader in(stars);
    for (const std::uint32_t label : wanted_[rank]) {
      interior_[label] = true;
      for (auto count = in.get<std::uint32_t>(); count > 0; --count) {
        auto& others = stars_[label].simplices.emplace_back();
        for (auto& seen : others) {
          const auto name = in.get<std::uint32_t>();
          const auto here = labels_.named(name);
          if (!here)
            throw Rejection("label " + std::to_string(name) + " is in the star of label " +
                            std::to_string(labels_.names[label]) +
                            ", but too far from the labels of a rank that asks for it: patches are too small");
          seen = {here->value, {}, in.get<std::uint32_t>()};
        }
      }
    }
    if (!in.is_at_end())
      throw std::runtime_error("rank " + std::to_string(rank) + " has sent more stars than asked for");
  }

  Communicator& ranks_;
  const LabelsHere& labels_;
  std::vector<ChartStar<m>> stars_;
  std::vector<bool> interior_;
  std::vector<std::vector<std::uint32_t>> wanted_;  // by ranks, labels here
};

/// Failures of all ranks; the same everywhere.
struct FailuresEverywhere {
  std::uint64_t count = 0;            ///< one may be counted by several ranks
  std::vector<std::uint32_t> labels;  ///< the names of all labels that they lie with, sorted
};

FailuresEverywhere everywhere(Communicator& ranks, const LabelsHere& labels, const std::vector<StarFailure>& failures) {
  MessageWriter out;
  out.put(static_cast<std::uint64_t>(failures.size()));
  for (const Label label : labels_concerned_by(failures)) out.put(labels.name(label));
  FailuresEverywhere result;
  for (const Message& message : gather_everywhere(ranks, out.take())) {
    MessageReader in(message);
    result.count += in.get<std::uint64_t>();
    while (!in.is_at_end()) result.labels.push_back(in.get<std::uint32_t>());
  }
  std::sort(result.labels.begin(), result.labels.end());
  result.labels.erase(std::unique(result.labels.begin(), result.labels.end()), result.labels.end());
  return result;
}

/// The first rank throws; the others wait for it to end them.
[[noreturn]] void refuse(Communicator& ranks, const std::vector<std::uint32_t>& names, bool is_about_lifts,
                         int repair_rounds) {
  constexpr std::size_t shown = 10;
  if (ranks.rank() == 0) {
    if (is_about_lifts)
      throw Rejection("nothing is certified: the circumballs are too large for the injectivity radius");
    std::string text = "nothing is certified after " + std::to_string(repair_rounds) +
                       " repair rounds: " + std::to_string(names.size()) + " labels are concerned:";
    for (std::size_t at = 0; at < std::min(shown, names.size()); ++at) text += " " + std::to_string(names[at]);
    throw Rejection(text + (names.size() > shown ? " …" : ""));
  }
  (void)gather_everywhere(ranks, {});
  throw std::runtime_error("the first rank goes on where nothing is certified");
}

std::vector<Label> labels_here(const LabelsHere& labels, const std::vector<std::uint32_t>& names) {
  std::vector<Label> result;
  for (const std::uint32_t name : names) {
    if (const auto label = labels.named(name)) result.push_back(*label);
  }
  return result;
}

LocalMargins margins_everywhere(Communicator& ranks, bool is_there, const LocalMargins& mine) {
  struct Margins {
    LocalMargins margins;
    std::uint64_t are_there;
  };
  return combined_everywhere(ranks, Margins{mine, is_there ? 1U : 0U},
                             [](Margins a, const Margins& b) {
                               if (b.are_there == 0) return a;
                               if (a.are_there == 0) return b;
                               a.margins.include(b.margins);
                               return a;
                             })
      .margins;
}

}  // namespace

template <int m>
SharedRun<m> run_shared(Communicator& ranks, const LabelsHere& labels, const Atlas<m>& atlas,
                        const ModelGeometry& given_geometry, const PerturbationParameters& parameters,
                        const RunRequest& request, BlockLog* log, const Progress& progress) {
  SharedPerturbation<m> perturbation(ranks, labels, atlas, parameters, log);
  perturbation.place_all(progress);
  const double required = request.required_protection ? approximate_double(*request.required_protection) : 0;
  ModelGeometry geometry = given_geometry;
  KeptStars<m> stars(atlas, geometry, required, labels.own);
  std::size_t repaired = 0;
  for (int round = 0;; ++round) {
    geometry.displacement_of_the_whole = combined_everywhere(
        ranks, ChartView<m>(atlas, perturbation.points(), given_geometry).displacement(Label(0)), greater);
    stars.set_displacement_of_the_whole(geometry.displacement_of_the_whole);
    stars.update(perturbation.points(), progress);
    stars.include_reach(combined_everywhere(ranks, stars.farthest_reach(), greater));
    ChartComplex<m> complex = NamedStars<m>(ranks, labels, stars.lend_stars()).complex();
    std::vector<StarFailure> failures = stars.failures();
    const auto disagreeing = complex.agreement().failures;
    failures.insert(failures.end(), disagreeing.begin(), disagreeing.end());
    FailuresEverywhere all = everywhere(ranks, labels, failures);
    ModelReport model;
    if (all.count == 0) {
      model = check_circumballs<m>(atlas, perturbation.points(), geometry, complex, labels.own, progress);
      all = everywhere(ranks, labels, model.failures);
      model.failures.clear();
      model.protection =
          combined_everywhere(ranks, model.protection, [](double a, double b) { return std::min(a, b); });
      model.circumradius = combined_everywhere(ranks, model.circumradius, greater);
      if (all.count == 0) {
        model.check_lifts(geometry);
        if (!model.failures.empty()) refuse(ranks, {}, true, round);
        return {perturbation.take_points(),
                std::move(complex),
                geometry,
                margins_everywhere(ranks, stars.has_margins(), stars.margins()),
                std::move(model),
                round,
                repaired,
                perturbation.colour_count(),
                perturbation.statistics(),
                perturbation.bytes_sent()};
      }
    }
    if (all.labels.empty() || round == request.most_repair_rounds) refuse(ranks, all.labels, false, round);
    repaired += all.labels.size();
    stars.take_back(complex.take_stars());
    perturbation.place_anew(all.labels, progress);
    stars.outdate(labels_here(labels, all.labels));
  }
}

#define DELCERT_INSTANTIATE(m)                                                                                 \
  template SharedRun<m> run_shared<m>(Communicator&, const LabelsHere&, const Atlas<m>&, const ModelGeometry&, \
                                      const PerturbationParameters&, const RunRequest&, BlockLog*, const Progress&);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
