// Module Status: what the learner of a module is doing, whether the input of the module lies in its trained
// region, and what became of the last request (the source document, section 4.4.4).
//
//   out<"module", module_status_port>     over learning_axis (a cca::learning), region_axis (a
//                                         cca::trained_region) and answer_axis (a cca::learning_answer)
//   status.as<cca::learning>(cca::learning_axis{}) == cca::learning::trained
//
// A request of another component to a module is a cca::learning_call, at its port "learn". The last axis
// answers it from the firing on that received it. Without a request the answer is `none`.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include <cca/space/methods/scalar.hpp>
#include <cca/space/space.hpp>

namespace cca {

enum class learning : std::uint8_t { idle, collecting, online, batch, trained };
enum class trained_region : std::uint8_t { outside, inside };

constexpr std::string_view to_string(learning state) {
  constexpr std::array<std::string_view, 5> names{"idle", "collecting", "learning online", "learning batch",
                                                  "trained"};
  return names[static_cast<std::size_t>(state)];
}
constexpr std::string_view to_string(trained_region state) {
  return state == trained_region::inside ? "inside" : "outside";
}

// A request. `batch` starts one, beside the loop; `rest` ends collecting and learning, and gives up a batch.
enum class learning_call : std::uint8_t { nothing, collect, learn, rest, forget, batch };

// What became of the last request. Only after `accepted` has it changed anything, or was there nothing to do.
enum class learning_answer : std::uint8_t {
  none,         // nothing was requested
  accepted,     // done, or already so
  impossible,   // this learner can't do it: `learn` needs an OnlineLearner, `collect` and `batch` a
                // BatchLearner; nor `batch` where nobody computes it (cca::training::compute_batches)
  not_now,      // in this state it is refused: rest first; `batch` also while an old one is still computed
  no_examples,  // for a batch
  unknown,      // the number is no learning_call
  failed        // the batch ended without a result: out of memory
};

constexpr std::string_view to_string(learning_call call) {
  constexpr std::array<std::string_view, 6> names{"nothing", "collect", "learn", "rest", "forget", "batch"};
  return names[static_cast<std::size_t>(call)];
}
constexpr std::string_view to_string(learning_answer answer) {
  constexpr std::array<std::string_view, 7> names{"none",        "accepted", "impossible", "not now",
                                                  "no examples", "unknown",  "failed"};
  return names[static_cast<std::size_t>(answer)];
}

struct learning_axis : dimension<"learning"> {};
struct region_axis : dimension<"region"> {};
struct answer_axis : dimension<"answer"> {};
struct module_status_port : space<status, axes<learning_axis, region_axis, answer_axis>> {};

// The value of the status port.
inline module_status_port::vector_type status_of(learning state,
                                                 trained_region region,
                                                 learning_answer answer = learning_answer::none) {
  return {status_of(state), status_of(region), status_of(answer)};
}

// The space of a request: `optional_in<"learn", learning_request>`.
struct call_axis : dimension<"call"> {};
struct learning_request : space<status, axes<call_axis>> {};

// The same, of a component that says which requests it may publish: `maybe<"learn",
// learning_requests<learning_call::collect, learning_call::batch>>`. What the learner at the other end of the
// wire can't do is then refused by the compiler (learner.request).
template <learning_call... Calls>
struct learning_requests : learning_request {
  static constexpr std::array<double, sizeof...(Calls)> only{status_of(Calls)...};
};

}  // namespace cca
