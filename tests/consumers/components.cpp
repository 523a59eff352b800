// The headers of the components, each with a symbol that only its library has.
#include <ode/ode.h>
#include <toml++/toml.h>

bool components_work() {
  dInitODE();
  dCloseODE();
  return toml::parse("a = 1")["a"].value_or(0) == 1;
}
