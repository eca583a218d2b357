#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <new>

namespace delcert::checker {

/// Memory, at first zero, that processes which begin later have in common. Precondition: zero bytes are a T, and
/// nothing has to be done at its end.
template <class T>
class SharedArray {
 public:
  /// Throws std::bad_alloc.
  explicit SharedArray(std::size_t size) : bytes_(sizeof(T) * (size > 0 ? size : 1)) {
    void* const begin = ::mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (begin == MAP_FAILED) throw std::bad_alloc();
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

}  // namespace delcert::checker
