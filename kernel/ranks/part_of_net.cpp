#include "kernel/ranks/part_of_net.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "kernel/parallel/parts.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Cell = std::uint64_t;

constexpr unsigned bits_of_a_coordinate = 16;
constexpr std::int64_t middle_cell = 1 << 15;

/// Cells of ℝᵐ⁺¹ that are wider than the distance: points nearer than that are in cells that touch each other.
template <int m>
class Cells {
 public:
  explicit Cells(double distance) : width_(std::max(distance * (1 + 0x1p-10), 0x1p-13)) {}

  /// Of a point of the sphere, from its conformal coordinates.
  [[nodiscard]] Cell of(const Vector<Rational, m>& centre) const {
    std::array<double, static_cast<std::size_t>(m)> a{};
    double squared = 0;
    for (std::size_t axis = 0; axis < m; ++axis) {
      a[axis] = approximate_double(centre[axis]);
      squared += a[axis] * a[axis];
    }
    const double scale = 1 / (1 + squared / 4);
    Cell result = coordinate((1 - squared / 4) * scale);
    for (std::size_t axis = 0; axis < m; ++axis)
      result = (result << bits_of_a_coordinate) | coordinate(a[axis] * scale);
    return result;
  }

  /// Whether one of the cells, which are sorted, is this one or touches it.
  [[nodiscard]] static bool touches(const std::vector<Cell>& cells, Cell cell) {
    std::array<int, static_cast<std::size_t>(m) + 1> step{};
    step.fill(-1);
    for (;;) {
      // Steps along the last axis are next to each other in the order of the cells.
      Cell near = cell;
      for (std::size_t axis = 0; axis < m; ++axis)
        near += static_cast<Cell>(static_cast<std::int64_t>(step[axis])) << (bits_of_a_coordinate * (m - axis));
      const auto found = std::lower_bound(cells.begin(), cells.end(), near - 1);
      if (found != cells.end() && *found <= near + 1) return true;
      std::size_t axis = 0;
      while (axis < m && step[axis] == 1) step[axis++] = -1;
      if (axis == m) return false;
      ++step[axis];
    }
  }

 private:
  [[nodiscard]] Cell coordinate(double x) const {
    return static_cast<Cell>(static_cast<std::int64_t>(std::floor(x / width_)) + middle_cell);
  }

  double width_;
};

template <int m>
void put_points(MessageWriter& out, const std::vector<Vector<Rational, m>>& points,
                const std::vector<std::uint32_t>& places) {
  out.put(static_cast<std::uint32_t>(places.size()));
  for (const std::uint32_t at : places) out.put(points[at]);
}

template <int m>
void get_points(MessageReader& in, std::vector<Vector<Rational, m>>& points) {
  for (auto count = in.get<std::uint32_t>(); count > 0; --count)
    points.push_back(in.get_point<static_cast<std::size_t>(m)>());
}

std::vector<std::uint32_t> labels_in(LabelRange range) {
  std::vector<std::uint32_t> result;
  for (std::uint32_t label = range.first; label < range.last; ++label) result.push_back(label);
  return result;
}

std::vector<Cell> without_doubles(std::vector<Cell> cells) {
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

/// The cells of every rank.
std::vector<std::vector<Cell>> cells_of_all(Communicator& ranks, const std::vector<Cell>& mine) {
  MessageWriter out;
  for (const Cell cell : mine) out.put(cell);
  std::vector<std::vector<Cell>> result;
  for (const Message& message : gather_everywhere(ranks, out.take())) {
    result.emplace_back();
    for (MessageReader in(message); !in.is_at_end();) result.back().push_back(in.get<Cell>());
  }
  return result;
}

}  // namespace

LabelRange labels_of_rank(std::size_t all, std::size_t rank, std::size_t ranks) {
  const std::size_t parts = (all + usual_part_size - 1) / usual_part_size;
  const auto begin = [&](std::size_t at) {
    return static_cast<std::uint32_t>(std::min(all, parts * at / ranks * usual_part_size));
  };
  return {begin(rank), begin(rank + 1)};
}

std::size_t rank_of(std::uint32_t name, std::size_t all, std::size_t ranks) {
  // The least rank whose labels end beyond it.
  std::size_t first = 0;
  std::size_t last = ranks - 1;
  while (first < last) {
    const std::size_t middle = (first + last) / 2;
    if (name < labels_of_rank(all, middle, ranks).last) {
      last = middle;
    } else {
      first = middle + 1;
    }
  }
  return first;
}

std::optional<Label> LabelsHere::named(std::uint32_t name) const {
  if (own.size() > 0 && names[own.first] <= name && name <= names[own.last - 1]) return Label(name - names_begin());
  const auto found = std::lower_bound(names.begin(), names.end(), name);
  if (found == names.end() || *found != name) return std::nullopt;
  return Label(found - names.begin());
}

template <int m>
PartOfNet<m> part_of_net(Communicator& ranks, std::vector<Vector<Rational, m>> whole, double distance) {
  std::vector<Message> messages(ranks.size());
  if (ranks.rank() == 0) {
    if (whole.size() < usual_part_size * ranks.size())
      throw Rejection(std::to_string(whole.size()) + " points are too few for " + std::to_string(ranks.size()) +
                      " ranks: each has at least " + std::to_string(usual_part_size));
    for (std::size_t rank = 0; rank < ranks.size(); ++rank) {
      MessageWriter out;
      out.put(static_cast<std::uint64_t>(whole.size()));
      put_points<m>(out, whole, labels_in(labels_of_rank(whole.size(), rank, ranks.size())));
      messages[rank] = out.take();
    }
    whole = {};
  }
  const Message mine = ranks.exchange(std::move(messages))[0];
  MessageReader in(mine);
  const auto all = static_cast<std::size_t>(in.get<std::uint64_t>());
  std::vector<Vector<Rational, m>> own;
  get_points<m>(in, own);

  const Cells<m> cells(distance);
  std::vector<Cell> cell_of;
  for (const auto& centre : own) cell_of.push_back(cells.of(centre));
  const auto touched = without_doubles(cell_of);
  const auto of_all = cells_of_all(ranks, touched);
  PartOfNet<m> result;
  LabelsHere& labels = result.labels;
  labels.all = all;
  const LabelRange names = labels_of_rank(all, ranks.rank(), ranks.size());
  messages.assign(ranks.size(), {});
  labels.shown_to.resize(ranks.size());
  for (std::size_t rank = 0; rank < ranks.size(); ++rank) {
    MessageWriter out;
    if (rank != ranks.rank()) {
      std::vector<Cell> near;
      for (const Cell cell : touched) {
        if (Cells<m>::touches(of_all[rank], cell)) near.push_back(cell);
      }
      for (std::uint32_t at = 0; at < own.size(); ++at) {
        if (std::binary_search(near.begin(), near.end(), cell_of[at])) labels.shown_to[rank].push_back(at);
      }
    }
    for (const std::uint32_t at : labels.shown_to[rank]) out.put(names.first + at);
    MessageWriter message;
    message.put(out.take());
    put_points<m>(message, own, labels.shown_to[rank]);
    messages[rank] = message.take();
  }
  const auto received = ranks.exchange(std::move(messages));
  for (std::size_t rank = 0; rank < ranks.size(); ++rank) {
    const auto first = static_cast<std::uint32_t>(labels.names.size());
    if (rank == ranks.rank()) {
      for (const std::uint32_t name : labels_in(names)) labels.names.push_back(name);
      std::move(own.begin(), own.end(), std::back_inserter(result.centres));
    } else {
      MessageReader halo(received[rank]);
      const std::string text = halo.get_text();
      for (MessageReader list(text); !list.is_at_end();) labels.names.push_back(list.get<std::uint32_t>());
      get_points<m>(halo, result.centres);
    }
    labels.from.push_back({first, static_cast<std::uint32_t>(labels.names.size())});
  }
  if (labels.names.size() != result.centres.size() || !std::is_sorted(labels.names.begin(), labels.names.end()))
    throw std::runtime_error("what other ranks have shown is not a list of labels with their points");
  labels.own = labels.from[ranks.rank()];
  // Until here these were counted from the first own label.
  for (auto& shown : labels.shown_to) {
    for (std::uint32_t& label : shown) label += labels.own.first;
  }
  return result;
}

#define DELCERT_INSTANTIATE(m) \
  template PartOfNet<m> part_of_net<m>(Communicator&, std::vector<Vector<Rational, m>>, double);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
