// Which network a process uses, and what it tells Cyclone.
#include <doctest/doctest.h>

#include <cstdlib>
#include <string>

#include <cca/dds/domain/participant.hpp>

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

}  // namespace

TEST_SUITE("network") {
  TEST_CASE("this machine, others, and one that loses") {
    ::unsetenv("CYCLONEDDS_URI");
    const std::string here = cca::dds::network().configuration();
    CHECK(has(here, "<NetworkInterface address=\"127.0.0.1\""));
    CHECK(has(here, "<Peers><Peer address=\"127.0.0.1\"/></Peers>"));

    const auto between = cca::dds::network::between("10.0.0.1", {"10.0.0.2", "10.0.0.3"});
    const std::string others = between.configuration();
    CHECK(has(others, "<NetworkInterface address=\"10.0.0.1\""));
    CHECK(
        has(others, "<Peer address=\"10.0.0.2\"/><Peer address=\"10.0.0.3\"/><Peer address=\"10.0.0.1\"/>"));
    CHECK_FALSE(has(others, "HeartbeatInterval"));
    CHECK_EQ(between.that_loses().configuration().substr(0, others.size()), others);
    CHECK(has(between.that_loses().configuration(), "HeartbeatInterval"));
  }

  TEST_CASE("CYCLONEDDS_URI says how the network is where the program runs") {
    ::setenv("CYCLONEDDS_URI", "file:///etc/robot.xml", 1);
    const auto between = cca::dds::network::between("10.0.0.1", {"10.0.0.2"});
    CHECK_EQ(between.configuration(), "");  // Cyclone reads it itself
    CHECK(between.that_loses().configuration().starts_with("file:///etc/robot.xml,<CycloneDDS>"));
    ::unsetenv("CYCLONEDDS_URI");
  }

  TEST_CASE("what is no address is refused") {
    CHECK_THROWS_WITH_AS((void)cca::dds::network::between("", {"10.0.0.2"}),
                         "cca::dds: `` is no address: expected one as 192.168.1.10", cca::refused);
    CHECK_THROWS_WITH_AS((void)cca::dds::network::between("10.0.0.1", {"robot\"/>"}),
                         "cca::dds: `robot\"/>` is no address: expected one as 192.168.1.10", cca::refused);
  }

  TEST_CASE("a domain has one network in a process, and Cyclone understands it") {
    ::unsetenv("CYCLONEDDS_URI");
    const auto here = cca::dds::network::between("127.0.0.1", {}).that_loses();
    const cca::dds::detail::participant first(90, "cca_test", here), again(90, "cca_test", here);
    const cca::dds::detail::participant as_it_is(90, "cca_test");  // takes the one that is there
    CHECK_THROWS_AS(
        cca::dds::detail::participant(90, "cca_test", cca::dds::network::between("127.0.0.1", {"10.0.0.2"})),
        cca::refused);
  }
}
