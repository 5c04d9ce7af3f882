// Gives one message of each kind, each field with a value of its own, under the name by which its
// recorded bytes are kept.
#pragma once

#include "common/protocol/codec_journal.h"
#include "common/protocol/messages.h"
#include "common/timeline/shot_record.h"

#include <span>
#include <string>
#include <vector>

namespace billiards::protocol {

template <class T>
struct Sample {
    std::string name;
    T value;
};

std::vector<Sample<ClientMessage>> client_samples();
std::vector<Sample<ServerMessage>> server_samples();
std::vector<Sample<JournalEntry>> journal_samples();
StoredSettings sample_settings();

/// Has an event of each kind and a segment of each form, all numbers exact in 32 bits.
timeline::ShotRecord sample_record();

/// What follows the length header.
std::span<const std::byte> content_of(const SharedFrame& frame);

}  // namespace billiards::protocol
