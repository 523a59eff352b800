// Counts every allocation of the process, for the laws; under a sanitizer, which has a malloc of its own, it counts `new`.
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define CCA_TEST_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define CCA_TEST_SANITIZED 1
#endif
#endif

namespace {
std::atomic<std::size_t> count{0};
}

namespace laws {
std::size_t allocations();
std::size_t allocations() { return count; }
}  // namespace laws

#ifndef CCA_TEST_SANITIZED
extern "C" {
void* __libc_malloc(std::size_t);
void* malloc(std::size_t size) {
  ++count;
  return __libc_malloc(size);
}
}
#else
void* operator new(std::size_t size) {
  ++count;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
#endif
