// Takes a segment and gives the few 32-bit numbers that it can be restored from, and back.
//
// Every choice of form is made on numbers already rounded to 32 bits, so that packing what was
// unpacked gives the same bytes again.
#include "common/protocol/codec_segment.h"

#include "common/base/check.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace billiards::protocol {

namespace {

using base::Vec2;
using base::Vec3;
using model::Motion;
using timeline::Segment;

// A form: the motion in bits 0 - 2, how it moves in the plane in bits 3 - 4, then two flags and
// one that is free. The numbers follow in this order:
//   x, y; in the plane as below; with kHeight z, vz, az; with kTwist wz; with kFreeTwist wz' too.
constexpr unsigned int kMotionMask = 0x07;
constexpr unsigned int kPlaneShift = 3;
constexpr unsigned int kPlaneMask = 0x03;
constexpr unsigned int kHeight = 0x20;     ///< Not at rest height with no vertical motion.
constexpr unsigned int kTwist = 0x40;      ///< Spins about the vertical.
constexpr unsigned int kFreeTwist = 0x80;  ///< At a rate of its own, not the record's.

enum class Plane : std::uint8_t {
    Still,    ///< All zero.
    Rolling,  ///< vx, vy, s: a = s v, w = (z x v) / R, w' = (z x a) / R.
    Sliding,  ///< vx, vy, ax, ay, wx, wy: w' = -5/2 (z x a) / R, as for any solid sphere.
    Free,     ///< vx, vy, ax, ay, wx, wy, wx', wy'.
};

constexpr double kSlidingRatio = -2.5;
constexpr double kSlowest_mps = 1e-6;  ///< Below it a = s v says too little.
/// Relative, of two numbers that went through 32 bits: a few of their last places.
constexpr double kTolerance = 0x1p-20;

double rounded(double number) {
    return static_cast<float>(number);
}
Vec2 rounded(Vec2 v) {
    return {rounded(v.x), rounded(v.y)};
}
Vec2 quarter_turn(Vec2 v) {  // z x v
    return {-v.y, v.x};
}
bool is_close(Vec2 a, Vec2 b) {
    return glm::length(a - b) <= kTolerance * (glm::length(a) + glm::length(b));
}

/// The horizontal parts of a segment, rounded.
struct InPlane {
    Vec2 velocity{};
    Vec2 acceleration{};
    Vec2 spin{};
    Vec2 spin_rate{};
};

InPlane in_plane(const Segment& segment) {
    return {rounded(base::horizontal(segment.velocity_mps)),
            rounded(base::horizontal(segment.acceleration_mps2)),
            rounded(base::horizontal(segment.spin_radps)),
            rounded(base::horizontal(segment.spin_rate_radps2))};
}

/// s in a = s v, as good as can be.
double along(Vec2 acceleration, Vec2 velocity) {
    return glm::dot(acceleration, velocity) / glm::dot(velocity, velocity);
}

bool is_rolling(const InPlane& motion, double radius_m) {
    if (glm::length(motion.velocity) < kSlowest_mps) return false;
    const Vec2 braking = rounded(along(motion.acceleration, motion.velocity)) * motion.velocity;
    return is_close(motion.acceleration, braking) &&
           is_close(motion.spin, quarter_turn(motion.velocity) / radius_m) &&
           is_close(motion.spin_rate, quarter_turn(braking) / radius_m);
}

Plane plane_of(const InPlane& motion, double radius_m) {
    const Vec2 zero{};
    if (motion.velocity == zero && motion.acceleration == zero && motion.spin == zero &&
        motion.spin_rate == zero) {
        return Plane::Still;
    }
    if (is_rolling(motion, radius_m)) return Plane::Rolling;
    const Vec2 turning = kSlidingRatio * quarter_turn(motion.acceleration) / radius_m;
    return is_close(motion.spin_rate, turning) ? Plane::Sliding : Plane::Free;
}

bool has_height(const Segment& segment, double radius_m) {
    return rounded(segment.position_m.z) != rounded(radius_m) ||
           rounded(segment.velocity_mps.z) != 0 || rounded(segment.acceleration_mps2.z) != 0;
}

double twist_rate(double spin_radps, const SegmentContext& context) {
    return spin_radps == 0 ? 0.0 : -std::copysign(context.twist_rate_radps2, spin_radps);
}

unsigned int twist_of(const Segment& segment, const SegmentContext& context) {
    const double spin = rounded(segment.spin_radps.z);
    const double rate = rounded(segment.spin_rate_radps2.z);
    if (spin == 0 && rate == 0) return 0;
    return rate == twist_rate(spin, context) ? kTwist : kTwist | kFreeTwist;
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
    if (plane == Plane::Rolling) {
        // Of the acceleration before its rounding, or s would change when it is packed again.
        return out.put(along(base::horizontal(segment.acceleration_mps2),
                             rounded(base::horizontal(segment.velocity_mps))));
    }
    out.put(segment.acceleration_mps2);
    out.put(segment.spin_radps);
    if (plane == Plane::Free) out.put(segment.spin_rate_radps2);
}

InPlane unpack_plane(Plane plane, double radius_m, Source& in) {
    InPlane motion;
    if (plane == Plane::Still) return motion;
    motion.velocity = in.pair();
    if (plane == Plane::Rolling) {
        motion.acceleration = in.number() * motion.velocity;
        motion.spin = quarter_turn(motion.velocity) / radius_m;
        motion.spin_rate = quarter_turn(motion.acceleration) / radius_m;
        return motion;
    }
    motion.acceleration = in.pair();
    motion.spin = in.pair();
    motion.spin_rate = plane == Plane::Free
                           ? in.pair()
                           : kSlidingRatio * quarter_turn(motion.acceleration) / radius_m;
    return motion;
}

}  // namespace

std::uint8_t pack(const Segment& segment, const SegmentContext& context,
                  std::vector<float>& numbers) {
    const Plane plane = plane_of(in_plane(segment), context.radius_m);
    const unsigned int height = has_height(segment, context.radius_m) ? kHeight : 0;
    const unsigned int twist = twist_of(segment, context);
    Numbers out(numbers);
    out.put(segment.position_m);
    pack_plane(segment, plane, out);
    if (height != 0) {
        out.put(segment.position_m.z);
        out.put(segment.velocity_mps.z);
        out.put(segment.acceleration_mps2.z);
    }
    if (twist != 0) out.put(segment.spin_radps.z);
    if ((twist & kFreeTwist) != 0) out.put(segment.spin_rate_radps2.z);
    return static_cast<std::uint8_t>(static_cast<unsigned int>(segment.motion) |
                                     static_cast<unsigned int>(plane) << kPlaneShift | height |
                                     twist);
}

std::optional<Segment> unpack(std::uint8_t form, const SegmentContext& context,
                              std::span<const float>& numbers) {
    const unsigned int motion = form & kMotionMask;
    if (motion > static_cast<unsigned int>(Motion::OffTable)) return std::nullopt;
    if ((form & kFreeTwist) != 0 && (form & kTwist) == 0) return std::nullopt;
    Source in(numbers);
    const Vec2 position = in.pair();
    const auto plane = static_cast<Plane>(form >> kPlaneShift & kPlaneMask);
    const InPlane moving = unpack_plane(plane, context.radius_m, in);
    Segment segment{.position_m = {position, context.radius_m},
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
        segment.spin_rate_radps2.z =
            (form & kFreeTwist) != 0 ? in.number() : twist_rate(segment.spin_radps.z, context);
    }
    return in.is_whole() ? std::optional(segment) : std::nullopt;
}

}  // namespace billiards::protocol
