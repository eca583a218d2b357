#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace delcert {

/// Things that parts of parallel work need one each of, and that are worth keeping for the next part. No more are made
/// than parts run at the same time. Which part gets which must not matter.
template <class T>
class Spares {
 public:
  /// use(T&) with a spare one, or with *make() if there is none. If it throws, this one is given up.
  template <class Make, class Use>
  auto with(const Make& make, const Use& use) {
    std::unique_ptr<T> mine = take();
    if (!mine) mine = make();
    auto result = use(*mine);
    const std::scoped_lock lock(mutex_);
    spares_.push_back(std::move(mine));
    return result;
  }

 private:
  std::unique_ptr<T> take() {
    const std::scoped_lock lock(mutex_);
    if (spares_.empty()) return nullptr;
    auto result = std::move(spares_.back());
    spares_.pop_back();
    return result;
  }

  std::mutex mutex_;
  std::vector<std::unique_ptr<T>> spares_;
};

}  // namespace delcert
