// The laws of an adaptive module, stated once and run for every one that the template makes.
//
// A case has
//   module, other_size, other_space   the module, and two that may not read its file
//   lesson                            the number of firings of a demonstration
//   fire(m, k, shown, call)           one firing, number k of a movement, with what the module shows then: a
//                                     case::firing; `shown`: nothing, the demonstration, or one that is NaN
//   change(p)                         changes a parameter that the learned numbers depend on
//   worst(m)                          the largest error of a trained module over a movement from a start
//   bound                             what `worst` may be
//
// `laws::allocations()` counts calls of malloc; the test program defines it.
#pragma once

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include <cca/adaptive/module/adaptive_module.hpp>

#include "ode_laws.hpp"
#include "temporary_file.hpp"

namespace laws {

enum class shown { nothing, demonstration, broken };

struct module_firing {
  double command;  // one coordinate; NaN if nothing was published
  double ode;
  cca::learning learning;
  cca::trained_region region;
  cca::learning_answer answer;
};

template <class Status>
module_firing firing_of(double command, double ode, const Status& module) {
  return {command, ode, static_cast<cca::learning>(module.vector()[0]),
          static_cast<cca::trained_region>(module.vector()[1]),
          static_cast<cca::learning_answer>(module.vector()[2])};
}

// A request as the loop gives it.
inline cca::optional_in<"learn", cca::learning_request> request(cca::learning_call call) {
  cca::optional_in<"learn", cca::learning_request> port(
      cca::learning_request::vector_type(cca::status_of(call)), 0, call != cca::learning_call::nothing);
  port.set_wired();
  return port;
}

template <class Module>
std::unique_ptr<Module> started_module() {
  auto m = std::make_unique<Module>();
  m->on_load();
  m->on_start();
  return m;
}

// Through the port "learn"; then the batch, between two firings.
template <class Case>
void teach(typename Case::module& m, shown what = shown::demonstration) {
  m.on_start();
  for (int k = 0; k < Case::lesson; ++k) {
    const auto now =
        Case::fire(m, k, what, k == 0 ? cca::learning_call::collect : cca::learning_call::nothing);
    CHECK(now.learning == cca::learning::collecting);
    CHECK(now.region == cca::trained_region::outside);
  }
}

template <class Case>
std::unique_ptr<typename Case::module> taught() {
  auto m = started_module<typename Case::module>();
  teach<Case>(*m);
  m->learning.hand_over(m->learning.begin_batch(m->p.settings)());
  return m;
}

template <class Case>
void tells_what_it_learns() {
  const auto m = started_module<typename Case::module>();
  using enum cca::learning_call;
  auto now = Case::fire(*m, 0, shown::demonstration, nothing);
  CHECK(now.learning == cca::learning::idle);
  CHECK(now.region == cca::trained_region::outside);
  CHECK_MESSAGE(m->learning.example_count() == 0, "it learns only on request");
  const std::size_t before = allocations();
  teach<Case>(*m);
  CHECK_MESSAGE(allocations() == before, "a firing does not allocate");
  CHECK(m->learning.example_count() > Case::lesson / 2);
  const auto work = m->learning.begin_batch(m->p.settings);
  now = Case::fire(*m, 0, shown::demonstration, nothing);
  CHECK(now.learning == cca::learning::batch);
  m->learning.hand_over(work());
  m->on_start();
  int inside = 0;
  for (int k = 0; k < Case::lesson; ++k) {
    now = Case::fire(*m, k, shown::nothing, nothing);
    CHECK(now.learning == cca::learning::trained);
    inside += now.region == cca::trained_region::inside;
  }
  CHECK_MESSAGE(inside > 0.8 * Case::lesson, "inside the trained region in " << inside << " firings");
  now = Case::fire(*m, 0, shown::nothing, forget);
  CHECK(now.learning == cca::learning::idle);
  CHECK(now.region == cca::trained_region::outside);
}

template <class Case>
void reproduces() {
  const auto untaught = started_module<typename Case::module>();
  const auto m = taught<Case>();
  const double first = Case::worst(*untaught), left = Case::worst(*m);
  CHECK_MESSAGE(left < Case::bound, "error " << left << ", untaught " << first);
  CHECK_MESSAGE(first > 4 * Case::bound, "the error without learning is only " << first);
  const auto again = taught<Case>();
  CHECK_MESSAGE(Case::worst(*again) == left, "the same demonstration gives the same movement, bit for bit");
}

// NaN, infinity and numbers that no robot shows are never learned, and do not move it.
template <class Case>
void refuses_broken_demonstrations() {
  const auto m = started_module<typename Case::module>();
  teach<Case>(*m, shown::broken);
  CHECK_MESSAGE(m->learning.example_count() == 0, "a demonstration that is NaN teaches nothing");
  m->learning.rest();
  const auto twin = taught<Case>();
  const auto one = taught<Case>();
  twin->on_start();
  one->on_start();
  for (int k = 0; k < Case::lesson; ++k) {
    const auto a = Case::fire(*twin, k, shown::nothing, cca::learning_call::nothing),
               b = Case::fire(*one, k, shown::broken, cca::learning_call::nothing);
    CHECK(a.command == b.command);
  }
}

// What it says when it reads a file; empty if it takes it.
template <class Module>
std::string answer_to(const std::string& path, Module& m) {
  (void)m.p.files.load.assign(path);
  try {
    m.on_load();
  } catch (const cca::refused& refusal) {
    CHECK_MESSAGE(m.learning.state() == cca::learning::idle, "a refused file changes nothing");
    return refusal.what();
  }
  return {};
}

template <class Case>
void keeps_its_file() {
  const temporary_file file("module");
  const auto m = taught<Case>();
  (void)m->p.files.save.assign(file.path);
  m->on_save();
  const auto again = std::make_unique<typename Case::module>();
  CHECK(answer_to(file.path, *again) == "");
  CHECK(again->learning.state() == cca::learning::trained);
  CHECK_MESSAGE(Case::worst(*again) == Case::worst(*m), "a file gives the same movement, bit for bit");
  const auto says = [&](const std::string& words, const char* line) {
    CHECK_MESSAGE(words.starts_with(file.path + line), words);
    for (const char* part : {"found `", "expected `", "learn again"})
      CHECK_MESSAGE(words.find(part) != words.npos, words);
  };
  const auto other = std::make_unique<typename Case::other_size>();
  says(answer_to(file.path, *other), ":2: the file belongs to another model");
  const auto elsewhere = std::make_unique<typename Case::other_space>();
  says(answer_to(file.path, *elsewhere), ":2: the file belongs to another model");
  const auto changed = std::make_unique<typename Case::module>();
  Case::change(changed->p);
  says(answer_to(file.path, *changed), ":");
}

template <class Case>
void adaptive_module() {
  law("states what it learns", tells_what_it_learns<Case>);
  law("reproduces what was shown", reproduces<Case>);
  law("learns nothing from what is no number", refuses_broken_demonstrations<Case>);
  law("keeps its file", keeps_its_file<Case>);
}

}  // namespace laws
