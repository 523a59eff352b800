// A chain of fifty components, to which a file adds its mistake: what it is told must not drown in the names of the others.
#pragma once

#include <cca/cca.hpp>

struct signal : cca::space<cca::number, cca::axes<cca::x>> {};

struct source {
  auto process(cca::beat) -> cca::out<"y", signal> { return 1.0; }
};
struct step {
  auto process(cca::in<"x", signal> x) -> cca::out<"y", signal> { return x.vector(); }
};
struct sink {
  void process(cca::in<"x", signal>) {}
};

template <class... More>
using fifty_nodes_and = cca::graph<
    cca::node<"n0", source>, cca::node<"n1", step>, cca::node<"n2", step>, cca::node<"n3", step>, cca::node<"n4", step>,
    cca::node<"n5", step>, cca::node<"n6", step>, cca::node<"n7", step>, cca::node<"n8", step>, cca::node<"n9", step>,
    cca::node<"n10", step>, cca::node<"n11", step>, cca::node<"n12", step>, cca::node<"n13", step>, cca::node<"n14", step>,
    cca::node<"n15", step>, cca::node<"n16", step>, cca::node<"n17", step>, cca::node<"n18", step>, cca::node<"n19", step>,
    cca::node<"n20", step>, cca::node<"n21", step>, cca::node<"n22", step>, cca::node<"n23", step>, cca::node<"n24", step>,
    cca::node<"n25", step>, cca::node<"n26", step>, cca::node<"n27", step>, cca::node<"n28", step>, cca::node<"n29", step>,
    cca::node<"n30", step>, cca::node<"n31", step>, cca::node<"n32", step>, cca::node<"n33", step>, cca::node<"n34", step>,
    cca::node<"n35", step>, cca::node<"n36", step>, cca::node<"n37", step>, cca::node<"n38", step>, cca::node<"n39", step>,
    cca::node<"n40", step>, cca::node<"n41", step>, cca::node<"n42", step>, cca::node<"n43", step>, cca::node<"n44", step>,
    cca::node<"n45", step>, cca::node<"n46", step>, cca::node<"n47", step>, cca::node<"n48", step>, cca::node<"n49", sink>,
    cca::wire<"n0.y", "n1.x">, cca::wire<"n1.y", "n2.x">, cca::wire<"n2.y", "n3.x">, cca::wire<"n3.y", "n4.x">,
    cca::wire<"n4.y", "n5.x">, cca::wire<"n5.y", "n6.x">, cca::wire<"n6.y", "n7.x">, cca::wire<"n7.y", "n8.x">,
    cca::wire<"n8.y", "n9.x">, cca::wire<"n9.y", "n10.x">, cca::wire<"n10.y", "n11.x">, cca::wire<"n11.y", "n12.x">,
    cca::wire<"n12.y", "n13.x">, cca::wire<"n13.y", "n14.x">, cca::wire<"n14.y", "n15.x">, cca::wire<"n15.y", "n16.x">,
    cca::wire<"n16.y", "n17.x">, cca::wire<"n17.y", "n18.x">, cca::wire<"n18.y", "n19.x">, cca::wire<"n19.y", "n20.x">,
    cca::wire<"n20.y", "n21.x">, cca::wire<"n21.y", "n22.x">, cca::wire<"n22.y", "n23.x">, cca::wire<"n23.y", "n24.x">,
    cca::wire<"n24.y", "n25.x">, cca::wire<"n25.y", "n26.x">, cca::wire<"n26.y", "n27.x">, cca::wire<"n27.y", "n28.x">,
    cca::wire<"n28.y", "n29.x">, cca::wire<"n29.y", "n30.x">, cca::wire<"n30.y", "n31.x">, cca::wire<"n31.y", "n32.x">,
    cca::wire<"n32.y", "n33.x">, cca::wire<"n33.y", "n34.x">, cca::wire<"n34.y", "n35.x">, cca::wire<"n35.y", "n36.x">,
    cca::wire<"n36.y", "n37.x">, cca::wire<"n37.y", "n38.x">, cca::wire<"n38.y", "n39.x">, cca::wire<"n39.y", "n40.x">,
    cca::wire<"n40.y", "n41.x">, cca::wire<"n41.y", "n42.x">, cca::wire<"n42.y", "n43.x">, cca::wire<"n43.y", "n44.x">,
    cca::wire<"n44.y", "n45.x">, cca::wire<"n45.y", "n46.x">, cca::wire<"n46.y", "n47.x">, cca::wire<"n47.y", "n48.x">,
    cca::wire<"n48.y", "n49.x">,
    More...>;
