# Gives how every target of this project is compiled, and one function a kind of target.

add_library(billiards_options INTERFACE)
target_include_directories(billiards_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_features(billiards_options INTERFACE cxx_std_20)
# No contraction: a*b+c must round twice everywhere, or the hash of a shot differs by machine.
target_compile_options(
  billiards_options INTERFACE -ffp-contract=off -Wall -Wextra -Wconversion -Wshadow
                              $<$<BOOL:${BILLIARDS_WERROR}>:-Werror>)
if(BILLIARDS_SANITIZE)
  target_compile_options(billiards_options INTERFACE -fsanitize=${BILLIARDS_SANITIZE}
                                                     -fno-sanitize-recover=all
                                                     -fno-omit-frame-pointer)
  target_link_options(billiards_options INTERFACE -fsanitize=${BILLIARDS_SANITIZE})
endif()

# Asio, standalone and header-only; Debian ships it without a package file for CMake.
add_library(billiards_asio INTERFACE)
target_compile_definitions(billiards_asio INTERFACE ASIO_STANDALONE ASIO_NO_DEPRECATED)
# Asio 1.22 takes aligned_alloc or operator new by whether a standard header came before it, so two
# files would disagree about how one block is freed.
target_compile_definitions(billiards_asio INTERFACE ASIO_DISABLE_STD_ALIGNED_ALLOC)
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 15)
  # clang-14 has coroutines, but does not say so in the way Asio 1.22 asks.
  target_compile_definitions(
    billiards_asio INTERFACE ASIO_HAS_CO_AWAIT=1 ASIO_HAS_STD_COROUTINE=1
                             __cpp_impl_coroutine=201902L)
endif()
if(BILLIARDS_SANITIZE MATCHES "thread")
  # ThreadSanitizer does not understand fences; the mutexes around them are enough.
  target_compile_definitions(billiards_asio INTERFACE ASIO_DISABLE_FENCED_BLOCK)
endif()
target_link_libraries(billiards_asio INTERFACE Threads::Threads)

# One layer: billiards_library(physics SOURCES simulate.cpp LINKS billiards_timeline)
function(billiards_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  if(ARG_SOURCES)
    add_library(billiards_${name} STATIC ${ARG_SOURCES})
    target_link_libraries(billiards_${name} PUBLIC billiards_options ${ARG_LINKS}
                                            PRIVATE ${ARG_PRIVATE_LINKS})
  else()
    add_library(billiards_${name} INTERFACE)
    target_link_libraries(billiards_${name} INTERFACE billiards_options ${ARG_LINKS})
  endif()
endfunction()

# One program: billiards_program(billiards-sim SOURCES main.cpp LINKS billiards_physics)
function(billiards_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE billiards_options ${ARG_LINKS})
endfunction()

# One test program, each TEST in it a ctest of its own:
# billiards_test(physics SOURCES simulate_test.cpp LINKS billiards_physics)
function(billiards_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PROPERTIES" ${ARGN})
  if(NOT ARG_SOURCES)
    return()
  endif()
  add_executable(${name}_test ${ARG_SOURCES})
  target_link_libraries(${name}_test PRIVATE billiards_options ${ARG_LINKS} GTest::gtest_main)
  gtest_discover_tests(${name}_test DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT 300
                       ${ARG_PROPERTIES})
endfunction()
