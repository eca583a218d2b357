#include "kernel/ranks/shared_perturbation.hpp"

#include <algorithm>

#include "kernel/parallel/parts.hpp"
#include "kernel/perturb/colouring.hpp"

namespace delcert {

template <int m>
SharedPerturbation<m>::SharedPerturbation(Communicator& ranks, const LabelsHere& labels, const Atlas<m>& atlas,
                                          const PerturbationParameters& parameters, BlockLog* log)
    : ranks_(ranks),
      labels_(labels),
      atlas_(atlas),
      parameters_(parameters),
      log_(log),
      state_(atlas, parameters),
      place_(labels.own.size()) {
  state_.names_begin = labels.names_begin();
  for (std::uint32_t rank = 0; rank < ranks.size(); ++rank) {
    const auto& shown = labels.shown_to[rank];
    for (std::uint32_t position = 0; position < shown.size(); ++position) {
      auto& place = place_[shown[position] - labels.own.first];
      place.insert(place.end(), {rank, position});
    }
  }
}

template <int m>
std::vector<Message> SharedPerturbation<m>::exchanged(std::vector<Message> messages) {
  for (std::size_t rank = 0; rank < messages.size(); ++rank) {
    if (rank != ranks_.rank()) bytes_sent_ += messages[rank].size();
  }
  return ranks_.exchange(std::move(messages));
}

/// A colour depends on those of earlier labels, so ranks choose one after the other. What takes long, to look who is
/// near, all do before.
template <int m>
void SharedPerturbation<m>::choose_colours(const Progress& progress) {
  const Rational reach = Placement<m>::reach(parameters_);
  const double distance = approximate_double(reach * atlas_.sampling_radius(Label(labels_.own.first))) * (1 + 0x1p-30);
  in_parts(
      "look for neighbours", labels_.own.size(), progress,
      [&](std::size_t first, std::size_t last) {
        std::vector<Sighting<m>> seen;
        for (std::size_t at = first; at < last; ++at) atlas_.sightings(Label(labels_.own.first + at), distance, seen);
        return true;
      },
      [](bool) {});
  std::vector<std::uint32_t> known(labels_.own.first);
  for (std::size_t turn = 0; turn < ranks_.size(); ++turn) {
    std::vector<Message> messages(ranks_.size());
    if (turn == ranks_.rank()) {
      colours_ = more_colours_of<m>(atlas_, reach, known, labels_.own.last, progress);
      for (std::size_t rank = turn + 1; rank < ranks_.size(); ++rank) {
        MessageWriter out;
        for (const std::uint32_t label : labels_.shown_to[rank]) out.put(colours_[label]);
        messages[rank] = out.take();
      }
    }
    const auto received = exchanged(std::move(messages));
    if (ranks_.rank() <= turn) continue;
    MessageReader in(received[turn]);
    for (std::uint32_t label = labels_.from[turn].first; label < labels_.from[turn].last; ++label)
      known[label] = in.get<std::uint32_t>();
  }
  for (std::uint32_t label = labels_.own.first; label < labels_.own.last; ++label) {
    if (colours_[label] >= of_colour_.size()) of_colour_.resize(colours_[label] + 1);
    of_colour_[colours_[label]].emplace_back(label);
  }
  colour_count_ = combined_everywhere(ranks_, static_cast<std::uint32_t>(of_colour_.size()),
                                      [](std::uint32_t a, std::uint32_t b) { return std::max(a, b); });
  of_colour_.resize(colour_count_);
}

template <int m>
void SharedPerturbation<m>::place_all(const Progress& progress) {
  choose_colours(progress);
  std::size_t done = 0;
  const std::uint32_t restored = restore();
  for (std::uint32_t colour = 0; colour < colour_count_; ++colour) {
    const auto& own = of_colour_[colour];
    if (colour >= restored) {
      place_of_one_colour(own, "perturb", [&](std::string_view stage, std::size_t at, std::size_t) {
        progress(stage, done + at, labels_.own.size());
      });
      add_to_log(own);
    }
    done += own.size();
  }
  compare_halos();
}

template <int m>
void SharedPerturbation<m>::place_anew(const std::vector<std::uint32_t>& names, const Progress& progress) {
  std::vector<std::vector<Label>> classes(colour_count_);
  for (const std::uint32_t name : names) {
    const auto label = labels_.named(name);
    if (!label) continue;
    state_.placed[label->value] = 0;
    if (labels_.own.contains(label->value)) classes[colours_[label->value]].push_back(*label);
  }
  // The colours that some rank has to place.
  std::vector<char> is_used(colour_count_, 0);
  for (std::uint32_t colour = 0; colour < colour_count_; ++colour)
    is_used[colour] = static_cast<char>(!classes[colour].empty());
  for (const Message& message : gather_everywhere(ranks_, Message(is_used.begin(), is_used.end()))) {
    for (std::uint32_t colour = 0; colour < colour_count_; ++colour) {
      if (message.at(colour) != 0) is_used[colour] = 1;
    }
  }
  for (std::uint32_t colour = 0; colour < colour_count_; ++colour) {
    if (is_used[colour] == 0) continue;
    std::sort(classes[colour].begin(), classes[colour].end());
    place_of_one_colour(classes[colour], "repair", progress);
  }
  compare_halos();
}

template <int m>
void SharedPerturbation<m>::place_of_one_colour(const std::vector<Label>& own, std::string_view stage,
                                                const Progress& progress) {
  statistics_ += place_in_parallel<m>(atlas_, parameters_, state_, own, stage, progress);
  exchange(own);
}

template <int m>
void SharedPerturbation<m>::exchange(const std::vector<Label>& placed) {
  std::vector<MessageWriter> out(ranks_.size());
  for (const Label label : placed) {
    const auto& place = place_[label.value - labels_.own.first];
    for (std::size_t at = 0; at < place.size(); at += 2) {
      out[place[at]].put(place[at + 1]);
      out[place[at]].put(state_.points.exact(label));
    }
  }
  std::vector<Message> messages;
  for (MessageWriter& writer : out) messages.push_back(writer.take());
  const auto received = exchanged(std::move(messages));
  for (std::size_t rank = 0; rank < received.size(); ++rank) {
    for (MessageReader in(received[rank]); !in.is_at_end();) {
      const auto position = in.get<std::uint32_t>();
      if (rank == ranks_.rank() || position >= labels_.from[rank].size())
        throw std::runtime_error("rank " + std::to_string(rank) +
                                 " has moved a point that is not in the halo of rank " + std::to_string(ranks_.rank()));
      const Label label(labels_.from[rank].first + position);
      auto point = in.get_point<static_cast<std::size_t>(m)>();
      const FilterGuard guard;
      state_.points.place(label, std::move(point));
      state_.placed[label.value] = 1;
    }
  }
}

template <int m>
void SharedPerturbation<m>::compare_halos() {
  const auto checksum = [&](const auto& labels) {
    MessageWriter text;
    for (const std::uint32_t label : labels) {
      text.put(state_.placed[label]);
      text.put(state_.points.exact(Label(label)));
    }
    MessageWriter result;
    result.put(checksum_of(text.take()));
    return result.take();
  };
  std::vector<Message> messages;
  for (const auto& shown : labels_.shown_to) messages.push_back(checksum(shown));
  const auto received = exchanged(std::move(messages));
  for (std::size_t rank = 0; rank < received.size(); ++rank) {
    if (rank == ranks_.rank()) continue;
    std::vector<std::uint32_t> here;
    for (std::uint32_t label = labels_.from[rank].first; label < labels_.from[rank].last; ++label)
      here.push_back(label);
    if (checksum(here) != received[rank])
      throw std::runtime_error("the halo of rank " + std::to_string(ranks_.rank()) + " is not what rank " +
                               std::to_string(rank) + " has placed");
  }
}

template <int m>
void SharedPerturbation<m>::add_to_log(const std::vector<Label>& placed) {
  if (log_ == nullptr) return;
  MessageWriter piece;
  for (const Label label : placed) {
    piece.put(state_.attempts[label.value]);
    piece.put(state_.points.exact(label));
  }
  log_->add(piece.take());
}

template <int m>
std::uint32_t SharedPerturbation<m>::restore() {
  const auto mine = static_cast<std::uint32_t>(log_ == nullptr ? 0 : log_->pieces().size());
  const auto common =
      std::min(colour_count_,
               combined_everywhere(ranks_, mine, [](std::uint32_t a, std::uint32_t b) { return std::min(a, b); }));
  if (log_ == nullptr) return 0;
  log_->keep(common);
  std::vector<Label> restored;
  for (std::uint32_t colour = 0; colour < common; ++colour) {
    MessageReader in(log_->pieces()[colour]);
    for (const Label label : of_colour_[colour]) {
      state_.attempts[label.value] = in.get<std::uint32_t>();
      auto point = in.get_point<static_cast<std::size_t>(m)>();
      const FilterGuard guard;
      state_.points.place(label, std::move(point));
      state_.placed[label.value] = 1;
      restored.push_back(label);
    }
    if (!in.is_at_end()) throw std::runtime_error("a log of placed points has more points than the colour has labels");
  }
  exchange(restored);
  return common;
}

template class SharedPerturbation<2>;
template class SharedPerturbation<3>;

}  // namespace delcert
