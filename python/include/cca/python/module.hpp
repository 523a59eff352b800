// A task as a class of a Python module, with Gymnasium's vector interface by its names: docs/python.md.
//
//   #include <cca/python/module.hpp>
//
//   PYBIND11_MODULE(oncilla_walk, m) {
//     cca::python::add_environment<walk>(m, "walk");
//   }
//
// CMake: cca_python_module(oncilla_walk oncilla_walk.cpp). Then
//
//   env = oncilla_walk.walk(num_envs=64)
//   observations, infos = env.reset(seed=1)
//   observations, rewards, terminations, truncations, infos = env.step(actions)
//
// Arrays of results are views of the worlds' own memory, in two sets in turn. The other threads of Python run
// while worlds are stepped. Errors: TypeError, ValueError, RuntimeError, before anything has moved.
#pragma once

#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cca/python/array_checks.hpp>
#include <cca/python/box.hpp>
#include <cca/python/policy_file.hpp>
#include <cca/python/policy_in_numpy.hpp>
#include <cca/python/reset_options.hpp>
#include <cca/python/worlds.hpp>

namespace cca::python {

namespace detail {

inline autoreset autoreset_named(const std::string& name) {
  if (name == "same_step") return autoreset::same_step;
  if (name == "next_step") return autoreset::next_step;
  if (name == "disabled") return autoreset::disabled;
  throw py::value_error("autoreset is '" + name + "': there are same_step, next_step and disabled");
}
// The value of gymnasium.vector.AutoresetMode.
inline const char* gymnasium_name(autoreset a) {
  return a == autoreset::same_step ? "SameStep" : a == autoreset::next_step ? "NextStep" : "Disabled";
}

inline world_options checked_options(py::ssize_t count,
                                     py::ssize_t threads,
                                     const std::string& when_over,
                                     const std::optional<std::int64_t>& steps) {
  if (count < 1) throw py::value_error("num_envs is " + std::to_string(count) + ": it is at least 1");
  if (threads < 0 || threads > 4096)
    throw py::value_error("threads is " + std::to_string(threads) + ": it is 0 (all cores) to 4096");
  if (steps && *steps < 0)
    throw py::value_error("episode_steps is " + std::to_string(*steps) +
                          ": it is at least 1, or 0 for no end");
  return {static_cast<unsigned>(threads), steps.value_or(0), autoreset_named(when_over)};
}

// A call of C++ without Python's lock. Its exceptions become those of Python.
template <class F>
void without_lock(F f) {
  try {
    const py::gil_scoped_release released;
    f();
  } catch (const std::invalid_argument& e) { throw py::value_error(e.what()); } catch (const refused& e) {
    throw py::value_error(e.what());
  }
}

template <class Task>
class environment {
public:
  using all_worlds = worlds<Task>;

  environment(std::size_t count, world_options options, bool default_steps) {
    without_lock([&] {
      all_ = std::make_unique<all_worlds>(count, options);
      if (default_steps)
        all_->set_episode_steps(static_cast<std::int64_t>(Task::seconds / all_->step_seconds() + 0.5));
    });
  }

  all_worlds& all() {
    if (!all_) throw std::runtime_error("this environment is closed");
    return *all_;
  }
  void close() {
    const auto lock = locked();
    all_.reset();
  }
  bool is_closed() const { return !all_; }

  py::tuple reset(const py::object& self, const py::object& seed, const py::object& options) {
    const auto lock = locked();
    all_worlds& w = all();
    const auto seeds = seeds_of(seed, w.count());
    auto [which, parameters] = reset_options(options, w.count());
    without_lock([&] { w.reset(seeds, which, std::move(parameters)); });
    return py::make_tuple(numbers(self, w.now().observations, all_worlds::observed), infos(self, false));
  }

  py::tuple step(const py::object& self, const py::object& given) {
    const auto lock = locked();
    all_worlds& w = all();
    if (!w.has_begun()) throw std::runtime_error("step() before reset(): reset all worlds first");
    const auto actions =
        doubles(given, {static_cast<py::ssize_t>(w.count()), static_cast<py::ssize_t>(all_worlds::commanded)},
                "actions");
    const std::span<const double> values(actions.data(), static_cast<std::size_t>(actions.size()));
    without_lock([&] { w.step(values); });
    const world_results& r = w.now();
    return py::make_tuple(numbers(self, r.observations, all_worlds::observed), numbers(self, r.rewards),
                          flags(self, r.terminations), flags(self, r.truncations), infos(self, true));
  }

private:
  // One call at a time: the others wait, without Python's lock.
  std::unique_lock<std::mutex> locked() {
    const py::gil_scoped_release released;
    return std::unique_lock(one_call_);
  }

  // Views: `self` lives as long as they do.
  template <class Number>
  static py::array_t<Number> numbers(const py::object& self,
                                     const std::vector<Number>& all,
                                     std::size_t row = 0) {
    const auto n = static_cast<py::ssize_t>(all.size());
    const auto wide = static_cast<py::ssize_t>(row);
    return row == 0 ? py::array_t<Number>(n, all.data(), self)
                    : py::array_t<Number>({n / wide, wide}, all.data(), self);
  }
  static py::array flags(const py::object& self, const std::vector<std::uint8_t>& all) {
    return py::array(py::dtype("bool"), {static_cast<py::ssize_t>(all.size())}, {}, all.data(), self);
  }

  py::dict infos(const py::object& self, bool after_step) {
    const world_results& r = all().now();
    py::dict d;
    d["seed"] = numbers(self, r.seeds);
    if (!after_step || std::ranges::none_of(r.ended, [](std::uint8_t e) { return e != 0; })) return d;
    const py::array ended = flags(self, r.ended);
    d["episode"] = py::dict(py::arg("r") = numbers(self, r.returns), py::arg("l") = numbers(self, r.lengths));
    d["_episode"] = ended;
    d["fault"] = r.faults;
    if (all().options().when_over != autoreset::same_step) return d;
    d["final_obs"] = numbers(self, r.final_observations, all_worlds::observed);
    d["_final_obs"] = ended;
    return d;
  }

  std::mutex one_call_;
  std::unique_ptr<all_worlds> all_;
};

}  // namespace detail

template <class Task>
void add_environment(pybind11::module_& m, const char* name, const char* about = "worlds of one task") {
  namespace py = pybind11;
  using environment = detail::environment<Task>;
  using stand_in = typename worlds<Task>::stand_in;
  detail::declare_box(m);
  py::class_<environment> of(m, name, about);
  of.def(py::init([](py::ssize_t num_envs, py::ssize_t threads, const std::string& when_over,
                     const std::optional<std::int64_t>& steps) {
           const auto options = detail::checked_options(num_envs, threads, when_over, steps);
           return std::make_unique<environment>(static_cast<std::size_t>(num_envs), options, !steps);
         }),
         py::arg("num_envs") = 1, py::kw_only(), py::arg("threads") = 0, py::arg("autoreset") = "same_step",
         py::arg("episode_steps") = py::none())
      .def(
          "reset",
          [](py::object self, const py::object& seed, const py::object& options) {
            return self.cast<environment&>().reset(self, seed, options);
          },
          py::kw_only(), py::arg("seed") = py::none(), py::arg("options") = py::none(),
          "observations, infos = reset(seed=None | number | one for each world, options=None | dict)")
      .def(
          "step",
          [](py::object self, const py::object& actions) {
            return self.cast<environment&>().step(self, actions);
          },
          py::arg("actions"), "observations, rewards, terminations, truncations, infos = step(actions)")
      .def("close", [](environment& e) { e.close(); })
      .def_property_readonly("closed", [](environment& e) { return e.is_closed(); })
      .def_property_readonly("num_envs", [](environment& e) { return e.all().count(); })
      .def_property_readonly("single_observation_space",
                             [](environment&) { return box{observations_of<stand_in>()}; })
      .def_property_readonly("single_action_space", [](environment&) { return box{actions_of<stand_in>()}; })
      .def_property_readonly("observation_space",
                             [](environment& e) { return box{observations_of<stand_in>(), e.all().count()}; })
      .def_property_readonly("action_space",
                             [](environment& e) { return box{actions_of<stand_in>(), e.all().count()}; })
      .def_property_readonly(
          "metadata",
          [](environment& e) {
            return py::dict(py::arg("autoreset_mode") = detail::gymnasium_name(e.all().options().when_over));
          })
      .def_property_readonly("episode_steps", [](environment& e) { return e.all().options().episode_steps; })
      .def_property_readonly("step_seconds", [](environment& e) { return e.all().step_seconds(); })
      .def_property_readonly("beats_per_step", [](environment& e) { return e.all().times().period; })
      .def_property_readonly("parameter_paths", [](environment& e) { return e.all().parameter_paths(); })
      .def_property_readonly("spec", [](environment&) { return py::none(); })
      .def_property_readonly("render_mode", [](environment&) { return py::none(); })
      .def("__enter__", [](py::object self) { return self; })
      .def("__exit__", [](environment& e, const py::args&) { e.close(); });
  if constexpr (requires { typename stand_in::policy_type; })
    detail::add_policy_file<typename stand_in::policy_type>(of);
}

}  // namespace cca::python
