// Gives every limit of the wire: its name and its default.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace billiards::protocol {

inline constexpr std::uint16_t kVersionMajor = 1;
inline constexpr std::uint16_t kVersionMinor = 1;
inline constexpr std::uint16_t kDefaultPort = 4747;

inline constexpr std::size_t kFrameHeaderBytes = 4;
inline constexpr std::size_t kMaxGreetingFrameBytes = 512;
inline constexpr std::size_t kMaxClientFrameBytes = 8 * 1024;
inline constexpr std::size_t kMaxServerFrameBytes = 1024 * 1024;
/// Of the record in a shot: what else a frame of a shot holds is far below the rest.
inline constexpr std::size_t kMaxRecordBytes = kMaxServerFrameBytes - 64 * 1024;
inline constexpr int kTraversalFactor = 4;  ///< Times the frame's words.
inline constexpr int kMaxNesting = 8;

inline constexpr std::size_t kMaxNameLength = 24;  ///< Code points, before the discriminator.
/// A shown name: with its discriminator.
inline constexpr std::size_t kMaxShownNameLength = kMaxNameLength + 8;
inline constexpr std::size_t kMaxTableNameLength = 40;      ///< Code points.
inline constexpr std::size_t kMaxChatLength = 200;          ///< Code points.
inline constexpr std::size_t kMaxDetailLength = 300;        ///< Bytes.
inline constexpr std::size_t kMaxTableRows = 1000;          ///< Of one TableList.
inline constexpr std::size_t kMaxPasscodeLength = 32;       ///< Code points.
inline constexpr std::size_t kMaxHistoryRows = 50;          ///< Of one HistoryPage.
inline constexpr std::size_t kMaxReplaySteps = 64;          ///< Of one ReplayChunk.
inline constexpr std::size_t kMaxReplayBytes = 512 * 1024;  ///< Likewise, unless it is one step.
inline constexpr std::size_t kMaxEventsInRecord = 20'000;
inline constexpr std::size_t kMaxSegmentsInRecord = 40'000;
inline constexpr double kMaxShotDuration_s = 3600.0;
inline constexpr double kMaxMagnitude = 1e6;  ///< Of any number of a segment or a layout.
inline constexpr double kMinBallRadius_m = 0.001;
inline constexpr double kMaxBallRadius_m = 1.0;
inline constexpr std::uint32_t kMaxCount = 1'000'000;  ///< Of racks, shots and fouls.

inline constexpr std::chrono::seconds kGreetingTimeout{5};
inline constexpr std::chrono::seconds kIdleTimeout{60};

}  // namespace billiards::protocol
