#pragma once

#include <flint/flint.h>

// Calcium's headers are C and let void* become any other pointer, which C++ does not. While they are read, what
// allocates returns something that converts to every pointer.
namespace delcert::detail {
struct AnyPointer {
  void* pointer;
  template <class T>
  operator T*() const {
    return static_cast<T*>(pointer);
  }
};
inline AnyPointer any_pointer(void* pointer) { return {pointer}; }
}  // namespace delcert::detail

#define flint_malloc(size) delcert::detail::any_pointer(flint_malloc(size))
#define flint_realloc(pointer, size) delcert::detail::any_pointer(flint_realloc(pointer, size))
#if __has_include(<flint/qqbar.h>)  // FLINT 3
#include <flint/qqbar.h>
#else
#include <calcium/qqbar.h>
#endif
#undef flint_malloc
#undef flint_realloc
