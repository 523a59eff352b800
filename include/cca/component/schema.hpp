// Describes a `parameters` struct as data, so that ordinary functions can check, read and write any of them:
// they are compiled once, not once per component.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include <Eigen/Core>

#include <cca/base/enumerators.hpp>
#include <cca/component/field_types.hpp>
#include <cca/base/reflect.hpp>
#include <cca/base/type_name.hpp>
#include <cca/space/units.hpp>

namespace cca::detail {

enum class kind : std::uint8_t { unsupported, boolean, integer, number, choice, text, array, table };

struct schema;

struct member {
  std::string_view name;
  const schema* type = nullptr;
  const void* (*of)(const void* table) = nullptr;
};

struct schema {
  kind what = kind::unsupported;
  std::string_view spelling{};  // of an unsupported type
  std::size_t bytes = 0;        // of a boolean, integer, number or choice

  // boolean, integer, choice
  std::int64_t (*integer)(const void*) = nullptr;
  void (*set_integer)(void*, std::int64_t) = nullptr;
  std::int64_t lowest = 0, highest = 0;
  const std::string_view* names = nullptr;

  // number, in SI units; `single` if held as float
  double (*number)(const void*) = nullptr;
  void (*set_number)(void*, double) = nullptr;
  double lower = 0, upper = 0;
  bool stated_range = false;  // by `bounded` or `quantity`; else the range is that of the type
  bool single = false;
  std::string_view unit{};           // the SI unit, empty for a plain number
  const cca::unit* units = nullptr;  // the units a file may use, as in units_of

  // text of at most `count` bytes
  std::string_view (*characters)(const void*) = nullptr;
  bool (*set_characters)(void*, std::string_view) = nullptr;

  // array of `count` elements, table of `count` members
  std::size_t count = 0;
  const schema* element = nullptr;
  const void* (*at)(const void*, std::size_t) = nullptr;
  const member* members = nullptr;
  std::string (*complaint)(const void*) = nullptr;  // the struct's own check()
};

template <class Type>
constexpr schema make_schema();

template <class Type>
inline constexpr schema schema_of = make_schema<Type>();

template <class Type, class... Others> concept OneOf = (std::same_as<Type, Others> || ...);

// Without the character types and `bool`, which are not numbers.
template <class Type> concept PlainInteger =
    std::integral<Type> && !OneOf<Type, bool, char, wchar_t, char8_t, char16_t, char32_t>;

template <class Type> concept PlainNumber = OneOf<Type, float, double>;

template <class Type> concept Ranged = requires {
  typename Type::value_type;
  Type::lower;
  Type::upper;
} && std::derived_from<Type, ranged<typename Type::value_type, Type::lower, Type::upper>>;

template <class Type>
constexpr std::size_t text_capacity = 0;
template <std::size_t Capacity>
constexpr std::size_t text_capacity<cca::text<Capacity>> = Capacity;

template <class Type>
struct array_traits {
  static constexpr std::size_t count = 0;
};
template <class Type, std::size_t Count>
struct array_traits<std::array<Type, Count>> {
  static constexpr std::size_t count = Count;
  using element = Type;
  static const void* at(const void* array, std::size_t i) {
    return static_cast<const std::array<Type, Count>*>(array)->data() + i;
  }
};

// One row of a matrix; Stride is the distance of its elements in memory.
template <class Scalar, int Columns, int Stride>
struct matrix_row {};
template <class Scalar, int Columns, int Stride>
struct array_traits<matrix_row<Scalar, Columns, Stride>> {
  static constexpr std::size_t count = std::size_t{Columns};
  using element = Scalar;
  static const void* at(const void* row, std::size_t i) {
    return static_cast<const Scalar*>(row) + i * std::size_t{Stride};
  }
};
template <class Scalar, int Rows, int Columns, int Options>
  requires(Rows > 0 && Columns > 0)
struct array_traits<Eigen::Matrix<Scalar, Rows, Columns, Options, Rows, Columns>> {
  static constexpr bool vector = Rows == 1 || Columns == 1, row_major = (Options & Eigen::RowMajor) != 0;
  static constexpr std::size_t count = vector ? std::size_t{Rows} * std::size_t{Columns} : std::size_t{Rows};
  using element = std::conditional_t<vector, Scalar, matrix_row<Scalar, Columns, row_major ? 1 : Rows>>;
  static const void* at(const void* matrix, std::size_t i) {
    const auto* values =
        static_cast<const Eigen::Matrix<Scalar, Rows, Columns, Options, Rows, Columns>*>(matrix)->data();
    return values + i * (!vector && row_major ? std::size_t{Columns} : 1);
  }
};

template <class Type>
constexpr schema integer_schema(std::int64_t lowest, std::int64_t highest) {
  return {
      .what = kind::integer,
      .bytes = sizeof(Type),
      // TOML integers have 64 bits with a sign. A larger value becomes the largest one, which `highest`
      // refuses.
      .integer =
          [](const void* at) {
            const auto value = *static_cast<const Type*>(at);
            return std::in_range<std::int64_t>(value) ? static_cast<std::int64_t>(value)
                                                      : std::numeric_limits<std::int64_t>::max();
          },
      .set_integer = [](void* at, std::int64_t value) { *static_cast<Type*>(at) = static_cast<Type>(value); },
      .lowest = lowest,
      .highest = highest};
}

template <std::integral Type>
constexpr std::int64_t clipped(Type value) {
  return std::in_range<std::int64_t>(value) ? static_cast<std::int64_t>(value)
                                            : std::numeric_limits<std::int64_t>::max() - 1;
}

template <class Type>
constexpr schema number_schema(double lower, double upper) {
  return {.what = kind::number,
          .bytes = sizeof(Type),
          .number = [](const void* at) { return static_cast<double>(*static_cast<const Type*>(at)); },
          .set_number = [](void* at, double value) { *static_cast<Type*>(at) = static_cast<Type>(value); },
          .lower = lower,
          .upper = upper,
          .single = std::same_as<Type, float>};
}

template <class Type>
constexpr schema ranged_schema() {
  using held = typename Type::value_type;
  schema result;
  if constexpr (PlainInteger<held>) {
    result = integer_schema<held>(clipped(Type::lower), clipped(Type::upper));
  } else {
    result = number_schema<held>(Type::lower, Type::upper);
    if constexpr (requires { typename Type::measures; }) {
      result.unit = Type::measures::unit;
      result.units = units_of<typename Type::measures>;
    }
  }
  result.stated_range = true;
  return result;
}

template <class Table>
inline constexpr auto members_of = with_fields<Table>([]<class... Fields>(Fields...) {
  return std::array<member, sizeof...(Fields)>{
      member{Fields::name(), &schema_of<typename Fields::type>, [](const void* table) {
               return static_cast<const void*>(std::addressof(Fields::of(*static_cast<const Table*>(table))));
             }}...};
});

template <class Table>
constexpr schema table_schema() {
  schema result{.what = kind::table, .count = members_of<Table>.size(), .members = members_of<Table>.data()};
  if constexpr (requires(const Table& table) { std::string(table.check()); })
    result.complaint = [](const void* table) {
      return std::string(static_cast<const Table*>(table)->check());
    };
  return result;
}

template <class Type>
constexpr schema make_schema() {
  if constexpr (std::is_const_v<Type>) {
    return {.spelling = spelled<Type>()};
  } else if constexpr (std::same_as<Type, bool>) {
    return {.what = kind::boolean,
            .bytes = sizeof(Type),
            .integer = [](const void* at) { return std::int64_t{*static_cast<const bool*>(at)}; },
            .set_integer = [](void* at, std::int64_t value) { *static_cast<bool*>(at) = value != 0; }};
  } else if constexpr (PlainInteger<Type>) {
    return integer_schema<Type>(static_cast<std::int64_t>(std::numeric_limits<Type>::lowest()),
                                clipped(std::numeric_limits<Type>::max()));
  } else if constexpr (PlainNumber<Type>) {
    return number_schema<Type>(static_cast<double>(std::numeric_limits<Type>::lowest()),
                               static_cast<double>(std::numeric_limits<Type>::max()));
  } else if constexpr (Ranged<Type>) {
    if constexpr (PlainInteger<typename Type::value_type> || PlainNumber<typename Type::value_type>)
      return ranged_schema<Type>();
    else return {.spelling = spelled<Type>()};
  } else if constexpr (NameableEnum<Type>) {
    return {
        .what = kind::choice,
        .bytes = sizeof(Type),
        .integer = [](const void* at) { return static_cast<std::int64_t>(*static_cast<const Type*>(at)); },
        .set_integer = [](void* at,
                          std::int64_t value) { *static_cast<Type*>(at) = static_cast<Type>(value); },
        .names = enumerators<Type>.data(),
        .count = enumerators<Type>.size()};
  } else if constexpr (text_capacity<Type> > 0) {
    return {.what = kind::text,
            .characters = [](const void* at) { return static_cast<const Type*>(at)->view(); },
            .set_characters = [](void* at,
                                 std::string_view from) { return static_cast<Type*>(at)->assign(from); },
            .count = text_capacity<Type>};
  } else if constexpr (array_traits<Type>::count > 0) {
    return {.what = kind::array,
            .count = array_traits<Type>::count,
            .element = &schema_of<typename array_traits<Type>::element>,
            .at = &array_traits<Type>::at};
  } else if constexpr (std::is_class_v<Type> && Reflected<Type>) {
    return table_schema<Type>();
  } else {
    return {.spelling = spelled<Type>()};
  }
}

}  // namespace cca::detail
