// What a transport tells of the environments that other processes run.
#pragma once

namespace cca::detail {

class peers {
public:
  virtual ~peers() = default;
  // Its process has ended, or is not part of this run.
  virtual bool is_gone(int environment) const = 0;
};

}  // namespace cca::detail
