#include "proofs/checker/program/merge.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace delcert::checker {
namespace {

constexpr int not_the_whole = 1, incomplete = 2, foreign = 3;

void require(const char* rule, bool holds, int status, const std::string& what) {
  if (!holds && !Report::disabled(rule)) throw Refused{{rule, what}, status};
}

std::string fraction(std::uint64_t number, std::uint64_t of) {
  return std::to_string(number) + "/" + std::to_string(of);
}

std::string part_of(const NamedReceipt& one) {
  const Share& share = one.receipt.outcome.share;
  return one.file + " (part " + fraction(share.number, share.of) + ")";
}

/// All of the same certificate, by the same program.
void require_same(const std::vector<NamedReceipt>& all, const std::string& checker, const std::string& content) {
  const Outcome& first = all.front().receipt.outcome;
  for (const NamedReceipt& one : all) {
    const Outcome& other = one.receipt.outcome;
    require("merge.version", one.receipt.checker == checker, foreign,
            one.file + ": by version " + one.receipt.checker + " of the checker, and this is " + checker);
    require("merge.certificate", content.empty() || other.content == content, foreign,
            one.file + ": of a certificate with the SHA-256 " + other.content + ", not of this one with " + content);
    const auto stated = [](const Outcome& outcome) {
      return std::tuple(outcome.content, outcome.points, outcome.simplices, outcome.euler_characteristic,
                        outcome.identity->manifold_digest, outcome.chunk ? outcome.chunk->root : std::string());
    };
    require("merge.certificate", stated(other) == stated(first), foreign,
            one.file + ": of another certificate than " + all.front().file);
  }
}

/// The rules of the loops and the undivided rules, level by level: parts of one check have the same.
std::vector<std::string> rules_of(const Outcome& outcome) {
  std::vector<std::string> rules;
  for (const LevelResult& level : outcome.levels) {
    rules.push_back("level " + level.level);
    for (const Range& range : level.ranges) {
      rules.push_back(range.rules + " of " + std::to_string(range.size) + " items");
      for (const auto& count : range.counts) rules.push_back(count.first);
    }
    for (const auto* list : {&level.done, &level.left}) rules.insert(rules.end(), list->begin(), list->end());
  }
  return rules;
}

void require_same_rules(const std::vector<NamedReceipt>& all) {
  const std::vector<std::string> first = rules_of(all.front().receipt.outcome);
  for (const NamedReceipt& one : all) {
    const std::vector<std::string> rules = rules_of(one.receipt.outcome);
    const auto [a, b] = std::mismatch(first.begin(), first.end(), rules.begin(), rules.end());
    require("merge.rules", a == first.end() && b == rules.end(), not_the_whole,
            one.file + " has " + (b == rules.end() ? "nothing" : *b) + " where " + all.front().file + " has " +
                (a == first.end() ? "nothing" : *a));
  }
}

void require_each_part_once(const std::vector<NamedReceipt>& all) {
  for (std::size_t k = 1; k < all.size(); ++k) {
    const Share &a = all[k - 1].receipt.outcome.share, &b = all[k].receipt.outcome.share;
    require("merge.doubled", a.number != b.number || a.of != b.of, not_the_whole,
            all[k - 1].file + " and " + part_of(all[k]) + " are of the same part");
  }
}

/// The shares are disjoint and fill the whole. So are and do the ranges of each loop: they are those of the shares,
/// which receipt_of requires, of as many items in all receipts, which merge.rules does. Precondition: sorted by their
/// beginnings.
void require_the_whole(const std::vector<NamedReceipt>& all) {
  Share covered{0, 1};  // up to the fraction number / of; no product exceeds 10^12
  const auto require_up_to = [&](std::uint64_t number, std::uint64_t of) {
    require("merge.missing", number * covered.of <= covered.number * of, incomplete,
            "what lies between " + fraction(covered.number, covered.of) + " and " + fraction(number, of) +
                " of each loop is missing");
  };
  for (const NamedReceipt& one : all) {
    const Share& share = one.receipt.outcome.share;
    require("merge.overlap", (share.number - 1) * covered.of >= covered.number * share.of, not_the_whole,
            part_of(one) + " begins before " + fraction(covered.number, covered.of) + ", where another part ends");
    require_up_to(share.number - 1, share.of);
    if (share.number * covered.of > covered.number * share.of) covered = share;
  }
  require_up_to(1, 1);
}

/// The chunks have each label and each simplex once, in the order of their numbers; and their trees are joined to one.
/// Precondition: sorted, and together the whole.
void require_the_chunks(const std::vector<NamedReceipt>& all) {
  std::uint64_t label = 0, simplex = 0;
  std::vector<std::uint64_t> first_tree{0};
  for (const NamedReceipt& one : all) {
    const Outcome::Chunk& chunk = *one.receipt.outcome.chunk;
    if (one.receipt.outcome.share.of != all.size())
      throw Refused{{"merge.chunks", part_of(one) + " is of another number of chunks"}, not_the_whole};
    require("merge.chunks", chunk.first_label == label && chunk.first_simplex == simplex, not_the_whole,
            part_of(one) + " does not begin where the chunk before it ends");
    label = chunk.end_label;
    simplex = chunk.end_simplex;
    first_tree.push_back(first_tree.back() + chunk.trees);
  }
  const Outcome& last = all.back().receipt.outcome;
  require("merge.chunks", label == last.points && simplex == last.simplices, not_the_whole,
          part_of(all.back()) + " does not end with the last label and the last simplex");
  const Outcome& first = all.front().receipt.outcome;
  for (std::size_t level = 0; level < first.levels.size(); ++level) {
    for (std::size_t loop = 0; loop < first.levels[level].ranges.size(); ++loop) {
      std::uint64_t items = 0;
      for (const NamedReceipt& one : all) {
        const Range& range = one.receipt.outcome.levels[level].ranges[loop];
        items += range.end - range.begin;
      }
      const Range& range = first.levels[level].ranges[loop];
      require("merge.count", items == range.size, not_the_whole,
              "level " + first.levels[level].level + ", " + range.rules + ": expected are " +
                  std::to_string(range.size) + " items, and the receipts add up to " + std::to_string(items));
    }
  }
  std::vector<std::uint64_t> parent(first_tree.back());
  std::iota(parent.begin(), parent.end(), std::uint64_t{0});
  const auto root = [&](std::uint64_t tree) {
    while (parent[tree] != tree) tree = parent[tree] = parent[parent[tree]];
    return tree;
  };
  std::uint64_t components = parent.size();
  for (std::size_t k = 0; k < all.size(); ++k) {
    for (const auto& [tree, before, there] : all[k].receipt.outcome.chunk->joins) {
      require("merge.chunks", there < first_tree[before + 1] - first_tree[before], not_the_whole,
              part_of(all[k]) + " is joined to a tree that " + part_of(all[before]) + " has not");
      if (there >= first_tree[before + 1] - first_tree[before]) continue;
      const std::uint64_t a = root(first_tree[k] + tree), b = root(first_tree[before] + there);
      if (a == b) continue;
      parent[a] = b;
      --components;
    }
  }
  require("merge.connected", components == 1, not_the_whole,
          "the complex has " + std::to_string(components) + " components");
}

/// Of the parts, that which has done what is not divided.
const Outcome& first_part(const std::vector<NamedReceipt>& all) {
  const NamedReceipt* first = nullptr;
  for (const NamedReceipt& one : all) {
    if (one.receipt.outcome.share.number != 1) continue;
    require("merge.doubled", first == nullptr, not_the_whole,
            part_of(one) + " has done what is not divided, as " + (first == nullptr ? "" : part_of(*first)) + " has");
    first = &one;
  }
  require("merge.missing", first != nullptr, incomplete, "part 1, which does what is not divided, is missing");
  return (first == nullptr ? all.front() : *first).receipt.outcome;
}

/// What the receipts have counted, added up.
void add(Outcome& sum, const Outcome& other) {
  for (std::size_t level = 0; level < sum.levels.size(); ++level) {
    LevelResult& to = sum.levels[level];
    const LevelResult& from = other.levels[level];
    to.seconds += from.seconds;
    for (std::size_t loop = 0; loop < to.ranges.size(); ++loop) {
      for (std::size_t k = 0; k < to.ranges[loop].counts.size(); ++k)
        to.ranges[loop].counts[k].second += from.ranges[loop].counts[k].second;
    }
  }
  sum.decisions.filtered += other.decisions.filtered;
  sum.decisions.exact += other.decisions.exact;
  sum.decisions.enclosed += other.decisions.enclosed;
  if (sum.identity->file_digest != other.identity->file_digest) sum.identity->file_digest.clear();
}

/// Rule 2.count, which no part could look at; and that loops have looked at all simplices, labels and facets.
void require_counts(const Outcome& sum) {
  for (const LevelResult& level : sum.levels) {
    for (const Range& range : level.ranges) {
      for (const auto& [name, number] : range.counts) {
        const auto require_count = [&, name = name, number = number](bool holds, std::int64_t expected) {
          require("merge.count", holds, not_the_whole,
                  "level " + level.level + ": expected are " + name + " " + std::to_string(expected) +
                      ", and the receipts add up to " + std::to_string(number));
        };
        const auto simplices = static_cast<std::int64_t>(sum.simplices), points = static_cast<std::int64_t>(sum.points);
        if (name == "simplices") require_count(number == simplices, simplices);
        if (name == "euler_characteristic") require_count(number == sum.euler_characteristic, sum.euler_characteristic);
        if (name == "stars") require_count(number <= points, points);
        if (name == "facets")
          require_count(number == static_cast<std::int64_t>(range.size), static_cast<std::int64_t>(range.size));
      }
    }
  }
}

}  // namespace

Outcome merged(std::vector<NamedReceipt> receipts, const std::string& checker, const std::string& content) {
  // The order in which they are given has no effect.
  std::stable_sort(receipts.begin(), receipts.end(), [](const NamedReceipt& a, const NamedReceipt& b) {
    const Share &x = a.receipt.outcome.share, &y = b.receipt.outcome.share;
    const std::uint64_t at_x = (x.number - 1) * y.of, at_y = (y.number - 1) * x.of;
    return at_x != at_y ? at_x < at_y : x.of < y.of;
  });
  require_same(receipts, checker, content);
  for (const int worse : {1, 2}) {
    for (const NamedReceipt& one : receipts) {
      if (one.receipt.outcome.status == worse) return one.receipt.outcome;
    }
  }
  require_each_part_once(receipts);
  require_same_rules(receipts);
  Outcome sum = first_part(receipts);
  require_the_whole(receipts);
  if (sum.chunk) require_the_chunks(receipts);
  const Share first = sum.share;
  for (const NamedReceipt& one : receipts) {
    const Outcome& other = one.receipt.outcome;
    if (other.share.number != first.number || other.share.of != first.of) add(sum, other);
  }
  require_counts(sum);
  sum.share = {};
  sum.chunk.reset();
  return sum;
}

}  // namespace delcert::checker
