#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace delcert {

/// For each label, once somebody has asked for it, a list of the lifts near its point. Of lists that several threads
/// make at the same time any will do; the first is kept. When there are too many entries, no more lists are kept.
template <class List>
class NearLists {
 public:
  /// `most_entries`: about how many entries are kept in all.
  NearLists(std::size_t labels, std::size_t most_entries) : lists_(labels), most_entries_(most_entries) {}
  ~NearLists() {
    for (auto& list : lists_) delete list.load();
  }
  NearLists(const NearLists&) = delete;
  NearLists& operator=(const NearLists&) = delete;

  /// The list of this label, made by `make()` if there is none; none if it is not to be kept.
  template <class Make>
  [[nodiscard]] const List* of(std::uint32_t label, const Make& make) {
    if (const List* known = lists_[label].load(std::memory_order_acquire)) return known;
    if (entries_.load(std::memory_order_relaxed) >= most_entries_) return nullptr;
    auto made = std::make_unique<const List>(make());
    const List* expected = nullptr;
    if (!lists_[label].compare_exchange_strong(expected, made.get(), std::memory_order_acq_rel)) return expected;
    entries_.fetch_add(made->size(), std::memory_order_relaxed);
    return made.release();
  }

 private:
  std::vector<std::atomic<const List*>> lists_;
  std::size_t most_entries_;
  std::atomic<std::size_t> entries_ = 0;
};

}  // namespace delcert
