// One task of a worker on a thread: its input, its result, and the call that turns one into the other.
#pragma once

#include <cstdint>
#include <tuple>
#include <type_traits>

#include <cca/component/beat.hpp>
#include <cca/component/hooks.hpp>
#include <cca/skeleton/stage_ports.hpp>

namespace cca::detail {

template <class Component>
constexpr bool function_may_fault = ports_of_component<Component, phase_of_beat::process>::value.may_fault;

template <class Port>
constexpr bool is_stage_port = !std::is_void_v<typename stage_port_of<Port>::type>;

template <class Worker>
struct worker_task {
  using worker = Worker;
  using taken = typename input_of_stage<Worker>::space;
  using given = typename output_of_stage<Worker>::space;
  using facts = function_facts<decltype(&Worker::process)>;

  struct task {
    typename taken::vector_type value;
    std::int64_t origin = 0;
    beat when{0, 1, 1};
  };
  struct result {
    typename given::vector_type value;
    std::int64_t origin = 0;
    bool published = false;
  };

  static void stopped([[maybe_unused]] Worker& by) {
    if constexpr (OnStop<Worker>) by.on_stop();
  }
  static result done(Worker& by, const task& t) { return call(by, t, typename facts::parameters()); }

private:
  template <class... Parameters>
  static result call(Worker& by, const task& t, list<Parameters...>) {
    return result_from(t, by.process([&]() -> Parameters {
      if constexpr (is_stage_port<Parameters>) return Parameters(t.value, t.origin, true);
      else if constexpr (std::is_same_v<Parameters, beat>) return t.when;
      else return Parameters{};  // an optional input, not wired
    }()...));
  }

  template <class Port>
  static result result_from(const task& t, const Port& port) {
    bool published = true;
    if constexpr (requires { static_cast<bool>(port); }) published = static_cast<bool>(port);
    return {port.vector(), port.origin() == never ? t.origin : port.origin(), published};
  }
  template <class... Ports>
  static result result_from(const task& t, const std::tuple<Ports...>& ports) {
    result one;
    ((is_stage_port<Ports> ? void(one = result_if<is_stage_port<Ports>>(t, std::get<Ports>(ports))) : void()),
     ...);
    return one;
  }
  template <bool Is, class Port>
  static result result_if(const task& t, const Port& port) {
    if constexpr (Is) return result_from(t, port);
    else return {};
  }
};

}  // namespace cca::detail
