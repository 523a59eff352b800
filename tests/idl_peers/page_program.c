// The program of docs/dds.md, in C. It shares no code with cca: spaces.h is what Cyclone's idlc makes of the types
// that cca::idl writes.
// [program]
#include <dds/dds.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "spaces.h"  // made by idlc

// The network of cca's programs where CYCLONEDDS_URI is not set: this machine.
static const char* const this_machine =
    "<Domain><General><Interfaces><NetworkInterface address='127.0.0.1' multicast='false'/></Interfaces>"
    "<AllowMulticast>false</AllowMulticast></General><Discovery><ParticipantIndex>auto</ParticipantIndex>"
    "<MaxAutoParticipantIndex>31</MaxAutoParticipantIndex><Peers><Peer address='127.0.0.1'/></Peers>"
    "</Discovery></Domain>";

int main(int count, char** words) {
  const dds_domainid_t domain = count > 1 ? (dds_domainid_t)atoi(words[1]) : 0;  // the parameter of the nodes
  if (!getenv("CYCLONEDDS_URI")) dds_create_domain(domain, this_machine);
  const dds_entity_t here = dds_create_participant(domain, NULL, NULL);
  const dds_entity_t state = dds_create_topic(here, &cca_talk_leg_angles_sample_desc, "talk/leg_angles", NULL, NULL);
  const dds_entity_t wish = dds_create_topic(here, &cca_talk_leg_angles_sample_desc, "cca/said", NULL, NULL);
  dds_qos_t* const reliable = dds_create_qos();
  dds_qset_reliability(reliable, DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
  const dds_entity_t reader = dds_create_reader(here, state, reliable, NULL);
  const dds_entity_t writer = dds_create_writer(here, wish, reliable, NULL);
  if (reader < 0 || writer < 0) return 1;

  for (int k = 0; k < 1000; ++k) {  // 50 times a second
    cca_talk_leg_angles_sample heard;
    void* into = &heard;
    dds_sample_info_t about;
    while (dds_take(reader, &into, &about, 1, 1) > 0)
      if (about.valid_data && heard.space == cca_talk_leg_angles_space)
        printf("hip %.2f, knee %.2f, %.0f ms old\n", heard.hip_, heard.knee_, 1e-6 * (double)heard.age);
    const cca_talk_leg_angles_sample asked = {cca_talk_leg_angles_space, 0, 0.25 * sin(0.1 * k), -0.5};
    dds_write(writer, &asked);
    fflush(stdout);
    dds_sleepfor(DDS_MSECS(20));
  }
  return dds_delete(here) < 0;
}
// [program end]
