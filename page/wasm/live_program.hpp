// A controller that a page runs, as its functions for the page see it (exports.cpp).
#pragma once

#include <cstdint>
#include <string>

namespace cca::page {

class live_program {
public:
  virtual ~live_program() = default;

  virtual std::string description() = 0;  // JSON: architecture, parameters, the robot's shapes
  virtual std::string parameters() = 0;   // JSON: their values now

  // At most so many beats; how many were done.
  virtual int advance(int beats) = 0;
  virtual void begin_anew() = 0;  // in the state `created`, with the same parameters
  virtual void change(int transition) = 0;
  virtual std::string set(int field, double value) = 0;  // why it is refused; empty: it is set
  virtual void push(double x, double y, double z, double seconds) = 0;
  virtual void press(int button, bool down) = 0;  // of the buttons in the description

  // Snapshots: copies of the controller. The beat of a snapshot is its name.
  virtual void take_snapshot() = 0;
  virtual bool go_back(std::int64_t beat) = 0;

  virtual std::string status() = 0;  // JSON: beat, state, fault, snapshots, which buttons are pressed

  virtual double* rows() = 0;
  virtual int row_width() = 0;
  virtual double* origins() = 0;
  virtual double* published() = 0;
  virtual double* poses() = 0;
};

// What exports.cpp runs: each page's program defines it.
live_program& program();

}  // namespace cca::page
