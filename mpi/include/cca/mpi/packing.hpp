// The result of a run as bytes, and back, so that it can go to another rank.
//
// What can go: a trivially copyable value without pointers (a number, a struct of numbers), Eigen's vectors
// and matrices, std::string; std::vector, std::optional and std::pair of these; and a struct whose fields
// BOOST_HANA_DEFINE_STRUCT states, if each of them can go. A pointer within a struct is not seen.
//
// Errors: run.not_sent, when it is compiled. Test: tests/runtime/mpi/packing.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <cca/base/eigen.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/reflect.hpp>

namespace cca::mpi::detail {

using cca::detail::Reflected;
using cca::detail::text;

// It means something in its process only.
template <class T>
inline constexpr bool points =
    std::is_pointer_v<T> || std::is_member_pointer_v<T> || std::is_null_pointer_v<T>;
template <class Letter, class Traits>
inline constexpr bool points<std::basic_string_view<Letter, Traits>> = true;
template <class T, std::size_t Extent>
inline constexpr bool points<std::span<T, Extent>> = true;
template <class T>
inline constexpr bool points<std::reference_wrapper<T>> = true;
template <class T>
inline constexpr bool points<std::optional<T>> = points<T>;
template <class T, std::size_t Count>
inline constexpr bool points<std::array<T, Count>> = points<T>;

template <class T> concept Plain = std::is_trivially_copyable_v<T> && !points<T>;
template <class T> concept Matrix =
    std::is_base_of_v<Eigen::PlainObjectBase<T>, T> && Plain<typename T::Scalar>;

// How T becomes bytes: `put` appends them, `get` takes them from the front. No specialisation: it can't.
template <class T>
struct packing;

template <class T> concept Packable = requires { packing<T>::is_possible; } && packing<T>::is_possible;

template <class T>
void put(std::string& bytes, const T& value) {
  packing<T>::put(bytes, value);
}
template <class T>
T get(std::string_view& bytes) {
  return packing<T>::get(bytes);
}

inline std::string_view take(std::string_view& bytes, std::size_t count) {
  if (count > bytes.size()) throw std::runtime_error("cca::mpi: a message of another rank is cut short");
  const std::string_view first = bytes.substr(0, count);
  bytes.remove_prefix(count);
  return first;
}

template <Plain T>
struct packing<T> {
  static constexpr bool is_possible = true;
  static void put(std::string& bytes, const T& value) {
    const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
    bytes.append(raw.data(), raw.size());
  }
  static T get(std::string_view& bytes) {
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), take(bytes, raw.size()).data(), raw.size());
    return std::bit_cast<T>(raw);
  }
};

template <Matrix T>
  requires(!Plain<T>)
struct packing<T> {
  static constexpr bool is_possible = true;
  static void put(std::string& bytes, const T& value) {
    detail::put(bytes, static_cast<std::int64_t>(value.rows()));
    detail::put(bytes, static_cast<std::int64_t>(value.cols()));
    for (Eigen::Index i = 0; i < value.size(); ++i) detail::put(bytes, value.data()[i]);
  }
  static T get(std::string_view& bytes) {
    const auto rows = detail::get<std::int64_t>(bytes), columns = detail::get<std::int64_t>(bytes);
    T value;
    value.resize(rows, columns);
    for (Eigen::Index i = 0; i < value.size(); ++i) value.data()[i] = detail::get<typename T::Scalar>(bytes);
    return value;
  }
};

template <>
struct packing<std::string> {
  static constexpr bool is_possible = true;
  static void put(std::string& bytes, const std::string& value) {
    detail::put(bytes, static_cast<std::uint64_t>(value.size()));
    bytes += value;
  }
  static std::string get(std::string_view& bytes) {
    const auto size = detail::get<std::uint64_t>(bytes);
    return std::string(take(bytes, size));
  }
};

template <Packable T, class Allocator>
struct packing<std::vector<T, Allocator>> {
  static constexpr bool is_possible = true;
  static void put(std::string& bytes, const std::vector<T, Allocator>& values) {
    detail::put(bytes, static_cast<std::uint64_t>(values.size()));
    for (const T& value : values) detail::put(bytes, value);
  }
  static std::vector<T, Allocator> get(std::string_view& bytes) {
    const auto size = detail::get<std::uint64_t>(bytes);
    std::vector<T, Allocator> values;
    values.reserve(std::min<std::size_t>(size, bytes.size()));
    for (std::uint64_t i = 0; i < size; ++i) values.push_back(detail::get<T>(bytes));
    return values;
  }
};

template <Packable T>
  requires(!Plain<std::optional<T>>)
struct packing<std::optional<T>> {
  static constexpr bool is_possible = true;
  static void put(std::string& bytes, const std::optional<T>& value) {
    detail::put(bytes, value.has_value());
    if (value) detail::put(bytes, *value);
  }
  static std::optional<T> get(std::string_view& bytes) {
    if (!detail::get<bool>(bytes)) return std::nullopt;
    return detail::get<T>(bytes);
  }
};

template <Packable First, Packable Second>
  requires(!Plain<std::pair<First, Second>>)
struct packing<std::pair<First, Second>> {
  static constexpr bool is_possible = true;
  static void put(std::string& bytes, const std::pair<First, Second>& value) {
    detail::put(bytes, value.first);
    detail::put(bytes, value.second);
  }
  static std::pair<First, Second> get(std::string_view& bytes) {
    First first = detail::get<First>(bytes);
    return {std::move(first), detail::get<Second>(bytes)};
  }
};

template <Reflected T>
  requires(!Plain<T> && std::is_default_constructible_v<T>)
struct packing<T> {
  static constexpr bool is_possible = cca::detail::with_fields<T>(
      [](auto... field) { return (Packable<std::remove_const_t<typename decltype(field)::type>> && ...); });
  static void put(std::string& bytes, const T& value) {
    cca::detail::with_fields<T>([&](auto... field) { (detail::put(bytes, field.of(value)), ...); });
  }
  static T get(std::string_view& bytes) {
    T value{};
    cca::detail::with_fields<T>([&](auto... field) {
      ((const_cast<typename decltype(field)::type&>(field.of(value)) =
            detail::get<typename decltype(field)::type>(bytes)),
       ...);
    });
    return value;
  }
};

template <class Result>
struct not_sent {
  static constexpr void tell(text& m) {
    m << "run.not_sent: a run returns `" << cca::detail::type_name<Result>()
      << "`, which cannot go to another rank: return a value that is trivially copyable and no pointer, a "
         "vector of Eigen, a std::string, a std::vector of these, or state the fields by "
         "BOOST_HANA_DEFINE_STRUCT";
  }
};

}  // namespace cca::mpi::detail
