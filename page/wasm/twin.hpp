// A live twin as WebAssembly: it is fed with what a robot sensed, and says whether it computes the same
// (cca/record/twin.hpp). The program of a twin is a recordable graph and one line:
//
//   struct my_robot : robot_graph, cca::recordable {};
//   cca::page::twin_program& cca::page::twin() { static cca::page::twin_of<my_robot> one; return one; }
//
// Compile it with twin_exports.cpp and exceptions.cpp: add_twin_program in CMakeLists.txt. docs/door.md
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <cca/record/twin.hpp>

#include "json_text.hpp"

namespace cca::page {

class twin_program {
public:
  virtual ~twin_program() = default;
  virtual void begin() = 0;  // as before the first beat
  // Room for the next bytes of the stream, and that they are there.
  virtual unsigned char* room(std::size_t size) = 0;
  virtual void take() = 0;
  virtual std::string result() = 0;  // JSON
};

// `Prepare`: called with the controller before the first beat; for what a program gives to its components
// beside parameters.
struct nothing_more {
  template <class Controller>
  void operator()(Controller&) const {}
};
template <class Graph, class Prepare = nothing_more>
class twin_of final : public twin_program {
public:
  twin_of() { begin(); }

  void begin() override {
    now = std::make_unique<recording::twin<Graph>>();
    Prepare()(now->controller());
  }
  unsigned char* room(std::size_t size) override {
    bytes.resize(size);
    return bytes.data();
  }
  void take() override { now->take(bytes); }
  std::string result() override {
    const recording::replay_result& r = now->result();
    json_text json;
    json.open('{').key("beats").add(r.beats).key("samples").add(r.samples);
    json.key("difference").add(r.difference).key("component").add(r.component).key("port").add(r.port);
    json.key("beat").add(r.beat).key("endedEarly").add(r.ended_early).key("fault").add(r.fault);
    return json.close('}').text;
  }

private:
  std::unique_ptr<recording::twin<Graph>> now;
  std::vector<unsigned char> bytes;
};

// What twin_exports.cpp runs: each twin's program defines it.
twin_program& twin();

}  // namespace cca::page
