// The reason of a fault where an environment's samples stay away, as static text.
#pragma once

#include <array>
#include <string_view>

#include <cca/base/array_size.hpp>
#include <cca/graph/plan/deployment/environments.hpp>

namespace cca::detail {

template <class D>
inline constexpr auto lost_contacts = [] {
  constexpr std::size_t longest = [] {
    std::size_t size = 0;
    for (const auto& e : environments_of<D>::all) size = e.name.size() > size ? e.name.size() : size;
    return size;
  }();
  std::array<std::array<char, longest + 24>, array_size(environment_count<D>)> texts{};
  for (std::size_t e = 0; e < texts.size(); ++e) {
    char* end = texts[e].data();
    for (const std::string_view part :
         {std::string_view("lost contact with `"), environments_of<D>::all[e].name, std::string_view("`")})
      for (const char letter : part) *end++ = letter;
  }
  return texts;
}();

template <class D>
constexpr std::string_view lost_contact(int environment) {
  const auto& text = lost_contacts<D>[array_size(environment)];
  return {text.data(), environments_of<D>::all[array_size(environment)].name.size() + 20};
}

}  // namespace cca::detail
