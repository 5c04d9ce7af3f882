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
    if (!hello.followed) return;
    auto followed = body.getFollowed().initTable();
    followed.setId(hello.followed->table.value);
    followed.setStream(hello.followed->stream);
    followed.setSequence(hello.followed->sequence);
}

void write(Out out, client::ListTables) {
    out.setListTables();
}

void write(Out out, const client::CreateTable& create) {
    auto body = out.initCreateTable();
    body.setName(create.name);
    write(body.initSettings(), create.settings);
    body.setRole(to_wire(create.role));
    body.setIsPrivate(create.is_private);
    body.setPasscode(create.passcode);
}

void write(Out out, const client::Join& join) {
    auto body = out.initJoin();
    body.setTable(join.table.value);
    body.setRole(to_wire(join.role));
    if (join.invite) body.setInvite({join.invite->data(), join.invite->size()});
    body.setPasscode(join.passcode);
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

void write(Out out, client::FollowTables) {
    out.setFollowTables();
}

void write(Out out, const client::QuickMatch& quick) {
    out.initQuickMatch().setGame(to_wire(quick.game));
}

void write(Out out, const client::ChangeTable& change) {
    auto body = out.initChangeTable();
    write(body.initSettings(), change.settings);
    body.setIsPrivate(change.is_private);
    if (change.passcode) body.getPasscode().setText(*change.passcode);
}

void write(Out out, const client::MakeInvite& make) {
    out.initMakeInvite().setRole(to_wire(make.role));
}

void write(Out out, client::RevokeInvites) {
    out.setRevokeInvites();
}

void write(Out out, const client::Kick& kick) {
    out.initKick().setName(kick.name);
}

void write(Out out, client::Rematch) {
    out.setRematch();
}

void write(Out out, client::ClaimMatch) {
    out.setClaimMatch();
}

void write(Out out, const client::Extend& extend) {
    out.initExtend().setTurn(extend.turn.value);
}

void write(Out out, const client::Offer& offer) {
    auto body = out.initOffer();
    body.setTurn(offer.turn.value);
    body.setKind(to_wire(offer.kind));
}

void write(Out out, const client::Answer& answer) {
    auto body = out.initAnswer();
    body.setTurn(answer.turn.value);
    body.setAccept(answer.accept);
}

void write(Out out, const client::ClaimStalemate& claim) {
    out.initClaimStalemate().setTurn(claim.turn.value);
}

void write(Out out, const client::SpotNearest& spot) {
    out.initSpotNearest().setTurn(spot.turn.value);
}

void write(Out out, const client::PlaceBall& place) {
    auto body = out.initPlaceBall();
    body.setBall(place.ball.number);
    body.setXM(place.position_m.x);
    body.setYM(place.position_m.y);
}

void write(Out out, client::Undo) {
    out.setUndo();
}

void write(Out out, client::Repeat) {
    out.setRepeat();
}

void write(Out out, client::Rerack) {
    out.setRerack();
}

void write(Out out, const client::AskHistory& ask) {
    auto body = out.initAskHistory();
    body.setPlayer(ask.player);
    body.setBefore(ask.before);
}

void write(Out out, const client::AskRecord& ask) {
    out.initAskRecord().setPlayer(ask.player);
}

void write(Out out, const client::AskReplay& ask) {
    auto body = out.initAskReplay();
    body.setMatch(ask.match);
    body.setFirst(ask.first);
}

// ---- From the wire, one a message with content

client::Hello read(wire::Hello::Reader in) {
    client::Hello hello{.name = text(in.getName(), kMaxNameLength, "name"), .token = {}};
    if (in.getFollowed().isTable()) {
        const auto table = in.getFollowed().getTable();
        hello.followed = {{table.getId()}, table.getStream(), table.getSequence()};
    }
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
            .role = from_wire<Role>(in.getRole(), "role"),
            .is_private = in.getIsPrivate(),
            .passcode = text(in.getPasscode(), kMaxPasscodeLength, "passcode")};
}

client::Join read(wire::Join::Reader in) {
    client::Join join{.table = TableId{in.getTable()},
                      .role = from_wire<Role>(in.getRole(), "role"),
                      .invite = {},
                      .passcode = text(in.getPasscode(), kMaxPasscodeLength, "passcode")};
    const capnp::Data::Reader invite = in.getInvite();
    if (invite.size() == 0) return join;
    join.invite.emplace();
    require(invite.size() == join.invite->size(), "invite");
    std::copy(invite.begin(), invite.end(), join.invite->begin());
    return join;
}

client::ChangeTable read(wire::ChangeTable::Reader in) {
    client::ChangeTable change{
        .settings = read(in.getSettings()), .is_private = in.getIsPrivate(), .passcode = {}};
    if (in.getPasscode().isText()) {
        change.passcode = text(in.getPasscode().getText(), kMaxPasscodeLength, "passcode");
    }
    return change;
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

client::Offer read(wire::Offer::Reader in) {
    return {.turn = model::TurnNumber{in.getTurn()},
            .kind = from_wire<match::OfferKind>(in.getKind(), "kind")};
}

client::PlaceBall read(wire::PlaceBall::Reader in) {
    return {.ball = ball_id(in.getBall()), .position_m = {in.getXM(), in.getYM()}};
}

model::TurnNumber read(wire::OfTurn::Reader in) {
    return {in.getTurn()};
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
        case wire::ClientMessage::FOLLOW_TABLES:
            return client::FollowTables{};
        case wire::ClientMessage::QUICK_MATCH:
            return client::QuickMatch{from_wire<rules::Game>(in.getQuickMatch().getGame(), "game")};
        case wire::ClientMessage::CHANGE_TABLE:
            return read(in.getChangeTable());
        case wire::ClientMessage::MAKE_INVITE:
            return client::MakeInvite{from_wire<Role>(in.getMakeInvite().getRole(), "role")};
        case wire::ClientMessage::REVOKE_INVITES:
            return client::RevokeInvites{};
        case wire::ClientMessage::KICK:
            return client::Kick{text(in.getKick().getName(), kMaxShownNameLength, "name")};
        case wire::ClientMessage::REMATCH:
            return client::Rematch{};
        case wire::ClientMessage::CLAIM_MATCH:
            return client::ClaimMatch{};
        case wire::ClientMessage::EXTEND:
            return client::Extend{read(in.getExtend())};
        case wire::ClientMessage::OFFER:
            return read(in.getOffer());
        case wire::ClientMessage::ANSWER:
            return client::Answer{{in.getAnswer().getTurn()}, in.getAnswer().getAccept()};
        case wire::ClientMessage::CLAIM_STALEMATE:
            return client::ClaimStalemate{read(in.getClaimStalemate())};
        case wire::ClientMessage::SPOT_NEAREST:
            return client::SpotNearest{read(in.getSpotNearest())};
        case wire::ClientMessage::PLACE_BALL:
            return read(in.getPlaceBall());
        case wire::ClientMessage::UNDO:
            return client::Undo{};
        case wire::ClientMessage::REPEAT:
            return client::Repeat{};
        case wire::ClientMessage::RERACK:
            return client::Rerack{};
        case wire::ClientMessage::ASK_HISTORY:
            return client::AskHistory{
                text(in.getAskHistory().getPlayer(), kMaxShownNameLength, "player"),
                in.getAskHistory().getBefore()};
        case wire::ClientMessage::ASK_RECORD:
            return client::AskRecord{
                text(in.getAskRecord().getPlayer(), kMaxShownNameLength, "player")};
        case wire::ClientMessage::ASK_REPLAY:
            return client::AskReplay{in.getAskReplay().getMatch(), in.getAskReplay().getFirst()};
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
