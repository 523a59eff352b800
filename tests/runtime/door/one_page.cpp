// A file of a program that does not know where the page of cca is gets the same answer as one that does: what
// is compiled once has it.
#undef CCA_RECORDING_PAGE

#include <doctest/doctest.h>

#include <cca/door/settings.hpp>

TEST_CASE("A file without the definition of cca::record has the same page for its doors") {
  CHECK(cca::door_settings{}.page.ends_with("/page/recording.html"));
}
