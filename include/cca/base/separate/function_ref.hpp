// A function of somebody else, called through a pointer: for what a beat calls at most once. As a template
// argument each lambda of each caller would have compiled the code around the call again: a run of four
// environments had 16 loops for each pace.
//
// What it refers to must live as long. One that refers to nothing is false, and must not be called.
// at_the_end: the same at the end of a block.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace cca::detail {

template <class Signature>
class function_ref;

template <class Result, class... Arguments>
class function_ref<Result(Arguments...)> {
public:
  function_ref() = default;
  template <class F>
    requires(!std::is_same_v<std::remove_cvref_t<F>, function_ref> &&
             std::is_invocable_r_v<Result, F&, Arguments...>)
  function_ref(F&& f) noexcept  // like a reference, without a word
      : object(const_cast<void*>(static_cast<const void*>(std::addressof(f)))),
        call([](void* of, Arguments... arguments) -> Result {
          return (*static_cast<std::remove_reference_t<F>*>(of))(std::forward<Arguments>(arguments)...);
        }) {}

  explicit operator bool() const noexcept { return call != nullptr; }
  Result operator()(Arguments... arguments) const {
    return call(object, std::forward<Arguments>(arguments)...);
  }

private:
  void* object = nullptr;
  Result (*call)(void*, Arguments...) = nullptr;
};

// Calls a function of the block that ends, also where it ends by an exception.
template <class F>
struct at_the_end {
  F last;
  ~at_the_end() { last(); }
};

}  // namespace cca::detail
