// Cyclone DDS's handles as objects that delete what they own.
#pragma once

#include <dds/dds.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include <cca/base/refused.hpp>

namespace cca::dds::detail {

// What DDS refuses while a process opens its transport. Never in a beat.
inline dds_entity_t checked(dds_entity_t result, const std::string& what) {
  if (result < 0) throw refused("cca::dds: " + what + ": " + dds_strretcode(-result));
  return result;
}

class entity {
public:
  entity() = default;
  entity(dds_entity_t made, const std::string& what) : handle(checked(made, what)) {}
  entity(entity&& other) noexcept : handle(std::exchange(other.handle, 0)) {}
  entity& operator=(entity&& other) noexcept {
    std::swap(handle, other.handle);
    return *this;
  }
  ~entity() {
    if (handle > 0) dds_delete(handle);
  }
  entity(const entity&) = delete;
  entity& operator=(const entity&) = delete;

  dds_entity_t get() const { return handle; }

private:
  dds_entity_t handle = 0;
};

class quality {
public:
  // Reliable. The newest `depth` samples wait for readers, also for those that come later. Nothing is kept
  // beyond these, so a reader that is slow, stopped or dead costs its writer neither time nor memory.
  static quality of_writer(std::int32_t depth) {
    quality q = reliable();
    dds_qset_history(q.own.get(), DDS_HISTORY_KEEP_LAST, depth);
    dds_qset_durability_service(q.own.get(), 0, DDS_HISTORY_KEEP_LAST, depth, DDS_LENGTH_UNLIMITED,
                                DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
    return q;
  }
  // A reader keeps what it has not taken yet, but not more than this: if it kept the newest of all writers,
  // a stranger could displace what the right one has sent.
  static quality of_reader(std::int32_t most) {
    quality q = reliable();
    dds_qset_history(q.own.get(), DDS_HISTORY_KEEP_ALL, 0);
    dds_qset_resource_limits(q.own.get(), most, DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
    return q;
  }
  static quality of_partition(const std::string& name) {
    quality q;
    const char* names[] = {name.c_str()};
    dds_qset_partition(q.own.get(), 1, names);
    return q;
  }
  const dds_qos_t* get() const { return own.get(); }

private:
  quality() : own(dds_create_qos(), &dds_delete_qos) {}
  static quality reliable() {
    quality q;
    dds_qset_reliability(q.own.get(), DDS_RELIABILITY_RELIABLE, DDS_MSECS(20));
    dds_qset_durability(q.own.get(), DDS_DURABILITY_TRANSIENT_LOCAL);
    const dds_data_representation_id_t plain[] = {DDS_DATA_REPRESENTATION_XCDR1};
    dds_qset_data_representation(q.own.get(), 1, plain);
    return q;
  }

  std::unique_ptr<dds_qos_t, void (*)(dds_qos_t*)> own;
};

// Of a participant: the first numbers of all its endpoints.
struct identity {
  dds_guid_t guid{};
  std::uint64_t token = 0;  // a hash of it; 0: none

  friend bool operator==(const identity& a, const identity& b) { return a.token == b.token; }
};

}  // namespace cca::dds::detail
