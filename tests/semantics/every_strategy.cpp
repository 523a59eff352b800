// Every strategy of the library is one that the random architectures exercise: what `coverage::wanted` lists
// must happen in a run, and only the interpreter (its `fires`) and the generator (architecture.py,
// spelling.py) can make it happen.
#include <string_view>

#include <cca/component/strategies.hpp>

#include "coverage.hpp"

namespace {

template <class Strategy>
constexpr bool is_exercised() {
  cca::detail::text spelled;
  cca::detail::add_strategy_name<Strategy>(spelled);
  const auto name = spelled.view().substr(0, spelled.view().find('<'));
  for (const std::string_view wanted : semantics::coverage::wanted)
    if (wanted == name || (wanted.starts_with(name) && wanted[name.size()] == ',')) return true;
  return false;
}

template <class Strategy>
struct exercised {
  static_assert(is_exercised<Strategy>(),
                "a strategy of component/strategies.hpp is missing in tests/semantics: add it to the "
                "interpreter (run_time_graph.hpp, description.hpp, interpreter.hpp), to the generator "
                "(architecture.py) and to coverage.hpp");
};

template <class List>
struct all_exercised;
template <class... Strategies>
struct all_exercised<cca::detail::list<Strategies...>> : exercised<Strategies>... {};

[[maybe_unused]] constexpr all_exercised<cca::detail::library_strategies> checked{};

}  // namespace
