// EXPECT: body\.cycle: the parts of this body close a loop: `arm` hangs on `[a-z]+`, which hangs on `arm`; a body is a tree or a star
// A body is a tree: here two parts each hang on the other.
#include <cca/robot/body.hpp>

struct trunk : cca::frame<"trunk"> {};
struct hand : cca::frame<"hand"> {};
struct finger : cca::frame<"finger"> {};
struct shoulder : cca::dimension<"shoulder"> {};
struct grip : cca::dimension<"grip"> {};

#if CCA_REJECT
struct arm : cca::serial_chain<finger, hand, cca::axes<shoulder>> {
#else
struct arm : cca::serial_chain<trunk, hand, cca::axes<shoulder>> {
#endif
  static constexpr std::array joints{cca::revolute(cca::along_y)};
  static constexpr auto tip = cca::at(0.3, 0, 0);
};
struct thumb : cca::serial_chain<hand, finger, cca::axes<grip>> {
  static constexpr std::array joints{cca::revolute(cca::along_z)};
  static constexpr auto tip = cca::at(0.05, 0, 0);
};

struct robot : cca::body<trunk, cca::part<"arm", arm>, cca::part<"thumb", thumb>> {};
