// How the thread of an environment runs: options of `environment`, beside `free_running`.
//
//   cca::environment<"robot", cca::nodes<"robot", "limits">, cca::realtime<80, cca::on_core<1>>>
//
// `realtime<Priority>`: SCHED_FIFO with this priority (1 to 99), on one core if it says so, and the memory of
// the process locked, its stack touched: then no page fault interrupts a beat. `run` is refused where the
// system refuses, with what to do about it. `realtime_if_allowed` goes on without what is refused, and says
// so on the standard error output; without its priority it is not pinned either, because then it would only
// wait for others on its core. When a run ends, the thread that called `run` is as it was; memory stays
// locked.
//
// Memory is locked only if all of it may be, whatever the process allocates later. Within a limit
// (RLIMIT_MEMLOCK) the system would lock what there is, and then refuse allocations, threads and stacks.
#pragma once

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <string_view>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/graph/deployment/environments.hpp>

namespace cca {

namespace detail {

template <int Number>
struct no_core {
  static constexpr void tell(text& m) {
    m << "deployment.bad_environment: `cca::on_core<" << Number
      << ">` is no core: they are counted from 0, as `nproc --all` says how many there are";
  }
};

}  // namespace detail

template <int Number>
struct on_core {
  static_assert(detail::holds_or_tells<(Number >= 0), detail::no_core<Number>>::value);
};

// Where: `on_core<N>`, or nothing.
template <int Priority, class... Where>
struct realtime {};
template <int Priority, class... Where>
struct realtime_if_allowed {};

namespace detail {

struct thread_wish {
  int priority = 0;  // 0: none
  int core = -1;     // any
  bool is_needed = false;
};

template <class Option>
struct wish_of {
  static_assert(sizeof(Option) == 0,
                "cca::environment: after the nodes stand options of its thread, cca::realtime<Priority> or "
                "cca::realtime_if_allowed<Priority>, with cca::on_core<N> in it or not");
};
template <int Priority>
struct no_priority {
  static constexpr void tell(text& m) {
    m << "deployment.bad_environment: the priority " << Priority
      << " of cca::realtime is none: they go from 1 to 99, the most urgent";
  }
};
template <int Priority, int... Core>
constexpr thread_wish make_wish(bool is_needed) {
  static_assert(holds_or_tells<(Priority >= 1 && Priority <= 99), no_priority<Priority>>::value);
  static_assert(sizeof...(Core) <= 1, "cca::realtime: at most one core");
  return {Priority, sizeof...(Core) == 0 ? -1 : (-1 + ... + (Core + 1)), is_needed};
}
template <int Priority, int... Core>
struct wish_of<realtime<Priority, on_core<Core>...>> {
  static constexpr thread_wish value = make_wish<Priority, Core...>(true);
};
template <int Priority, int... Core>
struct wish_of<realtime_if_allowed<Priority, on_core<Core>...>> {
  static constexpr thread_wish value = make_wish<Priority, Core...>(false);
};

template <>
struct wish_of<free_running> {
  static constexpr thread_wish value{};
};

// At most one says how the thread runs (deployment.bad_environment).
template <class Options>
inline constexpr thread_wish wish_among{};
template <class... Option>
inline constexpr thread_wish wish_among<list<Option...>> = [] {
  thread_wish all;
  ((wish_of<Option>::value.priority > 0 ? void(all = wish_of<Option>::value) : void()), ...);
  return all;
}();

// What the system refused, and what to do; empty: nothing.
class thread_setup {
public:
  explicit thread_setup(const thread_wish& wish) {
    if (wish.priority == 0) return;
    is_set = true;
    ::pthread_getschedparam(::pthread_self(), &policy_before, &parameter_before);
    ::pthread_getaffinity_np(::pthread_self(), sizeof cores_before, &cores_before);
    if (schedule(wish.priority)) pin(wish.core);
    lock_memory(!wish.is_needed);
    touch_stack();
  }
  ~thread_setup() {
    if (!is_set) return;
    ::pthread_setschedparam(::pthread_self(), policy_before, &parameter_before);
    ::pthread_setaffinity_np(::pthread_self(), sizeof cores_before, &cores_before);
  }
  thread_setup(const thread_setup&) = delete;
  thread_setup& operator=(const thread_setup&) = delete;

  const std::string& refusal() const { return text; }

private:
  void refuse(const std::string& what, std::string_view why, std::string_view remedy) {
    if (!text.empty()) text += "; ";
    text.append(what).append(": ").append(why).append("; ").append(remedy);
  }
  // `in_part`: also if something else is refused.
  void lock_memory(bool in_part) {
    std::string why;
    if (!may_lock_all_memory())
      why = "the limit must be unlimited, because it counts all that is allocated later";
    else if ((in_part || text.empty()) && ::mlockall(MCL_CURRENT | MCL_FUTURE) != 0)
      why = std::strerror(errno);
    if (!why.empty())
      refuse("its memory can't be locked", why,
             "put `<user> - memlock unlimited` into /etc/security/limits.conf and log in again");
  }
  // Only the system knows whether a limit counts for this process: so it is asked for more than the limit.
  // The pages are never touched, so this takes no memory.
  static bool may_lock_all_memory() {
    rlimit limit{};
    if (::getrlimit(RLIMIT_MEMLOCK, &limit) != 0) return false;
    constexpr rlim_t page = 4096, address_space = rlim_t{1} << 46;
    if (limit.rlim_cur > address_space) return true;
    const std::size_t size = limit.rlim_cur / page * page + 2 * page;
    void* const at = ::mmap(nullptr, size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (at == MAP_FAILED) return false;
    const bool may = ::mlock2(at, size, MLOCK_ONFAULT) == 0;
    ::munmap(at, size);
    return may;
  }
  // The beats find their pages there.
  [[gnu::noinline]] static void touch_stack() {
    unsigned char pages[256 * 1024];
    for (std::size_t at = 0; at < sizeof pages; at += 4096)
      const_cast<volatile unsigned char&>(pages[at]) = 0;
  }
  void pin(int core) {
    if (core < 0) return;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(static_cast<std::size_t>(core), &one);
    if (const int error = ::pthread_setaffinity_np(::pthread_self(), sizeof one, &one); error != 0)
      refuse("core " + std::to_string(core) + " can't be used", std::strerror(error),
             "give cca::on_core a number that `nproc --all` and the cgroup of the process allow");
  }
  bool schedule(int priority) {
    sched_param parameter{};
    parameter.sched_priority = priority;
    const int error = ::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &parameter);
    if (error != 0)
      refuse("SCHED_FIFO with priority " + std::to_string(priority), std::strerror(error),
             "put `<user> - rtprio " + std::to_string(priority) +
                 "` into /etc/security/limits.conf and log in again, or give the program the capability, "
                 "`sudo setcap cap_sys_nice,cap_ipc_lock+ep <program>`; or use cca::realtime_if_allowed");
    return error == 0;
  }

  std::string text;
  bool is_set = false;
  int policy_before = SCHED_OTHER;
  sched_param parameter_before{};
  cpu_set_t cores_before{};
};

template <class D, int E>
inline constexpr thread_wish wish_of_environment = wish_among<options_of_environment<D, E>>;

}  // namespace detail
}  // namespace cca
