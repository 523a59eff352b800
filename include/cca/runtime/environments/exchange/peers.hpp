// What a transport knows of the environments that other processes run.
#pragma once

#include <cstdint>

#include <cca/runtime/environments/exchange/bell.hpp>

namespace cca::detail {

class peers {
public:
  virtual ~peers() = default;
  // Its process has ended, or is not part of this run.
  virtual bool is_gone(int environment) const = 0;
  // The newest run that others began before they knew of this process: it takes part in later ones only.
  virtual std::int64_t newest_run_before() const { return 0; }
  // Throws `refused` where this process must not run what it runs.
  virtual void check() const {}

  // Between the environments and the threads of a transport that has its own: something here is to be sent,
  // and something has come.
  struct bells {
    bell leaving, arriving;
  };
  virtual bells* rings() const { return nullptr; }

  // In a fast run an environment has the time to do the work of these threads: then what it sends and
  // receives needs no way over them.
  virtual bool works_in_environment() const { return false; }
  // At the end of a beat.
  virtual void send() const noexcept {}
  // While it waits: until something comes, but not for long (ns). False: another thread is at it, and will
  // ring.
  virtual bool receive(std::int64_t /*longest*/) const noexcept { return false; }
};

}  // namespace cca::detail
