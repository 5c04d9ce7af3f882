// Takes a segment and gives the few 32-bit numbers that it can be restored from, and back.
//
// Every choice of form is made on numbers already rounded to 32 bits, so that packing what was
// unpacked gives the same bytes again.
#include "common/protocol/codec_segment.h"

#include <limits>

namespace billiards::protocol {

namespace {

using base::Vec2;
using base::Vec3;
using model::Motion;
using timeline::Segment;

// A form: the motion in bits 0 - 2, how it moves in the plane in bits 3 - 4, then two flags; bit 7
// is free. The numbers stand in this order:
//   x, y; in the plane as below; with kHeight z, vz, az; with kTwist wz, wz'.
constexpr unsigned int kMotionMask = 0x07;
constexpr unsigned int kPlaneShift = 3;
constexpr unsigned int kPlaneMask = 0x03;
constexpr unsigned int kHeight = 0x20;  ///< Not at rest height with no vertical motion.
constexpr unsigned int kTwist = 0x40;   ///< Spins about the vertical.
constexpr unsigned int kUnknown = 0x80;

enum class Plane : std::uint8_t {
    Still,    ///< All zero.
    Rolling,  ///< vx, vy, ax, ay: w = (z x v) / R, w' = (z x a) / R.
    Sliding,  ///< vx, vy, ax, ay, wx, wy: w' = -5/2 (z x a) / R, as for any solid sphere.
    Free,     ///< vx, vy, ax, ay, wx, wy, wx', wy'.
};

constexpr double kSlidingRatio = -2.5;
/// Relative, of two numbers that went through 32 bits: a few of their last places.
constexpr double kTolerance = 0x1p-20;

Vec2 as_sent(Vec2 v) {
    return {protocol::as_sent(v.x), protocol::as_sent(v.y)};
}
Vec2 quarter_turn(Vec2 v) {  // z x v
    return {-v.y, v.x};
}
bool is_close(Vec2 a, Vec2 b) {
    return glm::length(a - b) <=
           kTolerance * (glm::length(a) + glm::length(b)) + std::numeric_limits<float>::min();
}

/// The horizontal parts of a segment, rounded.
struct InPlane {
    Vec2 velocity{};
    Vec2 acceleration{};
    Vec2 spin{};
    Vec2 spin_rate{};
};

InPlane in_plane(const Segment& segment) {
    return {as_sent(base::horizontal(segment.velocity_mps)),
            as_sent(base::horizontal(segment.acceleration_mps2)),
            as_sent(base::horizontal(segment.spin_radps)),
            as_sent(base::horizontal(segment.spin_rate_radps2))};
}

Vec2 rolling_spin(Vec2 motion, double radius_m) {
    return quarter_turn(motion) / radius_m;
}
Vec2 sliding_spin_rate(Vec2 acceleration, double radius_m) {
    return kSlidingRatio * quarter_turn(acceleration) / radius_m;
}

Plane plane_of(const InPlane& motion, double radius_m) {
    const Vec2 zero{};
    if (motion.velocity == zero && motion.acceleration == zero && motion.spin == zero &&
        motion.spin_rate == zero) {
        return Plane::Still;
    }
    if (is_close(motion.spin, rolling_spin(motion.velocity, radius_m)) &&
        is_close(motion.spin_rate, rolling_spin(motion.acceleration, radius_m))) {
        return Plane::Rolling;
    }
    return is_close(motion.spin_rate, sliding_spin_rate(motion.acceleration, radius_m))
               ? Plane::Sliding
               : Plane::Free;
}

bool has_height(const Segment& segment, double radius_m) {
    return protocol::as_sent(segment.position_m.z) != protocol::as_sent(radius_m) ||
           protocol::as_sent(segment.velocity_mps.z) != 0 ||
           protocol::as_sent(segment.acceleration_mps2.z) != 0;
}

bool has_twist(const Segment& segment) {
    return protocol::as_sent(segment.spin_radps.z) != 0 ||
           protocol::as_sent(segment.spin_rate_radps2.z) != 0;
}

class Numbers {
  public:
    explicit Numbers(std::vector<float>& out) : out_(out) {}
    void put(double number) { out_.push_back(static_cast<float>(number)); }
    void put(const Vec3& v) { put(v.x), put(v.y); }  // The part in the plane.

  private:
    std::vector<float>& out_;
};

/// Gives 0 once nothing is left, and remembers that.
class Source {
  public:
    explicit Source(std::span<const float>& in) : in_(in) {}
    bool is_whole() const { return is_whole_; }

    double number() {
        if (in_.empty()) return is_whole_ = false, 0.0;
        const double number = in_.front();
        in_ = in_.subspan(1);
        return number;
    }
    Vec2 pair() {
        const double x = number();
        return {x, number()};
    }

  private:
    std::span<const float>& in_;
    bool is_whole_ = true;
};

void pack_plane(const Segment& segment, Plane plane, Numbers& out) {
    if (plane == Plane::Still) return;
    out.put(segment.velocity_mps);
    out.put(segment.acceleration_mps2);
    if (plane == Plane::Rolling) return;
    out.put(segment.spin_radps);
    if (plane == Plane::Free) out.put(segment.spin_rate_radps2);
}

InPlane unpack_plane(Plane plane, double radius_m, Source& in) {
    if (plane == Plane::Still) return {};
    InPlane motion;
    motion.velocity = in.pair();
    motion.acceleration = in.pair();
    if (plane == Plane::Rolling) {
        motion.spin = rolling_spin(motion.velocity, radius_m);
        motion.spin_rate = rolling_spin(motion.acceleration, radius_m);
        return motion;
    }
    motion.spin = in.pair();
    motion.spin_rate =
        plane == Plane::Free ? in.pair() : sliding_spin_rate(motion.acceleration, radius_m);
    return motion;
}

}  // namespace

double as_sent(double number) {
    // g++ 12.2 from -O2 on drops the rounding where two such numbers lie side by side (it makes a
    // vector of the pair and forgets the way through float); volatile keeps it.
    const volatile float rounded = static_cast<float>(number);
    return rounded;
}

std::uint8_t pack(const Segment& segment, double radius_m, std::vector<float>& numbers) {
    const Plane plane = plane_of(in_plane(segment), radius_m);
    unsigned int form = static_cast<unsigned int>(segment.motion) | static_cast<unsigned int>(plane)
                                                                        << kPlaneShift;
    Numbers out(numbers);
    out.put(segment.position_m);
    pack_plane(segment, plane, out);
    if (has_height(segment, radius_m)) {
        form |= kHeight;
        out.put(segment.position_m.z);
        out.put(segment.velocity_mps.z);
        out.put(segment.acceleration_mps2.z);
    }
    if (has_twist(segment)) {
        form |= kTwist;
        out.put(segment.spin_radps.z);
        out.put(segment.spin_rate_radps2.z);
    }
    return static_cast<std::uint8_t>(form);
}

std::optional<Segment> unpack(std::uint8_t form, double radius_m, std::span<const float>& numbers) {
    const unsigned int motion = form & kMotionMask;
    if (motion > static_cast<unsigned int>(Motion::OffTable)) return std::nullopt;
    if ((form & kUnknown) != 0) return std::nullopt;
    Source in(numbers);
    const Vec2 position = in.pair();
    const auto plane = static_cast<Plane>(form >> kPlaneShift & kPlaneMask);
    const InPlane moving = unpack_plane(plane, radius_m, in);
    Segment segment{.position_m = {position, radius_m},
                    .velocity_mps = {moving.velocity, 0},
                    .acceleration_mps2 = {moving.acceleration, 0},
                    .spin_radps = {moving.spin, 0},
                    .spin_rate_radps2 = {moving.spin_rate, 0},
                    .motion = static_cast<Motion>(motion)};
    if ((form & kHeight) != 0) {
        segment.position_m.z = in.number();
        segment.velocity_mps.z = in.number();
        segment.acceleration_mps2.z = in.number();
    }
    if ((form & kTwist) != 0) {
        segment.spin_radps.z = in.number();
        segment.spin_rate_radps2.z = in.number();
    }
    return in.is_whole() ? std::optional(segment) : std::nullopt;
}

}  // namespace billiards::protocol
