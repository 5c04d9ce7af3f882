// Takes what hands do to the view; gives where the eye is and what it sees.
#pragma once

#include "common/base/vec.h"

#include <glm/mat4x4.hpp>
#include <optional>

namespace billiards::client {

/// An eye that turns about a point on the table. It stays above the bed, within the room and out of
/// the target, whatever hands do.
class Camera {
  public:
    /// Half the length and width of the table's outer rail: it is what must be seen as a whole.
    explicit Camera(base::Vec2 half_table_m);

    /// The original's "Reset Camera": from behind the head end, over the whole table.
    void reset();
    /// From straight above.
    void look_from_above();
    /// The next of a few good places, over and over.
    void next_view();

    /// Turns by azimuth, counterclockwise seen from above, and raises by elevation.
    void orbit(double azimuth_rad, double elevation_rad);
    /// Steps of a wheel; above zero is nearer.
    void zoom(double steps);
    void reset_zoom();
    /// What it turns about; the middle of the table where there is no ball to follow.
    void follow(const std::optional<base::Vec3>& target_m);

    double azimuth_rad() const { return azimuth_rad_; }
    double elevation_rad() const { return elevation_rad_; }
    double distance_m() const { return distance_m_; }
    const base::Vec3& target_m() const { return target_m_; }
    base::Vec3 eye_m() const;

    friend bool operator==(const Camera&, const Camera&) = default;

    glm::mat4 view() const;
    glm::mat4 projection(double aspect) const;

    // Places on the screen run from (-1, -1), lower left, to (1, 1), upper right.

    /// Where the ray through a place on the screen meets the level at this height; none where it
    /// does not within the room.
    std::optional<base::Vec2> point_at(base::Vec2 place, double aspect, double height_m) const;
    /// None behind the eye.
    std::optional<base::Vec2> place_of(const base::Vec3& point_m, double aspect) const;

  private:
    double whole_table_m() const;

    base::Vec2 half_table_m_;
    base::Vec3 target_m_{};
    double azimuth_rad_ = 0.0;
    double elevation_rad_ = 0.0;
    double distance_m_ = 0.0;
    std::size_t view_ = 0;
};

}  // namespace billiards::client
