// The controller of a graph that breaks a rule: one error, which is the message.
#pragma once

#include <string_view>

#include <cca/component/fault.hpp>
#include <cca/component/lifecycle.hpp>
#include <cca/graph/diagnosis.hpp>
#include <cca/graph/find.hpp>

namespace cca {

// The calls are there so that nothing else is reported.
template <class Graph>
class controller {
  static_assert(sizeof(detail::refusal<Graph>) != 0);

public:
  void load(std::string_view = {}) {}
  void save(std::string_view = {}) {}
  void start() {}
  void stop() {}
  void resume() {}
  bool step() noexcept { return false; }
  template <class... Options>
  cca::state run(Options...) { return {}; }
  cca::state state() const noexcept { return {}; }
  cca::fault fault() const noexcept { return {}; }
  std::int64_t beat_index() const noexcept { return 0; }
  template <fixed_string Path>
  auto get() const -> typename detail::leaf_of<Graph, detail::leaf_at<Graph>(Path.view())>::component&;
  template <fixed_string Path, class Parameters>
  void set(const Parameters&) {}
  template <class F>
  void for_each_component(F) {}
};

}  // namespace cca
