// EXPECT: deployment\.no_transport: the second argument of cca::deployed<split>, `char ?\[6\]`, is no transport: write cca::shared_memory\(`/name`\), cca::dds::domain\(number\), or an object that meets the concept cca::Transport \(docs/transports\.md: An own transport\)
// Where other processes run environments, `cca::deployed` needs a transport to reach them. A name or a number
// is none.
#include "two_places.hpp"

struct split : cca::deployment<walk,
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
                               cca::environment<"log", cca::other_nodes>> {};

cca::deployed<split> d(cca::only{"control"},
#if CCA_REJECT
                       "/walk"
#else
                       cca::shared_memory("/walk")
#endif
);
