#pragma once
// What a program does between two beats: it may return false to end the run. It may leave out its arguments.
#include <type_traits>

namespace trot {

template <class Between, class... Arguments>
bool goes_on(Between& between, const Arguments&... arguments) {
  if constexpr (sizeof...(Arguments) > 0 && std::is_invocable_v<Between&>) return goes_on(between);
  else if constexpr (std::is_void_v<std::invoke_result_t<Between&, const Arguments&...>>)
    return between(arguments...), true;
  else return between(arguments...);
}

}  // namespace trot
