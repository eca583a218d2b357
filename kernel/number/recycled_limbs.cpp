#include "kernel/number/recycled_limbs.hpp"

#include <gmp.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <new>

namespace delcert {

namespace {

/// What GMP asks for.
struct MemoryFunctions {
  void* (*allocate)(std::size_t) = nullptr;
  void* (*reallocate)(void*, std::size_t, std::size_t) = nullptr;
  void (*release)(void*, std::size_t) = nullptr;
};

/// Those that were there before the guards, from which all blocks come.
constinit MemoryFunctions original;

constexpr std::size_t limb_size = sizeof(mp_limb_t);
constexpr std::size_t most_limbs = 32;
constexpr unsigned most_blocks = 1024;  ///< of one length

struct Block {
  Block* next;
};
static_assert(sizeof(Block) <= limb_size);

struct Shelf {
  Block* first = nullptr;
  unsigned count = 0;
};

/// Without a destructor, so that reading it takes no call; `Closing` empties it.
struct Shelves {
  std::array<Shelf, most_limbs + 1> of_length;
  bool is_open = false;
  bool is_closed = false;  ///< the thread ends
};
constinit thread_local Shelves shelves;

void give_back_all() {
  for (std::size_t limbs = 1; limbs <= most_limbs; ++limbs) {
    Shelf& shelf = shelves.of_length[limbs];
    while (shelf.first != nullptr) {
      Block* const block = shelf.first;
      shelf.first = block->next;
      original.release(block, limbs * limb_size);
    }
    shelf.count = 0;
  }
}

struct Closing {
  Closing() = default;
  Closing(const Closing&) = delete;
  Closing& operator=(const Closing&) = delete;
  ~Closing() {
    give_back_all();
    shelves.is_closed = true;
  }
};

/// 0 for what is not kept.
std::size_t limbs_of(std::size_t size) {
  return size % limb_size == 0 && size <= most_limbs * limb_size ? size / limb_size : 0;
}

void* allocate(std::size_t size) {
  const std::size_t limbs = limbs_of(size);
  Shelf& shelf = shelves.of_length[limbs];
  if (limbs == 0 || shelf.first == nullptr) return original.allocate(size);
  Block* const block = shelf.first;
  shelf.first = block->next;
  --shelf.count;
  return block;
}

[[gnu::noinline]] void open_shelves() {
  static thread_local Closing closing;
  shelves.is_open = true;
}

void release(void* memory, std::size_t size) {
  const std::size_t limbs = limbs_of(size);
  Shelf& shelf = shelves.of_length[limbs];
  if (limbs == 0 || shelf.count == most_blocks || shelves.is_closed) return original.release(memory, size);
  if (!shelves.is_open) open_shelves();
  shelf.first = new (memory) Block{shelf.first};
  ++shelf.count;
}

void* reallocate(void* memory, std::size_t old_size, std::size_t new_size) {
  if (limbs_of(old_size) == 0 || limbs_of(new_size) == 0) return original.reallocate(memory, old_size, new_size);
  if (old_size == new_size) return memory;
  void* const result = allocate(new_size);
  std::memcpy(result, memory, std::min(old_size, new_size));
  release(memory, old_size);
  return result;
}

int guard_count = 0;

}  // namespace

RecycledLimbs::RecycledLimbs() {
  if (++guard_count > 1) return;
  mp_get_memory_functions(&original.allocate, &original.reallocate, &original.release);
  mp_set_memory_functions(allocate, reallocate, release);
}

RecycledLimbs::~RecycledLimbs() {
  if (--guard_count > 0) return;
  mp_set_memory_functions(original.allocate, original.reallocate, original.release);
  give_back_all();
}

unsigned RecycledLimbs::kept() {
  unsigned result = 0;
  for (const Shelf& shelf : shelves.of_length) result += shelf.count;
  return result;
}

}  // namespace delcert
