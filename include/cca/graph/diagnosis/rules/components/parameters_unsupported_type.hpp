// parameters.unsupported_type: a file can hold every parameter.
#pragma once

#include <cca/component/parameters.hpp>
#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct parameters_unsupported_type {
  static constexpr std::string_view id = "parameters.unsupported_type";

  static constexpr bool is_broken(when::whole_component, const flat_view&, const finding& f) {
    return !f.item->component->bad_field.empty() || f.item->component->forgot_parameters;
  }

  static constexpr void tell(auto& m) {
    m.at_node();
    m.node();
    const auto& c = *m.item().component;
    if (c.forgot_parameters) {
      m.say() << " has a struct `parameters` but no public member `parameters p`, so nothing would ever set "
                 "them: "
                 "add `parameters p{...};` with the default values";
      return;
    }
    m.say() << ": its parameter `" << c.bad_field << "` is a `" << c.bad_field_type << "`";
    if (c.bad_field == "p")
      m.say() << ", whose fields are unknown: name them in it with BOOST_HANA_DEFINE_STRUCT, and make it "
                 "copyable";
    else
      m.say()
          << ", which no file can hold: use a number, bool, enum class, cca::bounded, cca::quantity, "
             "cca::text, "
             "a std::array or Eigen vector of fixed size of these, or a struct with BOOST_HANA_DEFINE_STRUCT";
  }
};

}  // namespace cca::detail
