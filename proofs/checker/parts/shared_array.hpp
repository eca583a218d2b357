#pragma once

#include <sys/mman.h>

#include <atomic>
#include <cstddef>
#include <new>

#include "proofs/checker/parts/parts.hpp"

namespace delcert::checker {

/// Memory, at first zero, that processes which begin later have in common, if a check has several. Precondition: zero
/// bytes are a T, and nothing has to be done at its end.
template <class T>
class SharedArray {
 public:
  /// Throws std::bad_alloc.
  explicit SharedArray(std::size_t size) : bytes_(sizeof(T) * (size > 0 ? size : 1)) {
    // Memory of one process has larger pages.
    const int sharing = most_parts > 1 ? MAP_SHARED : MAP_PRIVATE;
    void* const begin = ::mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, sharing | MAP_ANONYMOUS, -1, 0);
    if (begin == MAP_FAILED) {
      if (const std::new_handler no_memory = std::get_new_handler()) no_memory();
      throw std::bad_alloc();
    }
    items_ = static_cast<T*>(begin);
  }
  SharedArray(const SharedArray&) = delete;
  SharedArray& operator=(const SharedArray&) = delete;
  ~SharedArray() { ::munmap(items_, bytes_); }

  T& operator[](std::size_t at) { return items_[at]; }

 private:
  std::size_t bytes_;
  T* items_ = nullptr;
};

/// What is found of each of so many things, once, by whichever process.
template <class T>
class SharedFindings {
 public:
  explicit SharedFindings(std::size_t size) : found_(size) {}

  /// Of one of them: what find() returned when it was asked for. Precondition: whenever that is, it returns the same.
  template <class Find>
  const T& of(std::size_t at, const Find& find) {
    Found& found = found_[at];
    if (!found.is_found.load(std::memory_order_acquire)) {
      found.what = find();
      found.is_found.store(true, std::memory_order_release);
    }
    return found.what;
  }

 private:
  struct Found {
    T what;
    std::atomic<bool> is_found;  // after it is written
  };
  SharedArray<Found> found_;
};

}  // namespace delcert::checker
