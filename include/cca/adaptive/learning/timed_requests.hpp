// Requests to a learner at fixed beats: a lesson without a teacher's voice.
//
//   cca::node<"lesson", cca::timed_requests<cca::request_at<500, cca::learning_call::collect>,
//                                           cca::request_at<1500, cca::learning_call::batch>>>
//
//   out "learn"   learning_requests<...>   a `maybe`: in these beats
//
// The compiler knows the requests, so it refuses what the learner can't do (learner.request). Cost: a
// comparison for each. Example: tests/runtime/adaptive/requests.cpp.
#pragma once

#include <cstdint>

#include <cca/adaptive/module_status.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/port.hpp>

namespace cca {

template <std::int64_t Beat, learning_call Call>
struct request_at {};

template <class... Requests>
struct timed_requests;
template <std::int64_t... Beats, learning_call... Calls>
struct timed_requests<request_at<Beats, Calls>...> {
  auto process(beat now) -> maybe<"learn", learning_requests<Calls...>> {
    maybe<"learn", learning_requests<Calls...>> call;
    ((now.index() == Beats ? void(call = status_of(Calls)) : void()), ...);
    return call;
  }
};

}  // namespace cca
