# Debian's clang 19 for WebAssembly, with wasi-libc and libc++. Its emscripten (3.1.6, clang 14) can't compile the headers.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_CXX_COMPILER_WORKS TRUE)  # a test program would need an archiver
