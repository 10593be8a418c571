# One interface target, emulsion_settings, carries the language level, warnings and sanitizers of every target;
# emulsion_settings_unsanitized those of programs that make sources during the build.

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
set(CMAKE_CXX_EXTENSIONS OFF)

add_library(emulsion_settings_unsanitized INTERFACE)
add_library(emulsion_settings INTERFACE)
target_link_libraries(emulsion_settings INTERFACE emulsion_settings_unsanitized)
target_compile_features(emulsion_settings_unsanitized INTERFACE cxx_std_20)

# Contraction to fused multiply-adds would let results depend on the instruction set.
target_compile_options(emulsion_settings_unsanitized INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -ffp-contract=off
  $<$<BOOL:${EMULSION_WARNINGS_AS_ERRORS}>:-Werror>)

# GCC 12 takes "text" + std::string(...) for overlapping memory (its bug 105651); GCC 13 does no more.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(emulsion_settings_unsanitized INTERFACE -Wno-restrict)
endif()

# Releases run on any x86-64-v2 machine (SSE4.2); wider vectors are chosen at run time.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  target_compile_options(emulsion_settings_unsanitized INTERFACE -march=x86-64-v2)
endif()

if(EMULSION_SANITIZE)
  target_compile_options(emulsion_settings INTERFACE
    -fsanitize=${EMULSION_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(emulsion_settings INTERFACE -fsanitize=${EMULSION_SANITIZE})
endif()

# The environment of every test: one variable, as gtest_discover_tests splits lists.
set(EMULSION_TEST_ENVIRONMENT UBSAN_OPTIONS=print_stacktrace=1)
if(EMULSION_SANITIZE MATCHES thread)
  set(EMULSION_TEST_ENVIRONMENT TSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/tests/tsan.supp:halt_on_error=1)
endif()
