// Ports, in the signature of `process`: what a component reads and what it publishes.
//
//   auto process(cca::in<"amplitude", amplitude> a, cca::beat now) -> cca::out<"phase", phase>;
//
// Cost: a port is a value of the size of its sample; after inlining the coordinates are all that is left.
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>

#include <cca/base/copy_block.hpp>
#include <cca/component/ports/observation.hpp>
#include <cca/base/fixed_string.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/space/messages/space_in_words.hpp>
#include <cca/space/methods/arithmetic.hpp>
#include <cca/space/sample.hpp>
#include <cca/space/methods/scalar.hpp>

namespace cca {

namespace detail {

// Stands for what is no space, so that the compiler has one thing to say and not twenty.
struct no_space : space<number, axes<x>> {
  static constexpr bool is_refused = true;
};

template <class Type>
inline constexpr bool is_space =
    Space<Type>;  // asked as a concept, both compilers would add what it is made of

template <class Type>
struct port_of_no_space {
  static constexpr void tell(text& m) {
    m << "component.bad_parameter: a port is of a space, and `" << type_name<Type>()
      << "` is none: make one of it, as in `struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip, "
         "knee>> {};`";
  }
};

// A function: of a struct with the same assertion the members would be unknown after it fails.
template <class Type>
constexpr auto space_or_refused() {
  static_assert(holds_or_tells<is_space<Type>, port_of_no_space<Type>>::value);
  return std::type_identity<std::conditional_t<is_space<Type>, Type, no_space>>{};
}
template <class Type>
using checked_space = typename decltype(space_or_refused<Type>())::type;

// An enumerator that is no number by itself.
template <class Type> concept Enumerator = std::is_enum_v<Type> && !std::is_convertible_v<Type, double>;

// Converts to a number, as a parameter that is cca::bounded does.
template <class Type> concept HoldsNumber = std::is_class_v<Type> &&
                                            std::is_convertible_v<const Type&, double> &&
                                            !requires { Type::SizeAtCompileTime; };

template <class Type> concept BareNumber = std::is_arithmetic_v<Type>;

// Of a space that neither is that of the output nor renames it.
template <class Other, class Space> concept Foreign = !std::is_same_v<Other, Space> && !Renames<Other, Space>;

// What the constructors say that take what does not fit.
template <class Port, int Given>
struct wrong_length {
  static constexpr void tell(text& m) {
    m << "component.bad_result: the port `" << Port::name << "` is made from a vector of " << Given
      << ", and a sample of " << space_in_words<typename Port::space>() << " has " << Port::space::size
      << (Port::space::size == 1 ? " coordinate" : " coordinates")
      << ": give one number for each axis (an orientation and a pose have a quaternion)";
  }
};
template <class Port, int Given>
struct of_bare_numbers {
  static constexpr void tell(text& m) {
    m << "component.bad_result: the output `" << Port::name << "` is made from " << Given
      << (Given == 1 ? " number" : " numbers") << ", and a sample of "
      << space_in_words<typename Port::space>() << " from a vector: write `Eigen::Vector<double, "
      << Port::space::size << ">{...}` with a number for each axis, or fill it by axis";
  }
};
template <class Port, class Type>
struct port_of_enumerator {
  static constexpr void tell(text& m) {
    m << "component.bad_result: the output `" << Port::name << "` holds numbers, and `" << type_name<Type>()
      << "` is an enumeration: write `cca::status_of(...)` around its value";
  }
};
template <class Port, class Given>
struct foreign_sample {
  static constexpr void tell(text& m) {
    m << "space.mismatch: the output `" << Port::name << "` of " << space_in_words<typename Port::space>()
      << " is made from a sample of " << space_in_words<Given>() << ": "
      << difference_in_words<Given, typename Port::space>()
      << "; put a mapping between them, or return its `vector()` if you mean the bare numbers";
  }
};

}  // namespace detail

// An input: the sample that the component sees in this firing. `fresh()`: it arrived since the component last
// fired.
template <fixed_string Name, class Space>
class in : public sample<typename decltype(detail::space_or_refused<Space>())::type> {
public:
  static constexpr std::string_view name = Name.view();

  constexpr in() = default;
  explicit in(detail::to_be_filled tag) : in::sample(tag) {}
  template <class Vector>
  constexpr in(const Eigen::MatrixBase<Vector>& v, std::int64_t origin, bool is_fresh)
      : in::sample(v, origin), arrived(is_fresh) {}
  template <class Vector>
    requires detail::Unfit<Vector, in::space::size>
  constexpr in(const Eigen::MatrixBase<Vector>&, std::int64_t, bool) {
    static_assert(detail::holds_or_tells<false, detail::wrong_length<in, Vector::SizeAtCompileTime>>::value);
  }

  constexpr bool fresh() const { return arrived; }
  // How many samples the queue of its wire has lost because it was full, so far; 0: the wire has no queue.
  constexpr std::int64_t dropped() const { return lost; }

  // For the beat: the sample as its writer left it, in this beat or before. One block, because a copy number
  // by number is not optimised away.
  template <bool IsOfBeat = false>
  void show(const typename in::vector_type& stored, std::int64_t origin, bool is_fresh) {
    constexpr bool refers = detail::is_large<typename in::space> || (IsOfBeat && detail::shows_in_place);
    if constexpr (refers && detail::may_refer<typename in::space>) this->refer_to(stored);
    else detail::copy_block<in::space::size>(this->value.data(), stored.data());
    this->time = origin;
    arrived = is_fresh;
  }
  constexpr void show_initial(const double* coordinates) {
    for (int i = 0; i < in::space::size; ++i) this->value.coeffRef(i) = coordinates[i];
    this->time = never;
    arrived = false;
  }
  constexpr void show_dropped(std::int64_t samples) {
    constexpr std::int64_t most = std::numeric_limits<std::uint32_t>::max();
    lost = static_cast<std::uint32_t>(samples < most ? samples : most);
  }

private:
  std::uint32_t lost = 0;  // not larger: a port is no larger for it
  bool arrived = false;
};

// An input that need not be wired; `if (port)` asks whether it is.
template <fixed_string Name, class Space>
class optional_in : public in<Name, Space> {
public:
  using in<Name, Space>::in;
  explicit constexpr operator bool() const { return wired; }
  constexpr void set_wired() { wired = true; }

private:
  bool wired = false;
};

// An output, made from a vector, from a number (a parameter, too) where the space has one axis, or filled by
// axis. It originates
// at the oldest origin among the inputs, unless `with_origin` says otherwise (nanoseconds since beat 0).
template <fixed_string Name, class Space>
class out {
public:
  static constexpr std::string_view name = Name.view();
  using space = typename decltype(detail::space_or_refused<Space>())::type;
  using vector_type = typename space::vector_type;

  constexpr out() {
    if constexpr (detail::has_zeros<space>) coordinates.setZero();
    else coordinates = sample<space>{}.vector();
  }
  constexpr out(const sample<space>& value) : coordinates(value.vector()) {}
  template <class Vector>
  constexpr out(const Eigen::MatrixBase<Vector>& v) : coordinates(v) {}
  constexpr out(double number)
    requires(space::size == 1)
  {
    coordinates[0] = number;
  }
  template <detail::HoldsNumber Number>
    requires(space::size == 1)
  constexpr out(const Number& number) : out(static_cast<double>(number)) {}
  template <detail::BareNumber... Numbers>
    requires(sizeof...(Numbers) > 1 || (sizeof...(Numbers) == 1 && space::size != 1))
  constexpr out(Numbers...) {
    static_assert(detail::holds_or_tells<false, detail::of_bare_numbers<out, sizeof...(Numbers)>>::value);
  }
  template <class Vector>
    requires detail::Unfit<Vector, space::size>
  constexpr out(const Eigen::MatrixBase<Vector>&) {
    static_assert(detail::holds_or_tells<false, detail::wrong_length<out, Vector::SizeAtCompileTime>>::value);
  }
  template <detail::Foreign<space> Other>
  constexpr out(const sample<Other>&) {
    static_assert(detail::holds_or_tells<false, detail::foreign_sample<out, Other>>::value);
  }
  template <detail::Enumerator State>
  constexpr out(State) {
    static_assert(detail::holds_or_tells<false, detail::port_of_enumerator<out, State>>::value);
  }

  template <class Axis>
  constexpr double& operator[](Axis) {
    static_assert(detail::holds_or_tells<space::axes::template contains<Axis>,
                                         detail::unknown_axis<space, Axis>>::value);
    static_assert(
        detail::holds_or_tells<(space::size == space::axes::count || !space::axes::template contains<Axis>),
                               detail::no_number_per_axis<space>>::value);
    return coordinates[space::axes::template index_of<Axis>];
  }
  template <class Axis>
  constexpr double operator[](Axis axis) const {
    return const_cast<out&>(*this)[axis];
  }

  constexpr out& with_origin(std::int64_t t) & {
    time = t;
    return *this;
  }
  constexpr out&& with_origin(std::int64_t t) && {
    time = t;
    return static_cast<out&&>(*this);
  }

  constexpr vector_type& vector() { return coordinates; }
  constexpr const vector_type& vector() const { return coordinates; }
  constexpr std::int64_t origin() const { return time; }  // `never`: not set by the component

private:
  vector_type coordinates;
  std::int64_t time = never;
};

// An output that is not published each time: empty, nothing is published.
template <fixed_string Name, class Space>
class maybe : public out<Name, Space> {
public:
  constexpr maybe() = default;
  constexpr maybe(const sample<typename maybe::space>& value) : out<Name, Space>(value), published(true) {}
  constexpr maybe(const out<Name, Space>& value) : out<Name, Space>(value), published(true) {}
  template <class Vector>
  constexpr maybe(const Eigen::MatrixBase<Vector>& v) : out<Name, Space>(v), published(true) {}
  constexpr maybe(double number)
    requires(maybe::space::size == 1)
      : out<Name, Space>(number), published(true) {}
  template <detail::HoldsNumber Number>
    requires(maybe::space::size == 1)
  constexpr maybe(const Number& number) : maybe(static_cast<double>(number)) {}
  template <detail::BareNumber... Numbers>
    requires(sizeof...(Numbers) > 1 || (sizeof...(Numbers) == 1 && maybe::space::size != 1))
  constexpr maybe(Numbers...) {
    static_assert(detail::holds_or_tells<false, detail::of_bare_numbers<maybe, sizeof...(Numbers)>>::value);
  }
  template <class Vector>
    requires detail::Unfit<Vector, maybe::space::size>
  constexpr maybe(const Eigen::MatrixBase<Vector>&) {
    static_assert(
        detail::holds_or_tells<false, detail::wrong_length<maybe, Vector::SizeAtCompileTime>>::value);
  }
  template <detail::Foreign<typename maybe::space> Other>
  constexpr maybe(const sample<Other>&) {
    static_assert(detail::holds_or_tells<false, detail::foreign_sample<maybe, Other>>::value);
  }
  template <detail::Enumerator State>
  constexpr maybe(State state) : out<Name, Space>(state) {}

  // Filling it by axis publishes it.
  template <class Axis>
  constexpr double& operator[](Axis axis) {
    published = true;
    return out<Name, Space>::operator[](axis);
  }
  template <class Axis>
  constexpr double operator[](Axis axis) const {
    return out<Name, Space>::operator[](axis);
  }

  constexpr maybe& with_origin(std::int64_t t) & {
    out<Name, Space>::with_origin(t);
    return *this;
  }
  constexpr maybe&& with_origin(std::int64_t t) && {
    out<Name, Space>::with_origin(t);
    return static_cast<maybe&&>(*this);
  }

  // So does filling it whole.
  constexpr typename maybe::vector_type& vector() {
    published = true;
    return out<Name, Space>::vector();
  }
  constexpr const typename maybe::vector_type& vector() const { return out<Name, Space>::vector(); }

  explicit constexpr operator bool() const { return published; }

private:
  bool published = false;
};

}  // namespace cca
