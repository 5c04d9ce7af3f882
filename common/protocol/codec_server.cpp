// Takes and gives what a server says on the wire.
#include "common/protocol/codec.h"
#include "common/protocol/codec_enums.h"
#include "common/protocol/codec_match.h"
#include "common/protocol/codec_message.h"
#include "common/protocol/codec_model.h"
#include "common/protocol/codec_record.h"
#include "common/protocol/codec_table.h"
#include "proto/server.capnp.h"

#include <algorithm>
#include <utility>

namespace billiards::protocol {

namespace {

using Out = wire::ServerMessage::Builder;
using protocol::read;
using protocol::write;

capnp::Data::Reader data_of(const ResumeToken& token) {
    return {token.data(), token.size()};
}

// ---- To the wire, one a message

void write(Out out, const server::Welcome& welcome) {
    auto body = out.initWelcome();
    body.setName(welcome.name);
    body.setToken(data_of(welcome.token));
    body.setServerTimeUs(welcome.server_time_us);
    if (welcome.table) body.getTable().setId(welcome.table->value);
}

void write(Out out, const server::Refused& refused) {
    auto body = out.initRefused();
    body.setCode(to_wire(refused.code));
    if (refused.match_code) body.getMatchCode().setCode(to_wire(*refused.match_code));
    body.setDetail(clipped_detail(refused.detail));
    body.setInReplyTo(refused.in_reply_to);
}

void write(Out out, const server::TableList& list) {
    CHECK(list.tables.size() <= kMaxTableRows);
    auto rows = out.initTableList().initTables(static_cast<unsigned int>(list.tables.size()));
    for (unsigned int i = 0; i < rows.size(); ++i) write(rows[i], list.tables[i]);
}

void write(Out out, const server::TableSnapshot& snapshot) {
    write(out.initTableSnapshot(), snapshot);
}

void write(Out out, const server::SeatChanged& changed) {
    auto body = out.initSeatChanged();
    body.setSequence(changed.sequence);
    write(body.initFirstSeat(), changed.seats[model::Seat::First]);
    write(body.initSecondSeat(), changed.seats[model::Seat::Second]);
    body.setSpectators(changed.spectators);
}

void write(Out out, const server::MatchStarted& started) {
    auto body = out.initMatchStarted();
    body.setSequence(started.sequence);
    write(body.initState(), started.state);
    write(body.initTurn(), started.turn);
}

void write(Out out, const server::CueBallPlaced& placed) {
    auto body = out.initCueBallPlaced();
    body.setSequence(placed.sequence);
    body.setSeat(to_wire(placed.seat));
    body.setXM(placed.position_m.x);
    body.setYM(placed.position_m.y);
}

void write(Out out, const server::AimShown& aim) {
    auto body = out.initAimShown();
    body.setSeat(to_wire(aim.seat));
    body.setTurn(aim.turn.value);
    write(body.initShot(), aim.shot);
}

void write(Out out, const server::ShotPlayed& played) {
    write(out.initShotPlayed(), played);
}

void write(Out out, const server::TurnOpened& opened) {
    auto body = out.initTurnOpened();
    body.setSequence(opened.sequence);
    body.setNumber(opened.number.value);
    write(body.initTurn(), opened.turn);
}

void write(Out out, const server::MatchMoved& moved) {
    auto body = out.initMatchMoved();
    body.setSequence(moved.sequence);
    body.setSeat(to_wire(moved.seat));
    if (moved.choice) body.getChoice().setMade(to_wire(*moved.choice));
    if (moved.verdict) write(body.getVerdict().initRuling(), *moved.verdict);
    write(body.initAfter(), moved.after);
    write(body.initTurn(), moved.turn);
    body.setMove(to_wire(moved.move));
}

void write(Out out, const server::MatchOver& over) {
    auto body = out.initMatchOver();
    body.setSequence(over.sequence);
    if (over.winner) body.setWinner(to_wire(*over.winner));
    body.setUndecided(!over.winner);
    write_counts(body.getRacksWon(), over.racks_won);
    body.setShots(over.shots);
    body.setConceded(over.ending == server::Ending::Conceded);
    body.setEnding(to_wire(over.ending));
}

void write(Out out, const server::ChatSaid& said) {
    auto body = out.initChatSaid();
    body.setName(said.name);
    body.setText(said.text);
}

void write(Out out, const server::Notice& notice) {
    auto body = out.initNotice();
    body.setCode(to_wire(notice.code));
    body.setDetail(clipped_detail(notice.detail));
}

void write(Out out, const server::Pong& pong) {
    auto body = out.initPong();
    body.setClientTimeUs(pong.client_time_us);
    body.setServerTimeUs(pong.server_time_us);
}

void write(Out out, const server::Resumed& resumed) {
    auto body = out.initResumed();
    body.setTable(resumed.table.value);
    write(body.initYourSeats(static_cast<unsigned int>(resumed.your_seats.size())),
          resumed.your_seats);
    body.setServerTimeUs(resumed.server_time_us);
}

void write(Out out, const server::TableChanged& changed) {
    auto body = out.initTableChanged();
    body.setSequence(changed.sequence);
    write(body.initRow(), changed.row);
}

void write(Out out, const server::TableListChange& change) {
    CHECK(change.changed.size() <= kMaxTableRows && change.gone.size() <= kMaxTableRows);
    auto body = out.initTableListChange();
    auto rows = body.initChanged(static_cast<unsigned int>(change.changed.size()));
    for (unsigned int i = 0; i < rows.size(); ++i) write(rows[i], change.changed[i]);
    auto gone = body.initGone(static_cast<unsigned int>(change.gone.size()));
    for (unsigned int i = 0; i < gone.size(); ++i) gone.set(i, change.gone[i].value);
}

void write(Out out, const server::InviteMade& made) {
    auto body = out.initInviteMade();
    body.setTable(made.table.value);
    body.setPlaying(made.is_for_playing);
    body.setSecret({made.secret.data(), made.secret.size()});
    body.setExpiresUs(made.expires_us);
}

void write(wire::HistoryRow::Builder out, const server::HistoryRow& row) {
    out.setMatch(row.match);
    out.setEndedS(row.ended_s);
    out.setGame(to_wire(row.game));
    out.setFirstName(row.names[model::Seat::First]);
    out.setSecondName(row.names[model::Seat::Second]);
    write_counts(out.getRacksWon(), row.racks_won);
    if (row.winner) out.getWinner().setSeat(to_wire(*row.winner));
    out.setShots(row.shots);
    out.setEnding(to_wire(row.ending));
}

void write(Out out, const server::HistoryPage& page) {
    CHECK(page.rows.size() <= kMaxHistoryRows);
    auto body = out.initHistoryPage();
    auto rows = body.initRows(static_cast<unsigned int>(page.rows.size()));
    for (unsigned int i = 0; i < rows.size(); ++i) write(rows[i], page.rows[i]);
    body.setHasMore(page.has_more);
}

void write(Out out, const server::PlayerRecord& record) {
    auto body = out.initPlayerRecord();
    body.setName(record.name);
    body.setGames(record.games);
    body.setWins(record.wins);
    body.setDraws(record.draws);
    body.setRating(record.rating);
    body.setDeviation(record.deviation);
}

void write(Out out, const server::ReplayChunk& chunk) {
    CHECK(chunk.messages.size() <= kMaxReplaySteps);
    auto body = out.initReplayChunk();
    body.setMatch(chunk.match);
    body.setFirst(chunk.first);
    body.setTotal(chunk.total);
    auto messages = body.initMessages(static_cast<unsigned int>(chunk.messages.size()));
    for (unsigned int i = 0; i < messages.size(); ++i) {
        const auto& bytes = chunk.messages[i];
        messages.set(i, {reinterpret_cast<const kj::byte*>(bytes.data()), bytes.size()});
    }
}

// ---- From the wire, one a message

server::Welcome read(wire::Welcome::Reader in) {
    server::Welcome welcome{.name = text(in.getName(), kMaxShownNameLength, "name"),
                            .token = {},
                            .server_time_us = in.getServerTimeUs(),
                            .table = {}};
    const capnp::Data::Reader token = in.getToken();
    require(token.size() == welcome.token.size(), "token");
    std::copy(token.begin(), token.end(), welcome.token.begin());
    if (in.getTable().isId()) welcome.table = TableId{in.getTable().getId()};
    return welcome;
}

server::Refused read(wire::Refused::Reader in) {
    server::Refused refused{.code = from_wire<RefusedCode>(in.getCode(), "code"),
                            .match_code = {},
                            .detail = detail(in.getDetail()),
                            .in_reply_to = in.getInReplyTo()};
    if (in.getMatchCode().isCode()) {
        refused.match_code =
            from_wire<match::RefusalCode>(in.getMatchCode().getCode(), "match_code");
    }
    return refused;
}

server::TableList read(wire::TableList::Reader in) {
    const auto rows = at_most(in.getTables(), kMaxTableRows, "tables");
    server::TableList list;
    list.tables.reserve(rows.size());
    for (const auto row : rows) list.tables.push_back(read(row));
    return list;
}

server::SeatChanged read(wire::SeatChanged::Reader in) {
    return {.sequence = in.getSequence(),
            .seats = {{read(in.getFirstSeat()), read(in.getSecondSeat())}},
            .spectators = in.getSpectators()};
}

server::MatchStarted read(wire::MatchStarted::Reader in) {
    return {.sequence = in.getSequence(), .state = read(in.getState()), .turn = read(in.getTurn())};
}

server::CueBallPlaced read(wire::CueBallPlaced::Reader in) {
    return {.sequence = in.getSequence(),
            .seat = read(in.getSeat()),
            .position_m = {finite(in.getXM(), "position_m"), finite(in.getYM(), "position_m")}};
}

server::AimShown read(wire::AimShown::Reader in) {
    return {.seat = read(in.getSeat()),
            .turn = model::TurnNumber{in.getTurn()},
            .shot = finite(read(in.getShot()))};
}

server::TurnOpened read(wire::TurnOpened::Reader in) {
    return {.sequence = in.getSequence(),
            .number = model::TurnNumber{in.getNumber()},
            .turn = read(in.getTurn())};
}

server::MatchMoved read(wire::MatchMoved::Reader in) {
    server::MatchMoved moved{.sequence = in.getSequence(),
                             .seat = read(in.getSeat()),
                             .choice = {},
                             .verdict = {},
                             .after = read(in.getAfter()),
                             .turn = read(in.getTurn()),
                             .move = from_wire<server::Move>(in.getMove(), "move")};
    if (in.getChoice().isMade()) {
        moved.choice = from_wire<rules::Choice>(in.getChoice().getMade(), "choice");
    }
    if (in.getVerdict().isRuling()) moved.verdict = read(in.getVerdict().getRuling());
    return moved;
}

/// Version 1.0 knew of concessions alone.
server::Ending read_ending(wire::MatchOver::Reader in) {
    if (in.getConceded()) return server::Ending::Conceded;
    return from_wire<server::Ending>(in.getEnding(), "ending");
}

server::MatchOver read(wire::MatchOver::Reader in) {
    return {.sequence = in.getSequence(),
            .winner = in.getUndecided() ? std::nullopt : std::optional(read(in.getWinner())),
            .racks_won = read_counts(in.getRacksWon(), "racks_won"),
            .shots = in.getShots(),
            .ending = read_ending(in)};
}

server::ChatSaid read(wire::ChatSaid::Reader in) {
    return {.name = text(in.getName(), kMaxShownNameLength, "name"),
            .text = text(in.getText(), kMaxChatLength, "text")};
}

server::Notice read(wire::Notice::Reader in) {
    return {.code = from_wire<server::NoticeCode>(in.getCode(), "code"),
            .detail = detail(in.getDetail())};
}

server::Pong read(wire::Pong::Reader in) {
    return {.client_time_us = in.getClientTimeUs(), .server_time_us = in.getServerTimeUs()};
}

server::Resumed read(wire::Resumed::Reader in) {
    return {.table = TableId{in.getTable()},
            .your_seats = read_your_seats(in.getYourSeats()),
            .server_time_us = in.getServerTimeUs()};
}

server::TableChanged read(wire::TableChanged::Reader in) {
    return {.sequence = in.getSequence(), .row = read(in.getRow())};
}

server::TableListChange read(wire::TableListChange::Reader in) {
    server::TableListChange change;
    for (const auto row : at_most(in.getChanged(), kMaxTableRows, "changed")) {
        change.changed.push_back(read(row));
    }
    for (const auto id : at_most(in.getGone(), kMaxTableRows, "gone")) {
        change.gone.push_back(TableId{id});
    }
    return change;
}

server::InviteMade read(wire::InviteMade::Reader in) {
    server::InviteMade made{.table = TableId{in.getTable()},
                            .is_for_playing = in.getPlaying(),
                            .secret = {},
                            .expires_us = in.getExpiresUs()};
    const capnp::Data::Reader secret = in.getSecret();
    require(secret.size() == made.secret.size(), "secret");
    std::copy(secret.begin(), secret.end(), made.secret.begin());
    return made;
}

server::HistoryRow read(wire::HistoryRow::Reader in) {
    server::HistoryRow row{.match = in.getMatch(),
                           .ended_s = in.getEndedS(),
                           .game = from_wire<rules::Game>(in.getGame(), "game"),
                           .names = {{text(in.getFirstName(), kMaxShownNameLength, "names"),
                                      text(in.getSecondName(), kMaxShownNameLength, "names")}},
                           .racks_won = read_counts(in.getRacksWon(), "racks_won"),
                           .winner = {},
                           .shots = in.getShots(),
                           .ending = from_wire<server::Ending>(in.getEnding(), "ending")};
    if (in.getWinner().isSeat()) row.winner = read(in.getWinner().getSeat());
    return row;
}

server::HistoryPage read(wire::HistoryPage::Reader in) {
    server::HistoryPage page;
    for (const auto row : at_most(in.getRows(), kMaxHistoryRows, "rows")) {
        page.rows.push_back(read(row));
    }
    page.has_more = in.getHasMore();
    return page;
}

server::PlayerRecord read(wire::PlayerRecord::Reader in) {
    return {.name = text(in.getName(), kMaxShownNameLength, "name"),
            .games = in.getGames(),
            .wins = in.getWins(),
            .draws = in.getDraws(),
            .rating = finite(in.getRating(), "rating"),
            .deviation = finite(in.getDeviation(), "deviation")};
}

server::ReplayChunk read(wire::ReplayChunk::Reader in) {
    server::ReplayChunk chunk{
        .match = in.getMatch(), .first = in.getFirst(), .total = in.getTotal(), .messages = {}};
    for (const capnp::Data::Reader data : at_most(in.getMessages(), kMaxReplaySteps, "messages")) {
        const auto* bytes = reinterpret_cast<const std::byte*>(data.begin());
        chunk.messages.emplace_back(bytes, bytes + data.size());
    }
    return chunk;
}

ServerMessage read(wire::ServerMessage::Reader in) {
    switch (in.which()) {
        case wire::ServerMessage::WELCOME:
            return read(in.getWelcome());
        case wire::ServerMessage::REFUSED:
            return read(in.getRefused());
        case wire::ServerMessage::TABLE_LIST:
            return read(in.getTableList());
        case wire::ServerMessage::TABLE_SNAPSHOT:
            return read(in.getTableSnapshot());
        case wire::ServerMessage::SEAT_CHANGED:
            return read(in.getSeatChanged());
        case wire::ServerMessage::MATCH_STARTED:
            return read(in.getMatchStarted());
        case wire::ServerMessage::CUE_BALL_PLACED:
            return read(in.getCueBallPlaced());
        case wire::ServerMessage::AIM_SHOWN:
            return read(in.getAimShown());
        case wire::ServerMessage::SHOT_PLAYED:
            return read(in.getShotPlayed());
        case wire::ServerMessage::TURN_OPENED:
            return read(in.getTurnOpened());
        case wire::ServerMessage::MATCH_MOVED:
            return read(in.getMatchMoved());
        case wire::ServerMessage::MATCH_OVER:
            return read(in.getMatchOver());
        case wire::ServerMessage::CHAT_SAID:
            return read(in.getChatSaid());
        case wire::ServerMessage::NOTICE:
            return read(in.getNotice());
        case wire::ServerMessage::PONG:
            return read(in.getPong());
        case wire::ServerMessage::RESUMED:
            return read(in.getResumed());
        case wire::ServerMessage::TABLE_CHANGED:
            return read(in.getTableChanged());
        case wire::ServerMessage::TABLE_LIST_CHANGE:
            return read(in.getTableListChange());
        case wire::ServerMessage::INVITE_MADE:
            return read(in.getInviteMade());
        case wire::ServerMessage::HISTORY_PAGE:
            return read(in.getHistoryPage());
        case wire::ServerMessage::PLAYER_RECORD:
            return read(in.getPlayerRecord());
        case wire::ServerMessage::REPLAY_CHUNK:
            return read(in.getReplayChunk());
    }
    fail(DecodeErrorCode::UnknownKind, "server message");
}

}  // namespace

SharedFrame encode(const ServerMessage& message) {
    const auto fill = [&](Out out) {
        std::visit([&](const auto& said) { write(out, said); }, message);
    };
    return framed(encode_root<wire::ServerMessage>(fill, kFrameHeaderBytes));
}

base::Result<ServerMessage, DecodeError> decode_server(std::span<const std::byte> frame) {
    return decode_root<wire::ServerMessage>(
        frame, [](wire::ServerMessage::Reader in) { return read(in); });
}

}  // namespace billiards::protocol
