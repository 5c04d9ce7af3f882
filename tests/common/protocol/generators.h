// Gives any message, within the limits of the wire, for properties.
#pragma once

#include "common/protocol/codec_journal.h"
#include "common/protocol/messages.h"
#include "common/timeline/shot_record.h"

#include <rapidcheck.h>
#include <string>

namespace billiards::protocol {

/// Valid UTF-8 of every length of code point.
rc::Gen<std::string> any_text(std::size_t max_code_points);
rc::Gen<ClientMessage> any_client_message();
rc::Gen<ServerMessage> any_server_message();
rc::Gen<JournalEntry> any_journal_entry();
/// Any times and any numbers of 32 bits; moving as balls do, or not.
rc::Gen<timeline::ShotRecord> any_record();

}  // namespace billiards::protocol
