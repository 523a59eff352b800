// The only header that includes Boost.Hana: reads the fields of a struct by name, for `parameters`. It
// provides BOOST_HANA_DEFINE_STRUCT to users.
//
// The macro gets a message here: a comma that is forgotten in it gives one error, and not hundreds of lines.
// What it defines is Hana's. Errors: parameters.missing_comma.
//
// Cost: measured in docs/parameters.md; of Hana it includes only the struct macros, tuple, pair and string.
#pragma once

#include <cca/base/compiler.hpp>

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>

#include <boost/hana/accessors.hpp>
#include <boost/hana/define_struct.hpp>
#include <boost/hana/first.hpp>
#include <boost/hana/second.hpp>
#include <boost/hana/unpack.hpp>

namespace cca::detail {

template <class Type> concept Reflected = boost::hana::Struct<Type>::value;

// A copy of Hana's text, which isn't `inline`: inline data that points to it can't always be linked
// (docs/compilers.md).
template <class Name>
inline constexpr auto field_name = [] {
  constexpr std::string_view name = Name::c_str();
  std::array<char, name.size() + 1> copy{};
  for (std::size_t i = 0; i < name.size(); ++i) copy[i] = name[i];
  return copy;
}();

// One field as a type: its name, its type and how to read it.
template <class Table, class Name, class Access>
struct field {
  static constexpr std::string_view name() { return {field_name<Name>.data(), field_name<Name>.size() - 1}; }
  static constexpr const auto& of(const Table& table) { return Access{}(table); }
  // Keeps the field's `const`.
  using type = std::remove_reference_t<decltype(Access{}(std::declval<Table&>()))>;
};

// Calls f(field<...>{}...), in the order of declaration.
template <Reflected Table, class F>
constexpr auto with_fields(F f) {
  return boost::hana::unpack(boost::hana::accessors<Table>(), [&](auto... pairs) {
    return f(field<Table, std::remove_cvref_t<decltype(boost::hana::first(pairs))>,
                   std::remove_cvref_t<decltype(boost::hana::second(pairs))>>{}...);
  });
}

}  // namespace cca::detail

// ---- BOOST_HANA_DEFINE_STRUCT ----

namespace cca::detail {

// Of what it is asked for here only an identifier has none of these.
constexpr bool is_identifier(std::string_view word) {
  return !word.empty() && word.find_first_of(" <>()[]{}.:&*'\"") == word.npos;
}

constexpr std::string_view without_spaces_around(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

// Where the first comma is that no bracket encloses, or the first bracket that closes more than was opened,
// or the end. Angle brackets don't count: they may also be operators.
constexpr std::size_t end_of_argument(std::string_view text) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == ',' && depth == 0) return i;
    if (text[i] == '(' || text[i] == '[' || text[i] == '{') ++depth;
    if ((text[i] == ')' || text[i] == ']' || text[i] == '}') && depth-- == 0) return i;
  }
  return text.size();
}

// "(double, gain)": a type, which may have commas in angle brackets, and a name.
constexpr bool is_field(std::string_view text) {
  if (!text.starts_with('(')) return false;
  text.remove_prefix(1);
  for (bool has_type = false;; has_type = true) {
    const std::size_t end = end_of_argument(text);
    if (end == text.size()) return false;
    if (text[end] == ')')
      return has_type && end + 1 == text.size() && is_identifier(without_spaces_around(text.substr(0, end)));
    text.remove_prefix(end + 1);
  }
}

// "parameters, (double, gain), (int, count)": the name of the struct, and its fields.
constexpr bool has_all_commas(std::string_view text) {
  for (bool is_name = true; !text.empty(); is_name = false) {
    const std::size_t end = end_of_argument(text);
    const auto argument = without_spaces_around(text.substr(0, end));
    if (is_name ? argument.find('(') != argument.npos : !is_field(argument)) return false;
    text.remove_prefix(end == text.size() ? end : end + 1);
  }
  return true;
}

}  // namespace cca::detail

#define CCA_TEXT(...) #__VA_ARGS__
#define CCA_SECOND(first, second, ...) second

// CCA_EACH(f, a, b): f(a) f(b), for up to 64.
#define CCA_EACH(f, ...) __VA_OPT__(CCA_AGAIN(CCA_EACH_STEP(f, __VA_ARGS__)))
#define CCA_EACH_STEP(f, one, ...) f(one) __VA_OPT__(CCA_EACH_NEXT CCA_BRACKETS(f, __VA_ARGS__))
#define CCA_EACH_NEXT() CCA_EACH_STEP
#define CCA_BRACKETS ()
#define CCA_AGAIN(...) CCA_AGAIN_16(CCA_AGAIN_16(CCA_AGAIN_16(CCA_AGAIN_16(__VA_ARGS__))))
#define CCA_AGAIN_16(...) CCA_AGAIN_4(CCA_AGAIN_4(CCA_AGAIN_4(CCA_AGAIN_4(__VA_ARGS__))))
#define CCA_AGAIN_4(...) CCA_AGAIN_1(CCA_AGAIN_1(CCA_AGAIN_1(CCA_AGAIN_1(__VA_ARGS__))))
#define CCA_AGAIN_1(...) __VA_ARGS__

// Nothing for `(double, gain)`; something for `(double gain)` and for `(double, gain) (int, count)`.
#define CCA_WRONG_FIELD(field) CCA_WRONG_IN field
#define CCA_WRONG_IN(first, ...) CCA_SECOND(first __VA_OPT__(, ), wrong, )
// Nothing for `parameters`, but `(double, gain)` for `parameters (double, gain)`. A macro has to know the
// name in front of a bracket, so only structs of this name are looked at.
#define CCA_WRONG_NAME(name) CCA_SECOND_OF(CCA_NAME_##name, , )
#define CCA_NAME_parameters(...) first, (__VA_ARGS__)
#define CCA_SECOND_OF(...) CCA_SECOND(__VA_ARGS__)
#define CCA_WRONG(name, ...) CCA_WRONG_NAME(name) CCA_EACH(CCA_WRONG_FIELD, __VA_ARGS__)

// After the message: the fields, so that nothing else is reported.
#define CCA_DEFINE_STRUCT_WRONG(name, ...)                                                        \
  CCA_FIELDS(CCA_WRONG_NAME(name)) CCA_EACH(CCA_FIELDS, __VA_ARGS__) struct hana_accessors_impl { \
    static constexpr auto apply() { return ::boost::hana::make_tuple(); }                         \
  }
#define CCA_FIELDS(fields) BOOST_HANA_PP_CONCAT(CCA_FIELD fields, _END)
#define CCA_FIELD(...)                                                  \
  BOOST_HANA_PP_DROP_BACK(__VA_ARGS__) BOOST_HANA_PP_BACK(__VA_ARGS__); \
  CCA_NEXT_FIELD
#define CCA_NEXT_FIELD(...)                                             \
  BOOST_HANA_PP_DROP_BACK(__VA_ARGS__) BOOST_HANA_PP_BACK(__VA_ARGS__); \
  CCA_FIELD
#define CCA_FIELD_END
#define CCA_NEXT_FIELD_END

// As Hana defines BOOST_HANA_DEFINE_STRUCT.
#define CCA_DEFINE_STRUCT(...) BOOST_HANA_DEFINE_STRUCT_IMPL(BOOST_HANA_PP_NARG(__VA_ARGS__), __VA_ARGS__)
#define CCA_DEFINE_STRUCT_IF(...) CCA_DEFINE_STRUCT##__VA_OPT__(_WRONG)

#undef BOOST_HANA_DEFINE_STRUCT
#define BOOST_HANA_DEFINE_STRUCT(...)                                                                    \
  static_assert(::cca::detail::has_all_commas(CCA_TEXT(__VA_ARGS__)),                                  \
                "parameters.missing_comma: a comma is missing in BOOST_HANA_DEFINE_STRUCT(" CCA_TEXT(  \
                    __VA_ARGS__) "): put one between the type and the name of each field, and one in " \
                                 "front of each field"); \
  CCA_DEFINE_STRUCT_IF(CCA_WRONG(__VA_ARGS__))(__VA_ARGS__)
