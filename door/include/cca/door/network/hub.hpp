// All clients of a door, without a network: what their messages do, who commands, and what they are sent.
// Everything here happens in the thread of the door.
#pragma once

#include <cstdint>
#include <deque>
#include <list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/door/controls.hpp>
#include <cca/door/network/channels_functions.hpp>
#include <cca/door/network/client.hpp>
#include <cca/door/network/greeting_functions.hpp>
#include <cca/door/network/input_tests.hpp>
#include <cca/door/network/requests_functions.hpp>
#include <cca/door/network/services_functions.hpp>
#include <cca/door/network/tokens_functions.hpp>
#include <cca/door/network/twin_functions.hpp>
#include <cca/door/settings.hpp>

namespace cca::detail::door_network {

class hub {
public:
  // Reading needs the token, too, if the door is open to other machines.
  hub(const door_settings&,
      const door_limits&,
      door_controls&,
      std::string token,
      one_time_keys&,
      bool guards_reading,
      wanted_channels&,
      const kept_for_twins&);
  hub(const hub&) = delete;
  hub& operator=(const hub&) = delete;

  // A client whose greeting was right. It is valid until `leave`.
  door_client& enter(const std::string& name, const greeting& hello, time_point now);
  void leave(door_client&, time_point now);
  // The door is full: a client with the token takes the place of one without. False: there is none.
  bool makes_room(const greeting& hello);
  // Bytes have come, of whole messages or of parts. False: they are not to be read.
  bool hears(door_client&, std::size_t bytes, time_point now);
  void message(door_client&, frame_kind, std::string_view payload, time_point now);

  void channel(const recording::channel_info&);
  void sample(std::uint16_t channel, std::uint64_t time, std::string_view data) {
    tested.sample(channel, data);
    channels.show(channel, time, data);
  }
  void metadata(const std::string& name, const recording::detail::text_map& entries) {
    notes[name] = entries;
  }
  void time(std::uint64_t ns);
  void lost(std::uint64_t count);  // before they came here: told to all that have subscribed

  bool is_busy() const {
    return !requests.is_idle() || !reads.empty();
  }  // `tick` must come within a millisecond
  void tick(time_point now);
  void regularly(time_point now);  // ten times a second
  std::list<door_client>& everyone() { return clients; }

private:
  struct waiting_read {  // of parameters, while the controller is busy
    std::uint64_t client;
    bool is_description;
    std::set<std::string> names;
    json id;
    time_point since;
  };
  using values = std::vector<door_parameter>;
  using undo_step = std::vector<std::pair<std::string, door_value>>;  // the values before

  const door_settings& settings;
  const door_limits& limits;
  door_controls& controls;
  const std::string token;
  one_time_keys& keys;
  const kept_for_twins& twins;
  const bool guards_reading;
  std::list<door_client> clients{};
  shown_channels channels;
  request_queue requests;
  const std::vector<door_service> services;
  const std::string told_services;  // they, as each client is told
  const std::string session;
  std::uint64_t last_id = 0;
  door_client* commander = nullptr;
  std::set<std::string> held{};          // commands, by the commander
  std::optional<double> speed_before{};  // the commander changed it
  bool has_stepped = false;              // the commander
  input_test tested{};                   // the last one
  input_test replaced{};                 // the one before it, while that can still be refused
  std::set<std::string> driven{};  // nodes of tests that a change of their parameters has begun, or a file
  std::deque<undo_step> changes{};
  values known{};
  time_point watched{};
  std::string told_problem{};  // of the recording
  bool status_is_new = false;  // somebody has read it since the last look
  std::list<waiting_read> reads{};
  std::map<std::string, recording::detail::text_map> notes{};

  // hub_functions.hpp
  door_client* client_of(std::uint64_t id);
  void welcome(door_client&);
  void text(door_client&, std::string_view, time_point now);
  void binary(door_client&, std::string_view, time_point now);
  void fetch_asset(door_client&, const json&);
  void tell_of_twin(door_client&, std::string says);
  void refuse_flood(door_client&);
  void read_parameters(door_client&, const json&, bool is_description, time_point now);
  bool read_now(const waiting_read&, time_point now);
  void subscribe_parameters(door_client&, const json&, bool is_more);
  void tell_changed(const values& now);
  void tell_problem_of_recording();

  // rights_functions.hpp
  std::string commander_name() const { return commander ? commander->name : std::string(); }
  void show_token(door_client&, const std::string& offered);
  void tell_rights(door_client&);
  void tell_rights();
  std::string take_command(door_client&);  // empty, or why not
  void give_command(door_client&, time_point now);
  void lose_command(const std::string& client, time_point now);
  void release(const std::string& command, time_point now);
  void set_speed_back(double to, time_point now);
  std::string why_not(const door_client&, bool needs_command) const;
  void log(const std::string& client, const std::string& what, bool is_change);

  // changes_functions.hpp
  void set_parameters(door_client&, const json&, time_point now);
  void call(door_client&, const service_call&, time_point now);
  void request(door_client&, const service_call&, const door_service&, const json&, time_point now);
  void undo(door_client&, const service_call&, time_point now);
  void answer(std::uint64_t client, const service_call&, const door_outcome&);
  void end(door_task&, const door_outcome&, const values* before, const values* after, bool is_late);
  void remember(const values& before, const values& after, bool is_undo);

  // input_tests_functions.hpp
  void begin_test(door_client&, const service_call&, const json&, time_point now);
  void end_test(door_client&, const service_call&, time_point now);
  void cut_test(time_point now, const std::string& by = {});
  void switch_test_off(const std::string& node, time_point now);
  std::vector<std::string> tests_begun(const values& before, const values& after);
  void tell_response(door_client&, const service_call&);
};

}  // namespace cca::detail::door_network
