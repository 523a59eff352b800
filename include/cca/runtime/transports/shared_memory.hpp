// Environments in several processes of one machine: what they exchange lies in POSIX shared memory, which
// only this user may open. Nothing in it locks, so a process may die at any instruction.
//
//   cca::deployed<split> d(cca::only{"robot"}, cca::shared_memory("/trot"));
//
// The processes must have been compiled from the same deployment; the memory begins with what they must agree
// on. A process holds a lock of the file for each environment that it runs. The system takes it away when the
// process ends, however it does: so nobody runs an environment twice, and others see that it is gone. The
// last process removes the memory; what a killed one leaves, the next one begins anew.
//
// Who removes the name of the file (`rm`, systemd at logout) does not hinder those that run; they say so. A
// claim of its own for each environment (machine_claim.hpp) then still keeps a second process away.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>

#include <cca/base/fixed_string.hpp>
#include <cca/base/monotonic_clock.hpp>
#include <cca/base/refused.hpp>
#include <cca/runtime/signals/write_if_possible.hpp>
#include <cca/runtime/environments/exchange/exchange.hpp>
#include <cca/runtime/transports/machine_claim.hpp>
#include <cca/runtime/transports/manifest.hpp>
#include <cca/runtime/environments/exchange/peers.hpp>
#include <cca/runtime/transports/regular_look.hpp>
#include <cca/runtime/transports/shared_file.hpp>

namespace cca {
namespace detail {

// The memory: a head, the manifest, what is exchanged.
template <class D>
class shared_exchange : public peers {
public:
  shared_exchange(const std::string& name, const environments_here<D>& is_here)
      : file(name), here(is_here), manifest(manifest_of<D>()) {
    file.wait_for_named(setup_byte, longest_setup);
    const bool is_first = !is_anybody_else_here();
    try {
      claim();
      if (is_first) refuse_lost_memory();
      if (is_first) file.make_anew(size());
      else compare();
      at = file.map(size());
      if (is_first) fill();
      join();
    } catch (...) {
      if (is_first) file.remove();
      throw;
    }
    file.unlock(setup_byte);
    watch.emplace([this] { look(); });
  }
  // If another process hangs with the lock, the name stays for the next one.
  ~shared_exchange() override {
    watch.reset();
    if (file.wait_for(setup_byte, longest_setup) && !is_anybody_else_here()) file.remove();
    ::munmap(at, size());
  }

  // Its process has ended, or came again and is not part of this run.
  bool is_gone(int environment) const override {
    if (here[array_size(environment)]) return false;
    const auto& all = exchanged()->environments;
    const auto own = static_cast<std::size_t>(std::ranges::find(here, true) - here.begin());
    return !file.is_locked(byte_of(environment)) ||
           all[array_size(environment)].finished.load(std::memory_order_acquire) >=
               all[own].arrived.load(std::memory_order_relaxed);
  }
  void check() const override {
    if (const int e = run_twice.load(std::memory_order_relaxed); e >= 0)
      file.refuse(": another process runs environment " + named(array_size(e)) +
                  " too, in a memory made after this one");
  }
  exchange<D>* exchanged() const { return std::launder(reinterpret_cast<exchange<D>*>(bytes() + offset())); }

private:
  struct head {
    char magic[8];
    std::uint64_t manifest_size;
  };
  static constexpr char magic[8] = {'c', 'c', 'a', ' ', 's', 'h', 'm', '2'};
  static constexpr long setup_byte = 0;
  static constexpr long byte_of(std::integral auto environment) { return 1 + static_cast<long>(environment); }
  static constexpr std::int64_t longest_setup = 5'000'000'000;  // ns; it takes milliseconds

  std::size_t offset() const { return (sizeof(head) + manifest.size() + 4095) / 4096 * 4096; }
  std::size_t size() const { return offset() + sizeof(exchange<D>); }
  char* bytes() const { return static_cast<char*>(at); }

  // The name of a claim: of this user, this memory, this environment.
  std::string claim_of(std::size_t e) const {
    return "cca/" + std::to_string(::geteuid()) + '/' + std::to_string(hash(file.name())) + '/' +
           std::to_string(e);
  }
  static std::string named(std::size_t e) { return '`' + std::string(environments_of<D>::all[e].name) + '`'; }

  void claim() {
    for (std::size_t e = 0; e < here.size(); ++e) {
      if (!here[e]) continue;
      if (!is_claimed(claims[e], e)) refuse_taken(e, machine_claim::holder(claim_of(e)));
      if (!file.lock(byte_of(e))) refuse_taken(e, 0);
    }
  }
  // A process that just ends may have lost its lock already, and its claim not yet.
  bool is_claimed(machine_claim& as, std::size_t e) const {
    for (int tries = 0; tries < 500; ++tries) {
      if (as.take(claim_of(e))) return true;
      if (file.is_locked(byte_of(e))) return false;
      monotonic_clock::sleep_until(monotonic_clock::now() + 1'000'000);
    }
    return false;
  }
  [[noreturn]] void refuse_taken(std::size_t e, int holder) const {
    const bool is_in_file = file.is_locked(byte_of(e));
    file.refuse(": another process runs environment " + named(e) + " already" +
                (is_in_file ? "" : ", in a memory of this name that was removed meanwhile: end it") +
                (holder != 0 ? ": process " + described_process(holder) : file.holder_of(byte_of(e))));
  }
  // Others that still run would never meet this process.
  void refuse_lost_memory() const {
    for (std::size_t e = 0; e < here.size(); ++e) {
      machine_claim probe;
      if (!here[e] && !is_claimed(probe, e)) refuse_taken(e, machine_claim::holder(claim_of(e)));
    }
  }

  // Now and then, in a thread of its own.
  void look() {
    if (file.is_named()) return;
    if (!std::exchange(is_told, true))
      tell(
          " was removed while it is used (by rm, or by systemd at logout: RemoveIPC=no keeps it). The run "
          "goes on, but no process can join it any more");
    int twice = -1;
    for (std::size_t e = 0; e < here.size(); ++e)
      if (here[e] && file.is_locked_in_successor(byte_of(e))) {
        twice = static_cast<int>(e);
        exchanged()->environments[e].stop_at.store(0, std::memory_order_release);
      }
    if (run_twice.exchange(twice) < 0 && twice >= 0)
      tell(": another process runs environment " + named(array_size(twice)) +
           " too, in a memory made after this one: this run ends");
  }
  void tell(const std::string& what) const {
    write_if_possible(STDERR_FILENO, "cca::shared_memory: `" + file.name() + '`' + what + '\n');
  }

  // The locks of this process are not seen by itself.
  bool is_anybody_else_here() const {
    for (int e = 0; e < most_environments; ++e)
      if (file.is_locked(byte_of(e))) return true;
    return false;
  }
  // With the processes that are there.
  void compare() {
    const std::size_t there = file.size();
    if (there < sizeof(head)) file.refuse(" is no memory of cca");
    at = file.map(there);
    head begins{};
    std::memcpy(&begins, at, sizeof begins);
    const bool is_ours =
        std::memcmp(begins.magic, magic, sizeof magic) == 0 && begins.manifest_size <= there - sizeof(head);
    const std::string theirs(bytes() + sizeof(head), is_ours ? begins.manifest_size : 0);
    ::munmap(at, there);
    at = nullptr;
    if (!is_ours) file.refuse(" is no memory of this version of cca");
    if (theirs != manifest)
      file.refuse(": the other process runs another deployment; " + first_difference(manifest, theirs));
    if (there != size()) file.refuse(" has another size");
  }
  void fill() {
    head begins{};
    std::memcpy(begins.magic, magic, sizeof magic);
    begins.manifest_size = manifest.size();
    std::memcpy(bytes() + sizeof(head), manifest.data(), manifest.size());
    ::new (static_cast<void*>(bytes() + offset())) exchange<D>;
    std::memcpy(at, &begins, sizeof begins);
  }
  // An environment that comes again is not part of the run that others have begun.
  void join() {
    auto& all = exchanged()->environments;
    std::int64_t newest = 0;
    for (const auto& e : all) newest = std::max<std::int64_t>(newest, e.ready);
    for (std::size_t e = 0; e < here.size(); ++e)
      if (here[e]) {
        all[e].arrived = all[e].ready = all[e].finished = newest;
        all[e].stopped = 0;
      }
  }

  static constexpr int most_environments = 64;

  shared_file file;
  environments_here<D> here;
  std::string manifest;
  std::array<machine_claim, array_size(environment_count<D>)> claims{};
  void* at = nullptr;
  bool is_told = false;
  std::atomic<int> run_twice{-1};
  std::optional<regular_look> watch{};
};

}  // namespace detail

class shared_memory {
public:
  // As of shm_open: a slash and letters.
  explicit shared_memory(std::string as) : name(std::move(as)) {}

  template <class D>
  auto open(const detail::environments_here<D>& here) const {
    return std::make_shared<detail::shared_exchange<D>>(name, here);
  }

private:
  std::string name;
};

}  // namespace cca
