# cca::same_bits: what a program is compiled with, so that it computes the same bits with each compiler and on each machine
# (docs/same_bits.md). The option CCA_SAME_BITS gives it to all that links cca, what is compiled once included; an installed cca
# reads it before find_package(cca).

option(CCA_SAME_BITS "compile so that a program has the same bits with each compiler and on each machine" OFF)

set(cca_same_bits_definitions CCA_SAME_BITS EIGEN_DONT_VECTORIZE)
set(cca_same_bits_options -ffp-contract=off)
# g++ 12 fuses alternating products and sums in spite of that, where the machine can. AVX-512 has fused instructions of its own.
set(cca_same_bits_options_gnu "")
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|i.86)$")
  set(cca_same_bits_options_gnu -mno-fma -mno-fma4 -mno-avx512f)
endif()
if(NOT TARGET cca::same_bits)
  add_library(cca::same_bits INTERFACE IMPORTED GLOBAL)
  target_compile_definitions(cca::same_bits INTERFACE ${cca_same_bits_definitions})
  target_compile_options(cca::same_bits INTERFACE ${cca_same_bits_options} "$<$<CXX_COMPILER_ID:GNU>:${cca_same_bits_options_gnu}>")
endif()

# cca_same_bits_for(<target of the core>): with the option, who links it gets cca::same_bits, too.
function(cca_same_bits_for target)
  if(CCA_SAME_BITS)
    target_link_libraries(${target} INTERFACE $<BUILD_INTERFACE:cca::same_bits>)
  endif()
endfunction()
