// Takes and gives layouts, shots and calls on the wire.
#include "common/protocol/codec_model.h"

#include "common/protocol/codec_enums.h"
#include "common/protocol/codec_message.h"

#include <cmath>
#include <cstddef>

namespace billiards::protocol {

namespace {

double coordinate(double number) {
    require(std::abs(number) <= kMaxMagnitude, "position");
    return number;
}

model::PlacedBall read(wire::PlacedBall::Reader in) {
    return {.ball = ball_id(in.getBall()),
            .place = from_wire<model::Place>(in.getPlace(), "place"),
            .position_m = {coordinate(in.getXM()), coordinate(in.getYM())}};
}

void write(wire::PlacedBall::Builder out, const model::PlacedBall& placed) {
    out.setBall(placed.ball.number);
    out.setPlace(to_wire(placed.place));
    out.setXM(placed.position_m.x);
    out.setYM(placed.position_m.y);
}

void write(wire::Call::Builder out, model::NoCall) {
    out.setNone();
}

void write(wire::Call::Builder out, const model::CalledBall& called) {
    auto pot = out.initPot();
    pot.setBall(called.ball.number);
    pot.setPocket(called.pocket.number);
}

void write(wire::Call::Builder out, model::PushOut) {
    out.setPushOut();
}

void write(wire::Call::Builder out, model::Safety) {
    out.setSafety();
}

}  // namespace

void write(wire::Layout::Builder out, const model::Layout& layout) {
    auto balls = out.initBalls(static_cast<unsigned int>(layout.balls.size()));
    for (unsigned int i = 0; i < balls.size(); ++i) write(balls[i], layout.balls[i]);
}

model::Layout read(wire::Layout::Reader in) {
    const auto balls = at_most(in.getBalls(), model::kMaxBalls, "balls");
    model::Layout layout;
    layout.balls.reserve(balls.size());
    for (const auto ball : balls) {
        const model::PlacedBall placed = read(ball);
        require(layout.balls.empty() || layout.balls.back().ball < placed.ball, "balls");
        layout.balls.push_back(placed);
    }
    return layout;
}

void write(wire::Shot::Builder out, const model::Shot& shot) {
    out.setAngleRad(shot.angle_rad);
    out.setPower(shot.power);
    out.setTipLeft(shot.tip_left);
    out.setTipUp(shot.tip_up);
    out.setElevationRad(shot.elevation_rad);
}

model::Shot read(wire::Shot::Reader in) {
    return {.angle_rad = in.getAngleRad(),
            .power = in.getPower(),
            .tip_left = in.getTipLeft(),
            .tip_up = in.getTipUp(),
            .elevation_rad = in.getElevationRad()};
}

void write(wire::Call::Builder out, const model::Call& call) {
    std::visit([&](const auto& said) { write(out, said); }, call);
}

model::Call read(wire::Call::Reader in) {
    switch (in.which()) {
        case wire::Call::NONE:
            return model::NoCall{};
        case wire::Call::POT: {
            const auto pot = in.getPot();
            require(pot.getPocket() < model::kPockets, "pocket");
            return model::CalledBall{ball_id(pot.getBall()), model::PocketId{pot.getPocket()}};
        }
        case wire::Call::SAFETY:
            return model::Safety{};
        case wire::Call::PUSH_OUT:
            return model::PushOut{};
    }
    fail(DecodeErrorCode::UnknownKind, "call");
}

model::Seat read(wire::Seat in) {
    return from_wire<model::Seat>(in, "seat");
}

}  // namespace billiards::protocol
