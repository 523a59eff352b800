// Stands for the library's header of this name, in WebAssembly: there is one thread. So a module whose port
// "learn" is wired is refused when it is loaded, as where the system has no more threads; no page has one.
#pragma once

#include <system_error>

namespace cca::detail {

class polled_thread {
public:
  template <class F>
  void start(F) {
    throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
  }
  bool has_ended() noexcept { return true; }
};

}  // namespace cca::detail
