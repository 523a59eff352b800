// This process in a DDS domain. CYCLONEDDS_URI configures it; without that it stays on this machine:
// loopback, no multicast.
#pragma once

#include <dds/dds.h>

#include <cstdlib>
#include <mutex>
#include <string>
#include <string_view>

#include <cca/base/fixed_string.hpp>
#include <cca/dds/entity.hpp>

namespace cca::dds::detail {

inline constexpr const char* on_this_machine =
    "<CycloneDDS><Domain Id=\"any\">"
    "<General><Interfaces><NetworkInterface address=\"127.0.0.1\" multicast=\"false\"/></Interfaces>"
    "<AllowMulticast>false</AllowMulticast></General>"
    "<Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>31</"
    "MaxAutoParticipantIndex>"
    "<Peers><Peer address=\"127.0.0.1\"/></Peers></Discovery>"
    "</Domain></CycloneDDS>";

// Once for each domain of a process. The domain stays until the process ends: others may use it, too.
inline void configure(dds_domainid_t number) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  const char* const given = std::getenv("CYCLONEDDS_URI");
  if (given && *given) return;
  const dds_entity_t made = dds_create_domain(number, on_this_machine);
  if (made < 0 && made != DDS_RETCODE_PRECONDITION_NOT_MET)
    checked(made, "domain " + std::to_string(number) + " can't be set up");
}

inline identity identity_of(const dds_guid_t& guid) {
  return {guid, cca::detail::hash({reinterpret_cast<const char*>(guid.v), sizeof guid.v})};
}

class participant {
public:
  participant(std::uint32_t domain, const std::string& partition) {
    if (domain > 230)
      throw refused("cca::dds: there is no domain " + std::to_string(domain) + ": take one from 0 to 230");
    configure(domain);
    self = {dds_create_participant(domain, nullptr, nullptr),
            "no participant in domain " + std::to_string(domain) + " (CYCLONEDDS_URI configures it)"};
    const quality here = quality::of_partition(partition);
    publisher = {dds_create_publisher(self.get(), here.get(), nullptr), "no publisher"};
    subscriber = {dds_create_subscriber(self.get(), here.get(), nullptr), "no subscriber"};
    dds_guid_t guid{};
    checked(dds_get_guid(self.get(), &guid), "no identity");
    own = identity_of(guid);
  }

  dds_entity_t get() const { return self.get(); }
  dds_entity_t writes() const { return publisher.get(); }
  dds_entity_t reads() const { return subscriber.get(); }
  const identity& id() const { return own; }

private:
  entity self, publisher, subscriber;
  identity own;
};

}  // namespace cca::dds::detail
