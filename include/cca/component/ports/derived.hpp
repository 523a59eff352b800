// What follows from a sample, as a parameter of `process`: a pure function of what an input shows, computed
// once in a beat for all components that ask for the same function of the same sample.
//
//   struct length_of {
//     using value = double;
//     static value of(const auto& sample) { return sample.vector().norm(); }
//   };
//   auto process(cca::in<"force", force> felt, cca::derived<length_of, "force"> length) -> ... {
//     length.of(felt)
//
// A function may build on others: with `using from = cca::from<A, B>;` its `of` takes the values of A and B,
// which are shared, too. `of` must depend on nothing but the coordinates of the sample.
//
//   length.of(felt)       the value. `of` takes that input only, as it came: the value of one that you have changed,
//                         or made yourself, is `anew`'s. Outside of a beat, where `process` is called by hand with
//                         `{}` for this parameter, it is computed here
//   length.anew(other)    of another sample instead, for a component that does not take the input as it is
//
// Inputs of one output share it if their wires have neither a delay nor a queue: they show the same sample.
// Behind other wires each component has a value of its own, so sharing changes no result. A value lives for
// one beat; in a beat that is compiled in parts, for one part.
//
// NaN: `of` sees it as it is.
// Precondition: the value has a trivial destructor. Errors: component.bad_parameter. Cost: a test for each
// component that asks, where the compiler can't tell that another one has asked before.
// Example: tests/runtime/core/derived.cpp; docs/components.md.
#pragma once

#include <concepts>
#include <cstdlib>
#include <new>
#include <string_view>
#include <type_traits>

#include <cca/base/fixed_string.hpp>
#include <cca/base/inlining.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/space/sample.hpp>

namespace cca {

// The functions on whose values another one builds.
template <class... Functions>
struct from {};

namespace detail {

template <class Function> concept DerivesValue = requires { typename Function::value; };

template <class Function>
struct no_derived_value {
  static constexpr void tell(text& m) {
    m << "component.bad_parameter: `" << type_name<Function>()
      << "` stands in a cca::derived, but states no `value`: write `using value = ...;` and a static "
         "function "
         "`of` which makes one of a sample";
  }
};
template <class Function>
struct value_with_destructor {
  static constexpr void tell(text& m) {
    m << "component.bad_parameter: the value of `" << type_name<Function>()
      << "` has a destructor that does something: a cca::derived is a plain value, which no beat destroys";
  }
};

template <class Function>
struct value_elsewhere {
  static constexpr void tell(text& m) {
    m << "component.bad_parameter: the value of `" << type_name<Function>() << "` is `"
      << type_name<typename Function::value>()
      << "`: a cca::derived keeps a value of its own: state a type that owns its numbers, not a pointer, a "
         "reference, a view or an expression";
  }
};
// It refers to numbers that somebody else owns, or is nothing.
template <class Value>
constexpr bool is_elsewhere() {
  if constexpr (!std::is_object_v<Value> || std::is_pointer_v<Value>) return true;
  else if constexpr (requires { typename Value::PlainObject; })  // Eigen's
    return !std::is_same_v<Value, typename Value::PlainObject>;
  else return requires { typename Value::element_type; } || std::is_same_v<Value, std::string_view>;  // spans
}

template <class Function>
struct builds_on_no_list {
  static constexpr void tell(text& m) {
    m << "component.bad_parameter: the `from` of `" << type_name<Function>() << "` is `"
      << type_name<typename Function::from>() << "`: write `using from = cca::from<...>;` with the functions "
      << "on whose values it builds";
  }
};
template <class Type>
inline constexpr bool is_from = false;
template <class... Functions>
inline constexpr bool is_from<from<Functions...>> = true;
template <class Function> concept StatesFrom = requires { typename Function::from; };
template <class Function> concept BuildsOnOthers = StatesFrom<Function> && is_from<typename Function::from>;

template <class Function>
struct builds_on_itself {
  static constexpr void tell(text& m) {
    m << "component.bad_parameter: `" << type_name<Function>()
      << "` stands in a cca::derived, and builds on its own value: take it out of the `cca::from` of those "
         "on "
         "which it builds";
  }
};
template <class Function, class... Given>
struct makes_no_value {
  static constexpr void tell(text& m) {
    m << "component.bad_parameter: `" << type_name<Function>() << "` makes ";
    if constexpr (requires(const Given&... given) { Function::of(given...); })
      m << "`" << type_name<decltype(Function::of(std::declval<const Given&>()...))>() << "` and ";
    m << "no `" << type_name<typename Function::value>() << "` of";
    const char* before = " `";
    ((m << before << type_name<Given>() << "`", before = " and `"), ...);
    m << ": a cca::derived needs a function `static value of(...)` for that";
  }
};
// Numbers of a kind that can't hold all of them.
template <class Made, class Value>
inline constexpr bool loses_numbers =
    std::is_arithmetic_v<Made> && std::is_arithmetic_v<Value> &&
    ((std::is_floating_point_v<Made> && !std::is_floating_point_v<Value>) ||
     (std::is_floating_point_v<Made> == std::is_floating_point_v<Value> && sizeof(Value) < sizeof(Made)));
template <class Made, class Value> concept Becomes =
    std::convertible_to<Made, Value> && !loses_numbers<std::remove_cvref_t<Made>, Value>;
template <class Function, class... Given> concept MakesValueOf = requires(const Given&... given) {
  { Function::of(given...) } -> Becomes<typename Function::value>;
};

// An input of this name: cca/component/port.hpp.
template <class Shown, fixed_string Port> concept Shows =
    requires { Shown::name; } && Shown::name == Port.view();

template <class Function, fixed_string Port, class Other>
struct derived_of_other {
  static constexpr void tell(text& m) {
    m << "component.bad_parameter: `of` of a cca::derived of `" << type_name<Function>()
      << "` takes the input `" << Port.view() << "`, whose value it is, and got ";
    if constexpr (requires { Other::name; }) m << "`" << Other::name << "`";
    else m << "a `" << type_name<Other>() << "`";
    m << ": name the input alike in both, or for the value of another sample call `anew`";
  }
};

template <class Function, class... Before>
constexpr bool reaches_itself();
template <class... Functions, class... Before>
constexpr bool one_reaches_itself(from<Functions...>, from<Before...>) {
  return (reaches_itself<Functions, Before...>() || ...);
}
template <class Function, class... Before>
constexpr bool reaches_itself() {
  if constexpr ((std::is_same_v<Function, Before> || ...)) return true;
  else if constexpr (BuildsOnOthers<Function>)
    return one_reaches_itself(typename Function::from{}, from<Function, Before...>{});
  else return false;
}

// Of a function that is refused, so that the compiler has one thing to say.
struct no_function {
  using value = double;
  static value of(const auto&...) { return 0; }
};
template <class Function>
struct value_of {
  using type = no_function::value;
};
template <DerivesValue Function>
struct value_of<Function> {
  using type = typename Function::value;
};
template <class Function>
struct from_of {
  using type = from<>;
};
template <BuildsOnOthers Function>
struct from_of<Function> {
  using type = typename Function::from;
};

// `type`: the function, if it and those on whose values it builds are right.
template <class Function, class From = typename from_of<Function>::type>
struct judged_function;
template <class Function, class... Before>
struct judged_function<Function, from<Before...>> {
  static constexpr bool has_value = DerivesValue<Function>;
  static constexpr bool is_owned = [] {
    if constexpr (has_value) return !is_elsewhere<typename Function::value>();
    else return true;
  }();
  static constexpr bool is_plain = [] {
    if constexpr (has_value && is_owned) return std::is_trivially_destructible_v<typename Function::value>;
    else return true;
  }();
  static constexpr bool is_circular = reaches_itself<Function>();
  static constexpr bool has_list = !StatesFrom<Function> || BuildsOnOthers<Function>;
  static constexpr bool is_right = has_value && is_owned && is_plain && has_list && !is_circular;
  static constexpr bool makes_one = [] {
    if constexpr (is_right && sizeof...(Before) > 0)
      return MakesValueOf<Function, typename value_of<Before>::type...>;
    else return true;
  }();
  static_assert(holds_or_tells<has_value, no_derived_value<Function>>::value);
  static_assert(holds_or_tells<is_owned, value_elsewhere<Function>>::value);
  static_assert(holds_or_tells<has_list, builds_on_no_list<Function>>::value);
  static_assert(holds_or_tells<is_plain, value_with_destructor<Function>>::value);
  static_assert(holds_or_tells<!is_circular, builds_on_itself<Function>>::value);
  static_assert(
      holds_or_tells<makes_one, makes_no_value<Function, typename value_of<Before>::type...>>::value);

  static constexpr bool all_are_right = [] {
    if constexpr (is_right && makes_one)
      return (std::is_same_v<typename judged_function<Before>::type, Before> && ...);
    else return false;
  }();
  using type = std::conditional_t<all_are_right, Function, no_function>;
};

// `of` sees the sample, not the port: whether that is fresh depends on the reader.
template <class Function, class Space>
CCA_INLINE typename Function::value value_for(const sample<Space>& s);
template <class Function, class Space, class... Before>
CCA_INLINE typename Function::value value_from(const sample<Space>& s, from<Before...>) {
  return Function::of(value_for<Before>(s)...);
}
template <class Function, class Space>
CCA_INLINE typename Function::value value_for(const sample<Space>& s) {
  if constexpr (BuildsOnOthers<Function>) return value_from<Function>(s, typename Function::from{});
  else {
    static_assert(holds_or_tells<MakesValueOf<Function, sample<Space>>,
                                 makes_no_value<Function, sample<Space>>>::value);
    if constexpr (MakesValueOf<Function, sample<Space>>) return Function::of(s);
    else std::abort();
  }
}

}  // namespace detail

template <class Function, fixed_string Port>
class derived {
public:
  using function = typename detail::judged_function<Function>::type;
  using value = typename function::value;
  static constexpr std::string_view port = Port.view();

  derived() {}
  // For the beat: the value that all share, or that of a sample which no other component sees.
  explicit derived(const value* shared) : known(shared) {}
  template <class Space>
  explicit derived(const sample<Space>& shown) : known(make(shown)) {}
  // A copy keeps the shared value. A value that is not shared it computes itself.
  derived(const derived& other) : known(other.known == other.own() ? nullptr : other.known) {}
  derived& operator=(const derived&) = delete;

  template <class Shown>
  CCA_INLINE const value& of(const Shown& shown) const {
    static_assert(detail::holds_or_tells<detail::Shows<Shown, Port>,
                                         detail::derived_of_other<Function, Port, Shown>>::value);
    if constexpr (detail::Shows<Shown, Port>)
      if (known == nullptr) [[unlikely]]
        return anew(shown);
    return *known;
  }
  // Where it is called, a beat does not take it for likely.
  template <class Space>
  [[gnu::noinline, gnu::cold]] const value& anew(const sample<Space>& other) const {
    return *make(other);
  }

private:
  const value* own() const { return reinterpret_cast<const value*>(room); }
  template <class Space>
  CCA_INLINE const value* make(const sample<Space>& s) const {
    return ::new (static_cast<void*>(room)) value(detail::value_for<function>(s));
  }

  const value* known = nullptr;
  alignas(value) mutable unsigned char room[sizeof(value)];
};

}  // namespace cca
