// One task of a worker outside of the loop: what it takes, what it gives, and the call between.
#pragma once

#include <cstdint>
#include <tuple>
#include <type_traits>

#include <cca/component/beat.hpp>
#include <cca/skeleton/through.hpp>

namespace cca::detail {

template <class Component>
constexpr bool function_may_fault = ports_of_component<Component, phase_of_beat::process>::value.may_fault;

template <class Port>
constexpr bool goes_through = !std::is_void_v<typename passage_of<Port>::type>;

template <class Worker>
struct piece_work {
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

  static result done(Worker& by, const task& t) { return called(by, t, typename facts::parameters()); }

private:
  template <class... Parameters>
  static result called(Worker& by, const task& t, list<Parameters...>) {
    return made(t, by.process([&]() -> Parameters {
      if constexpr (goes_through<Parameters>) return Parameters(t.value, t.origin, true);
      else if constexpr (std::is_same_v<Parameters, beat>) return t.when;
      else return Parameters{};  // not wired
    }()...));
  }

  template <class Port>
  static result made(const task& t, const Port& port) {
    bool published = true;
    if constexpr (requires { static_cast<bool>(port); }) published = static_cast<bool>(port);
    return {port.vector(), port.origin() == never ? t.origin : port.origin(), published};
  }
  template <class... Ports>
  static result made(const task& t, const std::tuple<Ports...>& ports) {
    result one;
    ((goes_through<Ports> ? void(one = made_if<goes_through<Ports>>(t, std::get<Ports>(ports))) : void()),
     ...);
    return one;
  }
  template <bool Is, class Port>
  static result made_if(const task& t, const Port& port) {
    if constexpr (Is) return made(t, port);
    else return {};
  }
};

}  // namespace cca::detail
