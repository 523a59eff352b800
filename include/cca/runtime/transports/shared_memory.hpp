// Environments in several processes of one machine: what they exchange lies in POSIX shared memory, which
// only this user may open. Nothing in it locks, so a process may die at any instruction.
//
//   cca::deployed<split> d(cca::only{"robot"}, cca::shared_memory("/trot"));
//
// The processes must have been compiled from the same deployment; the memory begins with what they must agree
// on. A process holds a lock of the file for each environment that it runs. The system takes it away when the
// process ends, however it does: so nobody runs an environment twice, and others see that it is gone. The
// last process removes the memory; what a killed one leaves, the next one begins anew.
#pragma once

#include <algorithm>
#include <cstring>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include <cca/base/refused.hpp>
#include <cca/runtime/environments/exchange.hpp>
#include <cca/runtime/transports/manifest.hpp>
#include <cca/runtime/environments/peers.hpp>
#include <cca/runtime/transports/shared_file.hpp>

namespace cca {
namespace detail {

// The memory: a head, the manifest, what is exchanged.
template <class D>
class shared_exchange : public peers {
public:
  shared_exchange(const std::string& name, const environments_here<D>& is_here)
      : file(name), here(is_here), manifest(manifest_of<D>()) {
    file.lock(setup_byte, true);
    try {
      claim();
      const bool is_first = !is_anybody_else_here();
      if (is_first) file.resize(size());
      else compare();
      at = file.map(size());
      if (is_first) fill();
      join();
    } catch (...) {
      file.unlock(setup_byte);
      throw;
    }
    file.unlock(setup_byte);
  }
  ~shared_exchange() override {
    file.lock(setup_byte, true);
    if (!is_anybody_else_here()) file.remove();
    ::munmap(at, size());
  }

  // Its process has ended, or came again and is not part of this run.
  bool is_gone(int environment) const override {
    if (here[array_size(environment)]) return false;
    const auto& all = exchanged()->environments;
    const auto own = static_cast<std::size_t>(std::ranges::find(here, true) - here.begin());
    return !file.is_locked(byte_of(environment), 1) ||
           all[array_size(environment)].finished.load(std::memory_order_acquire) >=
               all[own].arrived.load(std::memory_order_relaxed);
  }
  exchange<D>* exchanged() const { return std::launder(reinterpret_cast<exchange<D>*>(bytes() + offset())); }

private:
  struct head {
    char magic[8];
    std::uint64_t manifest_size;
  };
  static constexpr char magic[8] = {'c', 'c', 'a', ' ', 's', 'h', 'm', '1'};
  static constexpr long setup_byte = 0;
  static constexpr long byte_of(int environment) { return 1 + environment; }

  std::size_t offset() const { return (sizeof(head) + manifest.size() + 4095) / 4096 * 4096; }
  std::size_t size() const { return offset() + sizeof(exchange<D>); }
  char* bytes() const { return static_cast<char*>(at); }

  void claim() const {
    for (int e = 0; e < environment_count<D>; ++e)
      if (here[array_size(e)] && !file.lock(byte_of(e), false))
        throw refused("cca::shared_memory: `" + file.name() + "`: another process runs environment `" +
                      std::string(environments_of<D>::all[array_size(e)].name) + "` already");
  }
  bool is_anybody_else_here() const {
    for (int e = 0; e < most_environments; ++e)
      if ((e >= environment_count<D> || !here[array_size(e)]) && file.is_locked(byte_of(e), 1)) return true;
    return false;
  }
  // With the processes that are there.
  void compare() {
    const std::size_t there = file.size();
    if (there < sizeof(head)) throw refused("cca::shared_memory: `" + file.name() + "` is no memory of cca");
    at = file.map(there);
    head begins{};
    std::memcpy(&begins, at, sizeof begins);
    const bool is_ours =
        std::memcmp(begins.magic, magic, sizeof magic) == 0 && begins.manifest_size <= there - sizeof(head);
    const std::string theirs(bytes() + sizeof(head), is_ours ? begins.manifest_size : 0);
    ::munmap(at, there);
    at = nullptr;
    if (!is_ours)
      throw refused("cca::shared_memory: `" + file.name() + "` is no memory of this version of cca");
    if (theirs != manifest)
      throw refused("cca::shared_memory: `" + file.name() + "`: the other process runs another deployment; " +
                    first_difference(manifest, theirs));
    if (there != size()) throw refused("cca::shared_memory: `" + file.name() + "` has another size");
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
        all[e].is_stopped = false;
      }
  }

  static constexpr int most_environments = 64;

  shared_file file;
  environments_here<D> here;
  std::string manifest;
  void* at = nullptr;
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
