// The record that a device sends, described once: its fields in order, each with a name and a space. Writers
// and readers take their places from it, so no offset is written twice.
//
//   struct imu_record : cca::robots::record_of<cca::robots::field<"orientation", orientation>,
//                                              cca::robots::field<"acceleration", acceleration>> {};
//   imu_record::part<"acceleration">(v) << 0, 0, 9.81;      // a writer
//   const auto up = imu_record::part<"acceleration">(v)[2];   // a reader
//
// The space of a field says unit, frame and how many numbers it has. Cost: constants.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include <cca/base/messages/tell_names.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/fixed_string.hpp>
#include <cca/space/space.hpp>

namespace cca::robots {

template <fixed_string Name, Space Unit>
struct field {
  static constexpr auto name = Name;
  using space = Unit;
  static constexpr int size = Unit::size;
};

template <class... Fields>
struct record_of {
  static constexpr int size = (Fields::size + ...);  // numbers

  template <fixed_string Name>
  static constexpr auto part(auto& numbers) {
    constexpr int i = index_of(Name.view());
    constexpr bool exists = i < int(sizeof...(Fields));
    static_assert(cca::detail::holds_or_tells<exists, no_field<Name>>::value);
    constexpr std::size_t at = exists ? std::size_t(i) : 0;
    return numbers.template segment<sizes[at]>(starts[at]);
  }

private:
  template <fixed_string Name>
  struct no_field {
    static constexpr void tell(auto& m) {
      m << "cca::robots::record_of: this record has no field `" << Name.view() << "`";
      cca::detail::tell_names(m, Name.view(), names);
    }
  };
  static constexpr std::array<std::string_view, sizeof...(Fields)> names{Fields::name.view()...};
  static constexpr std::array<int, sizeof...(Fields)> sizes{Fields::size...};
  static constexpr auto starts = [] {
    std::array<int, sizeof...(Fields)> all{};
    for (std::size_t i = 1; i < all.size(); ++i) all[i] = all[i - 1] + sizes[i - 1];
    return all;
  }();
  static constexpr int index_of(std::string_view name) {
    int i = 0;
    while (i < int(names.size()) && names[std::size_t(i)] != name) ++i;
    return i;
  }
};

}  // namespace cca::robots
