# SPDX-License-Identifier: MIT
# Flags of this build's own programs. They are private: no user of bolide::bolide inherits a warning or an optimisation flag.
set(CMAKE_CXX_EXTENSIONS OFF)

add_library(bolide_warnings INTERFACE)
target_compile_options(bolide_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
  -Wno-psabi # packs wider than the machine's registers are always inlined: how they would be passed does not matter
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> # g++ 12 suspects the operator+ of std::string
  $<$<BOOL:${BOLIDE_WERROR}>:-Werror>)

# What makes the per-particle loops vectorise without giving up NaN, infinity or the order of sums (no -ffast-math here or anywhere).
add_library(bolide_release INTERFACE)
target_compile_options(bolide_release INTERFACE
  $<$<NOT:$<CONFIG:Debug>>:-O3>
  $<$<BOOL:${BOLIDE_NATIVE}>:-march=native>
  -fno-math-errno -fno-trapping-math)

if(BOLIDE_SANITIZE AND bolide_top_level)
  # What the address sanitizer and the processor find without help is not asked for twice: a third of the compile time.
  add_compile_options(-fsanitize=address,undefined -fno-sanitize=null,alignment,object-size -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()
