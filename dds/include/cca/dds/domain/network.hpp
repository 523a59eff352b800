// How a process reaches others over DDS.
//
//   cca::dds::domain(7)   // as CYCLONEDDS_URI says, else this machine
//   cca::dds::domain(7, cca::dds::network::between("192.168.1.10", {"192.168.1.11"}))
//   cca::dds::domain(7, cca::dds::network::between("192.168.1.10", {"192.168.1.11"}).that_loses())
//
// `between(own, others)`: over the interface with this address, to these machines, without multicast. It is
// not used if CYCLONEDDS_URI is set: that says how the network is where the program runs.
//
// `that_loses()`: a network that loses a message in a hundred or more, as wireless ones do. With Cyclone's
// defaults a lost message comes about 24 ms late, with this about a millisecond and a way there and back. It
// costs more heartbeats and answers: one of each a millisecond for a message that nobody has confirmed yet.
// It is added to what CYCLONEDDS_URI says.
//
// A process configures a domain once. Errors: cca::refused, if it has configured it otherwise before, and if
// an address is no address. Page: docs/two_machines.md, with the figures.
#pragma once

#include <dds/dds.h>

#include <cstdlib>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/dds/domain/entity.hpp>

namespace cca::dds {

class network {
public:
  network() = default;

  static network between(std::string own, std::vector<std::string> others) {
    network n;
    others.push_back(own);  // other processes of this machine
    for (const std::string& one : others)
      if (one.empty() || one.find_first_not_of("0123456789abcdefABCDEF.:") != one.npos)
        throw refused("cca::dds: `" + one + "` is no address: expected one as 192.168.1.10");
    n.own_address = std::move(own);
    n.all_addresses = std::move(others);
    return n;
  }
  network that_loses() const {
    network n = *this;
    n.loses = true;
    return n;
  }

  // Cyclone's configuration: texts of XML and names of files, with commas between them. Empty: Cyclone's own.
  std::string configuration() const {
    const char* const given = std::getenv("CYCLONEDDS_URI");
    std::string all = given && *given ? given : addressed();
    if (given && *given && !loses) return {};  // Cyclone reads the variable itself
    if (loses) all.append(",").append(for_loss);
    return all;
  }

private:
  // The interface, and where to look for others: Cyclone tries 32 ports at each address.
  std::string addressed() const {
    const std::string own = own_address.empty() ? "127.0.0.1" : own_address;
    std::string peers;
    for (const std::string& one : all_addresses) peers += "<Peer address=\"" + one + "\"/>";
    if (peers.empty()) peers = "<Peer address=\"127.0.0.1\"/>";
    return "<CycloneDDS><Domain Id=\"any\"><General><Interfaces><NetworkInterface address=\"" + own +
           "\" multicast=\"false\"/></Interfaces><AllowMulticast>false</AllowMulticast></General><Discovery>"
           "<ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>31</MaxAutoParticipantIndex>"
           "<Peers>" +
           peers + "</Peers></Discovery></Domain></CycloneDDS>";
  }
  static constexpr const char* for_loss =
      "<CycloneDDS><Domain Id=\"any\"><Internal><HeartbeatInterval min=\"1 ms\" minsched=\"1 ms\" max=\"1 "
      "s\">"
      "1 ms</HeartbeatInterval><NackDelay>0 ms</NackDelay><AckDelay>1 ms</AckDelay><PreEmptiveAckDelay>1 ms"
      "</PreEmptiveAckDelay></Internal></Domain></CycloneDDS>";

  std::string own_address;
  std::vector<std::string> all_addresses;
  bool loses = false;
};

namespace detail {

// Once for each domain of a process. The domain stays until the process ends: others may use it, too.
inline void configure(dds_domainid_t number, const network& by) {
  static std::mutex one_at_a_time;
  static std::map<dds_domainid_t, std::string> known;
  const std::lock_guard lock(one_at_a_time);
  const std::string wanted = by.configuration();
  const auto [before, is_first] = known.emplace(number, wanted);
  if (!is_first && before->second != wanted && wanted != network().configuration())
    throw refused("cca::dds: domain " + std::to_string(number) +
                  " has another network in this process already: name the network where the domain is first "
                  "used, or take a domain of its own");
  if (!is_first || wanted.empty()) return;
  const dds_entity_t made = dds_create_domain(number, wanted.c_str());
  if (made < 0 && made != DDS_RETCODE_PRECONDITION_NOT_MET)
    checked(made, "domain " + std::to_string(number) + " can't be set up");
}

}  // namespace detail
}  // namespace cca::dds
