// Parameters of a component, as a recording has them. Errors: cca::refused, if they are missing or not those
// of the component, or, where they are checked, if they do not hold.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <cca/base/refused.hpp>
#include <cca/component/parameters.hpp>
#include <cca/record/mcap/printable.hpp>
#include <cca/record/messages/parameter_message.hpp>
#include <cca/record/replay/parameter_difference.hpp>
#include <cca/runtime/controller.hpp>

namespace cca::recording::detail {

// `schema`: as the file describes them. `called`: the file.
template <class Graph, class C>
void check_names_of_parameters(int node, const std::string& schema, const std::string& called) {
  std::string here;
  if constexpr (HasParameters<C>) here = parameter_schema(cca::detail::schema_of<typename C::parameters>);
  if (const std::string differs = parameter_difference(here, schema); !differs.empty())
    throw refused(called + ": the recorded parameters of `" + cca::detail::path_of_node<Graph>(node) +
                  "` are not those of this component: " + differs);
}

// `called`: the file.
template <class Graph, class C>
void take_parameters(C& component,
                     int node,
                     const std::vector<unsigned char>& message,
                     const std::string& called,
                     bool are_checked) {
  const std::string path = cca::detail::path_of_node<Graph>(node);
  auto values = component.p;
  cdr_reader from(message);
  from.number<std::int64_t>();
  if (!decode(cca::detail::schema_of<typename C::parameters>, &values, from) || !from.is_at_end())
    throw refused(called + ": the recorded parameters of `" + path + "` are not those of this component");
  if (are_checked)
    for (const auto& wrong : cca::detail::complaints_about(values, path, cca::detail::step_of<Graph>(node)))
      throw refused(called + ": recorded parameters: " + wrong.path + ": " + printable(wrong.what));
  component.p = values;
}

// The components whose parameters a recording has told so far.
template <class Graph>
class told_parameters {
public:
  void add(int node) { is_told[cca::detail::array_size(node)] = true; }

  // The others that ran in the recorded process; empty: none.
  template <class Controller, class Items>
  std::string missing(Controller& c, const Items& items) const {
    std::string all;
    int node = 0;
    c.for_each_component([&]<class C>(std::string_view path, C&) {
      if (HasParameters<C> && !is_told[cca::detail::array_size(node)] && items.node_ran_here(node))
        all.append(all.empty() ? "`" : ", `").append(path).append("`");
      ++node;
    });
    return all;
  }
  template <class Controller, class Items>
  void check(Controller& c, const Items& items, const std::string& called) const {
    if (const std::string all = missing(c, items); !all.empty())
      throw refused(called + ": no parameters are recorded of " + all +
                    ": keep the topics /cca/parameters/* when you filter a recording");
  }

private:
  std::array<bool, cca::detail::array_size(cca::detail::counts_of<Graph>.node_count + 1)> is_told{};
};

}  // namespace cca::recording::detail
