// Counts every allocation of the process, for the laws, by replacing malloc itself, so that none is missed.
// Under a sanitizer, which has its own malloc, it counts by the sanitizer's hook.
#include <atomic>
#include <cstddef>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define CCA_TEST_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define CCA_TEST_SANITIZED 1
#endif
#endif

namespace {
class counter {
public:
  void operator++() {
    ++all;
    ++own;
  }
  std::size_t total() const { return all; }
  static std::size_t of_this_thread() { return own; }

private:
  std::atomic<std::size_t> all{0};
  static inline thread_local std::size_t own = 0;
};
counter count;
}  // namespace

namespace laws {
std::size_t allocations();
std::size_t allocations() { return count.total(); }
std::size_t allocations_of_this_thread();
std::size_t allocations_of_this_thread() { return counter::of_this_thread(); }
}  // namespace laws

extern "C" {
#ifdef CCA_TEST_SANITIZED
void __sanitizer_malloc_hook(const volatile void*, std::size_t) { ++count; }
void __sanitizer_free_hook(const volatile void*) {}
#else
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void* malloc(std::size_t size) {
  ++count;
  return __libc_malloc(size);
}
void* calloc(std::size_t number, std::size_t size) {
  ++count;
  return __libc_calloc(number, size);
}
void* realloc(void* old, std::size_t size) {
  ++count;
  return __libc_realloc(old, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++count;
  return __libc_memalign(alignment, size);
}
#endif
}
