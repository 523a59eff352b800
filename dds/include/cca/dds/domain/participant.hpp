// This process in a DDS domain. Without CYCLONEDDS_URI or another network it stays on this machine: loopback,
// no multicast.
#pragma once

#include <dds/dds.h>

#include <cstdint>
#include <string>

#include <cca/base/fixed_string.hpp>
#include <cca/dds/domain/entity.hpp>
#include <cca/dds/domain/network.hpp>

namespace cca::dds::detail {

inline identity identity_of(const dds_guid_t& guid) {
  return {guid, cca::detail::hash({reinterpret_cast<const char*>(guid.v), sizeof guid.v})};
}

class participant {
public:
  participant(std::uint32_t domain, const std::string& partition, const network& by = {}) {
    if (domain > 230)
      throw refused("cca::dds: there is no domain " + std::to_string(domain) + ": take one from 0 to 230");
    configure(domain, by);
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
