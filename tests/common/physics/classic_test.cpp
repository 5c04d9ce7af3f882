// Holds the classic preset against the original design's own algorithm, stepped frame by frame.
#include "tests/common/physics/still_life.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

namespace billiards::physics {
namespace {

struct Disc {
    Vec2 place;
    Vec2 velocity;
};

/// Algorithm 2.1 of the original design, with the corrections of its misprints: straight lines
/// within a frame, friction at its end.
class FrameStepped {
  public:
    FrameStepped(Vec2 half, std::vector<Disc> discs) : half_(half), discs_(std::move(discs)) {}

    void update(double dt) {
        double left = dt;
        for (Hit hit = first_hit(left); hit.time < left; hit = first_hit(left)) {
            move(hit.time);
            left -= hit.time;
            resolve(hit);
        }
        move(left);
        for (Disc& disc : discs_) slow_down(disc, dt);
    }
    const std::vector<Disc>& discs() const { return discs_; }

  private:
    struct Hit {
        double time = std::numeric_limits<double>::infinity();
        std::size_t a = 0;
        std::size_t b = 0;  ///< The same as a: a wall.
        int axis = 0;
    };

    Hit first_hit(double within) const {
        Hit first;
        first.time = within;
        for (std::size_t i = 0; i < discs_.size(); ++i) {
            for (int axis = 0; axis < 2; ++axis) {
                const double v = discs_[i].velocity[axis];
                if (v == 0) continue;
                const double wall = std::copysign(half_[axis] - kRadius_m, v);
                const double time = std::max(0.0, (wall - discs_[i].place[axis]) / v);
                if (time < first.time) first = {time, i, i, axis};
            }
            for (std::size_t j = i + 1; j < discs_.size(); ++j) {
                const double time = pair_time(discs_[i], discs_[j]);
                if (time < first.time) first = {time, i, j, 0};
            }
        }
        return first;
    }

    /// Equation 5, its middle term with the factor 2.
    static double pair_time(const Disc& a, const Disc& b) {
        const Vec2 r = b.place - a.place;
        const Vec2 v = b.velocity - a.velocity;
        const double closing = glm::dot(r, v);
        const double speed_squared = glm::dot(v, v);
        const double distance = 2 * kRadius_m;
        const double d = closing * closing - speed_squared * (glm::dot(r, r) - distance * distance);
        if (closing >= 0 || d < 0) return std::numeric_limits<double>::infinity();
        return std::max(0.0, (-closing - std::sqrt(d)) / speed_squared);
    }

    void resolve(const Hit& hit) {
        Disc& a = discs_[hit.a];
        if (hit.a == hit.b) {
            a.velocity[hit.axis] = -a.velocity[hit.axis];
            a.velocity *= 0.7;
            return;
        }
        Disc& b = discs_[hit.b];
        const Vec2 normal = glm::normalize(b.place - a.place);
        const Vec2 exchanged = glm::dot(a.velocity - b.velocity, normal) * normal;
        a.velocity -= exchanged;
        b.velocity += exchanged;
    }

    void move(double time) {
        for (Disc& disc : discs_) disc.place += time * disc.velocity;
    }

    static void slow_down(Disc& disc, double dt) {
        const double speed = glm::length(disc.velocity);
        if (speed < 0.01) {
            disc.velocity = {};
        } else {
            disc.velocity *= std::max(0.0, 1 - 0.017 * 9.81 * dt / speed);
        }
    }

    Vec2 half_;
    std::vector<Disc> discs_;
};

constexpr Vec2 kHalf_m{1.0, 0.5};

model::TableSpec closed_table() {
    model::TableSpec table;
    table.cushions = {{{-1, -0.5}, {1, -0.5}},
                      {{1, -0.5}, {1, 0.5}},
                      {{1, 0.5}, {-1, 0.5}},
                      {{-1, 0.5}, {-1, -0.5}}};
    table.nose_height_m = 0.635 * 2 * kRadius_m;
    return table;
}

std::vector<BallStart> opening() {
    return {ball_at(0, {-0.6, 0.03}, {1.9, 0.1}), ball_at(1, {0.1, 0.08}), ball_at(2, {0.4, -0.2}),
            ball_at(3, {0.55, 0.3})};
}

/// The largest distance between where the two say a ball is after three seconds.
double difference_m(double dt) {
    const auto record = solved(closed_table(), classic_parameters(), opening());
    std::vector<Disc> discs;
    for (const BallStart& ball : opening()) {
        discs.push_back({base::horizontal(ball.position_m), base::horizontal(ball.velocity_mps)});
    }
    FrameStepped reference(kHalf_m, discs);
    const int frames = static_cast<int>(std::lround(3.0 / dt));
    for (int frame = 0; frame < frames; ++frame) reference.update(dt);
    double largest = 0.0;
    for (std::size_t i = 0; i < discs.size(); ++i) {
        const Vec3 place = state_of(record, static_cast<int>(i), 3.0).position_m;
        largest =
            std::max(largest, glm::distance(base::horizontal(place), reference.discs()[i].place));
    }
    return largest;
}

/// First order: friction comes at the end of each frame, and hits anywhere within it. The errors
/// are recorded, for docs/physics.md to show: `--gtest_output=json` has them.
TEST(Classic, IsWhereTheFrameSteppedOriginalConvergesToAtFirstOrder) {
    constexpr double kMostError_mps = 0.25;  // A frame of dt makes at most 0.22 m/s dt of error.
    for (int rate_hz = 64; rate_hz <= 65536; rate_hz *= 2) {
        const double error_m = difference_m(1.0 / rate_hz);
        EXPECT_LT(error_m, kMostError_mps / rate_hz) << rate_hz << " frames a second";
        std::ostringstream text;
        text << error_m;
        RecordProperty("error_m_at_" + std::to_string(rate_hz) + "_hz", text.str());
    }
}

TEST(Classic, BallsGlideAtAConstantDecelerationAndStopAtOneCentimetreASecond) {
    const auto record =
        solved(model::open_table(), classic_parameters(), {ball_at(1, {0, 0}, {1, 0}, {9, 9, 9})});
    EXPECT_NEAR(record.duration_s, (1 - 0.01) / (0.017 * 9.81), 1e-12);
    EXPECT_EQ(track_of(record, 1).segments.front().motion, Motion::Rolling);
    EXPECT_EQ(track_of(record, 1).segments.front().spin_radps, rolling_spin({1, 0}))
        << "drawn rolling";
}

TEST(Classic, SpinThatIsOnlyDrawnPushesNoBallThroughAFrictionOfAnotherModel) {
    Parameters rough = classic_parameters();
    rough.cushion = CushionModel::Han2005;
    BallStart falling = ball_at(1, {0, kHalf_m.y - kRadius_m}, {0, 0}, {100, 200, 300});
    falling.position_m.z = 0.08;
    Diagnostics diagnostics;
    const auto record = solved(closed_table(), rough, {falling}, &diagnostics);
    EXPECT_FALSE(events_of(record, EventKind::Cushion).empty());
    EXPECT_LE(diagnostics.max_energy_rise_j, 1e-12);
}

TEST(Classic, EqualBallsExchangeTheirNormalSpeeds) {
    const auto record = solved(model::open_table(), classic_parameters(),
                               {ball_at(0, {-2 * kRadius_m, 0}, {1, 0.5}), ball_at(1, {0, 0})});
    EXPECT_EQ(state_of(record, 0, 0.0).velocity_mps, Vec3(0, 0.5, 0));
    EXPECT_EQ(state_of(record, 1, 0.0).velocity_mps, Vec3(1, 0, 0));
}

}  // namespace
}  // namespace billiards::physics
