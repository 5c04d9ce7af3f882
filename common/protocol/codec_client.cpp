// Takes and gives what a client says on the wire.
#include "common/protocol/codec.h"
#include "common/protocol/codec_enums.h"
#include "common/protocol/codec_match.h"
#include "common/protocol/codec_message.h"
#include "common/protocol/codec_model.h"
#include "proto/client.capnp.h"

#include <algorithm>

namespace billiards::protocol {

namespace {

using Out = wire::ClientMessage::Builder;
using protocol::read;
using protocol::write;

capnp::Data::Reader data_of(const ResumeToken& token) {
    return {token.data(), token.size()};
}

// ---- To the wire, one a message

void write(Out out, const client::Hello& hello) {
    auto body = out.initHello();
    body.setName(hello.name);
    if (hello.token) body.setToken(data_of(*hello.token));
}

void write(Out out, client::ListTables) {
    out.setListTables();
}

void write(Out out, const client::CreateTable& create) {
    auto body = out.initCreateTable();
    body.setName(create.name);
    write(body.initSettings(), create.settings);
    body.setRole(to_wire(create.role));
}

void write(Out out, const client::Join& join) {
    auto body = out.initJoin();
    body.setTable(join.table.value);
    body.setRole(to_wire(join.role));
}

void write(Out out, client::Leave) {
    out.setLeave();
}

void write(Out out, client::Ready) {
    out.setReady();
}

void write(Out out, const client::PlaceCueBall& place) {
    auto body = out.initPlaceCueBall();
    body.setTurn(place.turn.value);
    body.setXM(place.position_m.x);
    body.setYM(place.position_m.y);
}

void write(Out out, const client::Aim& aim) {
    auto body = out.initAim();
    body.setTurn(aim.turn.value);
    write(body.initShot(), aim.shot);
}

void write(Out out, const client::TakeShot& take) {
    auto body = out.initTakeShot();
    body.setTurn(take.turn.value);
    body.setShotId(take.shot_id);
    write(body.initShot(), take.shot);
    write(body.initCall(), take.call);
}

void write(Out out, const client::Seen& seen) {
    out.initSeen().setSequence(seen.sequence);
}

void write(Out out, const client::Choose& choose) {
    auto body = out.initChoose();
    body.setTurn(choose.turn.value);
    body.setChoice(to_wire(choose.choice));
}

void write(Out out, client::Concede) {
    out.setConcede();
}

void write(Out out, const client::Chat& chat) {
    out.initChat().setText(chat.text);
}

void write(Out out, const client::Ping& ping) {
    out.initPing().setClientTimeUs(ping.client_time_us);
}

// ---- From the wire, one a message with content

client::Hello read(wire::Hello::Reader in) {
    client::Hello hello{.name = text(in.getName(), kMaxNameLength, "name"), .token = {}};
    const capnp::Data::Reader token = in.getToken();
    if (token.size() == 0) return hello;
    hello.token.emplace();
    require(token.size() == hello.token->size(), "token");
    std::copy(token.begin(), token.end(), hello.token->begin());
    return hello;
}

client::CreateTable read(wire::CreateTable::Reader in) {
    return {.name = text(in.getName(), kMaxTableNameLength, "name"),
            .settings = read(in.getSettings()),
            .role = from_wire<Role>(in.getRole(), "role")};
}

client::Join read(wire::Join::Reader in) {
    return {.table = TableId{in.getTable()}, .role = from_wire<Role>(in.getRole(), "role")};
}

client::PlaceCueBall read(wire::PlaceCueBall::Reader in) {
    return {.turn = model::TurnNumber{in.getTurn()}, .position_m = {in.getXM(), in.getYM()}};
}

client::Aim read(wire::Aim::Reader in) {
    return {.turn = model::TurnNumber{in.getTurn()}, .shot = read(in.getShot())};
}

client::TakeShot read(wire::TakeShot::Reader in) {
    return {.turn = model::TurnNumber{in.getTurn()},
            .shot_id = in.getShotId(),
            .shot = read(in.getShot()),
            .call = read(in.getCall())};
}

client::Choose read(wire::Choose::Reader in) {
    return {.turn = model::TurnNumber{in.getTurn()},
            .choice = from_wire<rules::Choice>(in.getChoice(), "choice")};
}

ClientMessageBody read_body(wire::ClientMessage::Reader in) {
    switch (in.which()) {
        case wire::ClientMessage::HELLO:
            return read(in.getHello());
        case wire::ClientMessage::LIST_TABLES:
            return client::ListTables{};
        case wire::ClientMessage::CREATE_TABLE:
            return read(in.getCreateTable());
        case wire::ClientMessage::JOIN:
            return read(in.getJoin());
        case wire::ClientMessage::LEAVE:
            return client::Leave{};
        case wire::ClientMessage::READY:
            return client::Ready{};
        case wire::ClientMessage::PLACE_CUE_BALL:
            return read(in.getPlaceCueBall());
        case wire::ClientMessage::AIM:
            return read(in.getAim());
        case wire::ClientMessage::TAKE_SHOT:
            return read(in.getTakeShot());
        case wire::ClientMessage::SEEN:
            return client::Seen{in.getSeen().getSequence()};
        case wire::ClientMessage::CHOOSE:
            return read(in.getChoose());
        case wire::ClientMessage::CONCEDE:
            return client::Concede{};
        case wire::ClientMessage::CHAT:
            return client::Chat{text(in.getChat().getText(), kMaxChatLength, "text")};
        case wire::ClientMessage::PING:
            return client::Ping{in.getPing().getClientTimeUs()};
    }
    fail(DecodeErrorCode::UnknownKind, "client message");
}

}  // namespace

SharedFrame encode(const ClientMessage& message) {
    const auto fill = [&](Out out) {
        out.setRequestId(message.request_id);
        std::visit([&](const auto& body) { write(out, body); }, message.body);
    };
    return framed(encode_root<wire::ClientMessage>(fill, kFrameHeaderBytes));
}

base::Result<ClientMessage, DecodeError> decode_client(std::span<const std::byte> frame) {
    return decode_root<wire::ClientMessage>(frame, [](wire::ClientMessage::Reader in) {
        return ClientMessage{.request_id = in.getRequestId(), .body = read_body(in)};
    });
}

}  // namespace billiards::protocol
