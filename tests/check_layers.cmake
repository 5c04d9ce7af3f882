# Takes ROOT, a tree of sources; fails on every #include, and every reading of a clock, that
# docs/architecture.md does not allow: link lists alone cannot, because one include root lets
# anyone include anything.
#   cmake -DROOT=. -P tests/check_layers.cmake

cmake_minimum_required(VERSION 3.25)

# room: the folders whose headers its files may include. The most special room counts.
set(rooms
    "common/base: common/base"
    "common/model: common/base common/model"
    "common/timeline: common/base common/model common/timeline"
    "common/physics: common/base common/model common/timeline common/physics"
    "common/rules: common/base common/model common/rules"
    "common/match: common/base common/model common/timeline common/physics common/rules common/match"
    "common/bot: common/base common/model common/timeline common/physics common/rules common/match common/bot"
    "common/protocol: common/base common/model common/timeline common/physics common/rules common/match common/protocol"
    "common/replay: common/base common/model common/timeline common/physics common/rules common/match common/protocol common/replay"
    "server: common server"
    "server/table: common server/table server/store/committer.h server/store/match_store.h server/session/limits.h server/session/rate_limit.h server/session/token.h"
    "client: common client"
    "client/app: common client/app"
    "client/local: common client/local client/net/address.h server"
    "client/playback: common client/app client/playback"
    "client/net: common client/app client/net"
    "client/scene: common client/app client/playback client/scene"
    "client/input: common client/input"
    "client/render: common client/render client/scene"
    "client/ui: common client/app client/input client/local client/play client/playback client/scene client/ui"
    "client/play: common client/app client/input client/net client/playback client/play"
    "tools: common client server tools")

# pattern in angle brackets: the only places that may include it.
set(libraries
    "^asio: server/net server/ops server/store/threaded_committer server/store/threaded_archive server/game_loop server/server server/main client/net tools/load tools/player tools/demo"
    "^(SQLiteCpp|sqlite3): server/store"
    "^(capnp|kj)/: common/protocol/codec"
    "^openssl/: server/session"
    "^utf8proc: common/protocol/text"
    "^zstd: common/protocol/packing"
    "^prometheus/: server/ops"
    "^spdlog: server client/local"
    "^fmt: common/match common/protocol common/replay server client tools"
    "^nlohmann/: server/ops client tools"
    "^CLI/: server/config client/main tools"
    "^(SDL|epoxy|imgui|backends/): client/render client/ui client/audio client/main client/window_app"
    "^(thread|mutex|condition_variable): server/net server/store server/server server/main client/net tools")

# Whoever else needs the time or a random number takes it as an argument.
set(clock_rooms server/net server/store server/game_loop server/server server/main client/net
    client/main tools)

file(REAL_PATH "${ROOT}" ROOT)  # The globs below give no relative names for a relative root.
set(failures 0)

function(complain text)
  message(NOTICE "${text}")
  math(EXPR failures "${failures} + 1")
  set(failures ${failures} PARENT_SCOPE)
endfunction()

# The folders that `file` may include, into `result`; empty: no rule.
function(allowed_for file result)
  set(best "")
  set(allowed "")
  foreach(room IN LISTS rooms)
    string(REGEX MATCH "^([^:]+): (.*)$" _ "${room}")
    set(folder "${CMAKE_MATCH_1}")
    set(list "${CMAKE_MATCH_2}")
    string(FIND "${file}" "${folder}/" at)
    string(LENGTH "${folder}" length)
    string(LENGTH "${best}" best_length)
    if(at EQUAL 0 AND length GREATER best_length)
      set(best "${folder}")
      set(allowed "${list}")
    endif()
  endforeach()
  string(REPLACE " " ";" allowed "${allowed}")
  set(${result} "${allowed}" PARENT_SCOPE)
endfunction()

function(starts_with_one_of text prefixes result)
  set(${result} FALSE PARENT_SCOPE)
  foreach(prefix IN LISTS prefixes)
    string(FIND "${text}" "${prefix}" at)
    if(at EQUAL 0)
      set(${result} TRUE PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

file(GLOB_RECURSE sources RELATIVE "${ROOT}" "${ROOT}/common/*.h" "${ROOT}/common/*.cpp"
     "${ROOT}/server/*.h" "${ROOT}/server/*.cpp" "${ROOT}/client/*.h" "${ROOT}/client/*.cpp"
     "${ROOT}/tools/*.h" "${ROOT}/tools/*.cpp")
list(LENGTH sources count)
if(count EQUAL 0)
  message(FATAL_ERROR "no sources under ROOT=${ROOT}")
endif()

foreach(file IN LISTS sources)
  allowed_for("${file}" allowed)
  if(NOT allowed)
    complain("${file}: no room of docs/architecture.md holds this file")
  endif()

  file(STRINGS "${ROOT}/${file}" ours REGEX "^#include \"")
  foreach(line IN LISTS ours)
    string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" header "${line}")
    if(header MATCHES "\\.capnp\\.h$")
      if(NOT file MATCHES "^common/protocol/codec[a-z_]*\\.(cpp|h)$")
        complain("${file}: generated code (${header}) is for common/protocol/codec* only")
      endif()
    else()
      starts_with_one_of("${header}" "${allowed}" is_allowed)
      if(NOT is_allowed)
        complain("${file}: may not include \"${header}\"")
      endif()
    endif()
  endforeach()

  file(STRINGS "${ROOT}/${file}" theirs REGEX "^#include <")
  foreach(line IN LISTS theirs)
    string(REGEX REPLACE "^#include <([^>]+)>.*" "\\1" header "${line}")
    foreach(library IN LISTS libraries)
      string(REGEX MATCH "^(.+): (.*)$" _ "${library}")
      set(pattern "${CMAKE_MATCH_1}")
      string(REPLACE " " ";" places "${CMAKE_MATCH_2}")
      if(header MATCHES "${pattern}")
        starts_with_one_of("${file}" "${places}" is_allowed)
        if(NOT is_allowed)
          complain("${file}: may not include <${header}>")
        endif()
      endif()
    endforeach()
  endforeach()

  file(STRINGS "${ROOT}/${file}" clocks REGEX "[Cc]lock::now|random_device|getentropy|gettimeofday|std::rand")
  starts_with_one_of("${file}" "${clock_rooms}" may_read_clocks)
  if(clocks AND NOT may_read_clocks)
    complain("${file}: reads a clock or draws randomness; take it as an argument")
  endif()
endforeach()

if(failures GREATER 0)
  message(FATAL_ERROR "${failures} forbidden arrows")
endif()
message(STATUS "${count} files keep to the layers")
