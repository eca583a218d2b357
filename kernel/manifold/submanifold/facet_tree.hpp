#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

namespace delcert {

/// A box with sides parallel to the axes, in space.
struct SpaceBox {
  std::array<double, 3> lower;
  std::array<double, 3> upper;
};

/// Boxes in space, each in a box of a binary tree, for "all that may meet something".
class FacetTree {
 public:
  explicit FacetTree(std::vector<SpaceBox> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    if (!order_.empty()) divide(0, static_cast<std::uint32_t>(order_.size()));
  }

  /// Calls visit(number) for every box for which may_meet(box) is true, and is so for all that contain it in the tree;
  /// in an order that depends on the boxes alone.
  template <class MayMeet, class Visit>
  void visit(const MayMeet& may_meet, const Visit& visit) const {
    std::vector<std::uint32_t> open;
    if (!nodes_.empty()) open.push_back(0);
    while (!open.empty()) {
      const std::uint32_t at = open.back();
      open.pop_back();
      const Node& node = nodes_[at];
      if (!may_meet(node.box)) continue;
      if (node.right != 0) {
        open.push_back(node.right);
        open.push_back(at + 1);
        continue;
      }
      for (std::uint32_t k = node.first; k < node.last; ++k) {
        if (may_meet(boxes_[order_[k]])) visit(order_[k]);
      }
    }
  }

 private:
  static constexpr std::uint32_t leaf_size = 4;

  struct Node {
    SpaceBox box;
    std::uint32_t first, last;
    std::uint32_t right;  ///< the second child; the first one follows. 0: there are none
  };

  void divide(std::uint32_t first, std::uint32_t last) {
    const auto at = static_cast<std::uint32_t>(nodes_.size());
    SpaceBox box = boxes_[order_[first]];
    for (std::uint32_t k = first; k < last; ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        box.lower[axis] = std::min(box.lower[axis], boxes_[order_[k]].lower[axis]);
        box.upper[axis] = std::max(box.upper[axis], boxes_[order_[k]].upper[axis]);
      }
    }
    nodes_.push_back({box, first, last, 0});
    if (last - first <= leaf_size) return;
    std::size_t longest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis) {
      if (box.upper[axis] - box.lower[axis] > box.upper[longest] - box.lower[longest]) longest = axis;
    }
    const auto key = [&](std::uint32_t k) { return boxes_[k].lower[longest] / 2 + boxes_[k].upper[longest] / 2; };
    const std::uint32_t middle = first + (last - first) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b) || (key(a) == key(b) && a < b); });
    divide(first, middle);
    nodes_[at].right = static_cast<std::uint32_t>(nodes_.size());
    divide(middle, last);
  }

  std::vector<SpaceBox> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace delcert
