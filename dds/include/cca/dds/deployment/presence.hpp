// Which processes are in the domain, what they run, and whether it is the same deployment. Each says it once,
// and DDS keeps it for those that come later.
//
// A process that finds another deployment, or one of its own environments in another process, stops if the
// other process was first. A process settles when it has looked for others and found no reason to go. The one
// that settled first stays; before that the one with the lower token. So both come to the same decision.
#pragma once

#include <dds/dds.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <cca/base/fixed_string.hpp>
#include <cca/dds/domain/channel.hpp>
#include <cca/dds/deployment/refusals.hpp>
#include <cca/runtime/transports/manifest.hpp>

namespace cca::dds::detail {

struct presence_message {
  std::uint64_t settled_at = 0;  // system clock, ns; 0: it still looks for others
  std::uint64_t claims = 0;      // a bit for each environment that it runs
  std::uint64_t process = 0;
  char* host = nullptr;
  char* manifest = nullptr;

  static constexpr std::uint32_t number = op(DDS_OP_ADR, DDS_OP_TYPE_8BY),
                                 text = op(DDS_OP_ADR, DDS_OP_TYPE_STR);
  static constexpr std::array<std::uint32_t, 11> ops{number, 0,  number, 8,  number,    16,
                                                     text,   24, text,   32, DDS_OP_RTS};
};
static_assert(offsetof(presence_message, manifest) == 32);

inline constexpr dds_topic_descriptor_t presence_descriptor{.m_size = sizeof(presence_message),
                                                            .m_align = 8,
                                                            .m_flagset = 0,
                                                            .m_nkeys = 0,
                                                            .m_typename = "cca::presence_1",
                                                            .m_keys = nullptr,
                                                            .m_nops = 5,
                                                            .m_ops = presence_message::ops.data(),
                                                            .m_meta = "",
                                                            .type_information = {},
                                                            .type_mapping = {},
                                                            .restrict_data_representation = 0};

// Another process.
struct peer {
  identity id;
  std::uint64_t claims = 0;
  std::uint64_t settled_at = 0;
  bool is_refused = false;  // another deployment, or it has lied
  std::string name;
};

// Which of two processes has the better right.
inline bool is_before(const peer& a, const peer& b) {
  const bool a_waits = a.settled_at == 0, b_waits = b.settled_at == 0;
  if (a_waits != b_waits) return b_waits;
  return a.settled_at != b.settled_at ? a.settled_at < b.settled_at : a.id.token < b.id.token;
}

class presence {
public:
  presence(const participant& in, std::uint64_t claims, std::string manifest_text)
      : self(in.id()),
        own_claims(claims),
        manifest(std::move(manifest_text)),
        topic(dds_create_topic(in.get(), &presence_descriptor, "cca/presence", nullptr, nullptr),
              "topic of presence"),
        writer(dds_create_writer(in.writes(), topic.get(), quality::of_writer(1).get(), nullptr),
               "writer of presence"),
        reader(dds_create_reader(in.reads(), topic.get(), quality::of_reader(most).get(), nullptr),
               "reader of presence"),
        from(reader.get()) {
    ::gethostname(host.data(), host.size() - 1);
    announce(0);
  }

  dds_entity_t reads() const { return reader.get(); }
  const std::vector<peer>& peers() const { return all; }
  peer* find(const identity& of) {
    const auto found = std::ranges::find(all, of, &peer::id);
    return found == all.end() ? nullptr : &*found;
  }

  // No other process was here first: this one stays.
  void settle() {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    announce(static_cast<std::uint64_t>(std::chrono::nanoseconds(now).count()));
  }

  // Reads what others say. Empty, or why this process has to go.
  std::string look(refusals& refused, std::string_view (*name_of)(int)) {
    std::string complaint;
    for (;;) {
      void* one[1] = {nullptr};
      dds_sample_info_t about;
      const int count = dds_take(reader.get(), one, &about, 1, 1);
      if (count <= 0) break;
      if (about.valid_data) {
        const identity id = from.of(about.publication_handle);
        if (id.token != 0 && !(id == self))
          meet(id, *static_cast<const presence_message*>(one[0]), refused, name_of, complaint);
      }
      dds_return_loan(reader.get(), one, count);
    }
    return complaint;
  }

  // Forgets those whose writers DDS has lost.
  void forget_the_lost() {
    std::array<dds_instance_handle_t, most> handles;
    const int count = dds_get_matched_publications(reader.get(), handles.data(), handles.size());
    if (count < 0 || count > static_cast<int>(most)) return;
    std::erase_if(all, [&](const peer& p) {
      return std::none_of(handles.begin(), handles.begin() + count,
                          [&](dds_instance_handle_t h) { return from.of(h) == p.id; });
    });
  }

private:
  static constexpr std::size_t most = 64, longest = 1 << 20;

  void announce(std::uint64_t at) {
    settled_at = at;
    presence_message message{at, own_claims, static_cast<std::uint64_t>(::getpid()), host.data(),
                             manifest.data()};
    checked(dds_write(writer.get(), &message), "presence can't be told");
  }

  void meet(const identity& id,
            const presence_message& message,
            refusals& refused,
            std::string_view (*name_of)(int),
            std::string& complaint) {
    peer* known = find(id);
    if (!known) {
      if (all.size() == most)
        return refused.add("participant " + std::to_string(id.token), "too many processes");
      known = &all.emplace_back();
    }
    const std::string_view theirs(message.manifest ? message.manifest : "",
                                  message.manifest ? ::strnlen(message.manifest, longest) : 0);
    const std::string_view at(message.host ? message.host : "",
                              message.host ? ::strnlen(message.host, 64) : 0);
    known->id = id;
    known->claims = message.claims;
    known->settled_at = message.settled_at;
    known->name = "process " + std::to_string(message.process) + " on " + printable(at) + " (participant " +
                  std::to_string(id.token) + ")";

    std::string why;
    if (theirs != manifest)
      why = "the other process runs another deployment; " + cca::detail::first_difference(manifest, theirs);
    else if (const std::uint64_t both = known->claims & own_claims)
      why = "another process runs environment `" + std::string(name_of(std::countr_zero(both))) + "` already";
    known->is_refused = known->is_refused || theirs != manifest;
    if (why.empty()) return;
    const bool gives_way = is_before(*known, peer{self, 0, settled_at, false, {}});
    if (gives_way) complaint = why + ": " + known->name;
    else refused.add(known->name, why);
  }
  static std::string printable(std::string_view text) {
    std::string all(text);
    for (char& c : all)
      if (static_cast<unsigned char>(c) < ' ') c = '?';
    return all;
  }

  identity self;
  std::uint64_t own_claims;
  std::uint64_t settled_at = 0;
  std::string manifest;
  std::array<char, 65> host{};
  entity topic, writer, reader;
  sources from;
  std::vector<peer> all;
};

}  // namespace cca::dds::detail
