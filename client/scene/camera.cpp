// Takes angles and a distance; gives the matrices of a perspective view.
#include "client/scene/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace billiards::client {

namespace {

using std::numbers::pi;

constexpr double kFieldOfView_rad = 0.70;  // About 40 degrees, upright.
constexpr double kNarrowestAspect = 1.3;   // Of a table view that shows the whole table.
constexpr double kNear_m = 0.05;
constexpr double kFar_m = 30.0;
constexpr double kLowest_rad = 0.08;
constexpr double kHighest_rad = pi / 2 - 1e-3;  // Straight down, "up" would have no direction.
constexpr double kNearest_m = 0.25;
constexpr double kFarthest_m = 6.0;
constexpr double kZoomPerStep = 0.88;
constexpr double kFarthestPoint_m = 20.0;

struct View {
    double azimuth_rad;
    double elevation_rad;
    double zoom;  ///< Distance over the one from which the whole table is seen.
};
constexpr std::array kViews{
    View{pi, 0.62, 1.0},        // Behind the head end.
    View{-pi / 2, 0.55, 0.95},  // From the side.
    View{pi, 0.26, 0.62},       // Low, behind the cue.
    View{0.0, 0.62, 1.0},       // From the foot end.
};

}  // namespace

Camera::Camera(base::Vec2 half_table_m) : half_table_m_(half_table_m) {
    reset();
}

/// Far enough for the long side from the head end, and from the side.
double Camera::whole_table_m() const {
    return 1.6 * (half_table_m_.x + half_table_m_.y);
}

void Camera::reset() {
    view_ = kViews.size() - 1;
    next_view();
}

void Camera::next_view() {
    view_ = (view_ + 1) % kViews.size();
    azimuth_rad_ = kViews[view_].azimuth_rad;
    elevation_rad_ = kViews[view_].elevation_rad;
    distance_m_ = kViews[view_].zoom * whole_table_m();
}

void Camera::look_from_above() {
    azimuth_rad_ = -pi / 2;
    elevation_rad_ = kHighest_rad;
    const double half_height_m = std::max(half_table_m_.y, half_table_m_.x / kNarrowestAspect);
    distance_m_ = 1.05 * half_height_m / std::tan(kFieldOfView_rad / 2);
}

void Camera::orbit(double azimuth_rad, double elevation_rad) {
    azimuth_rad_ = std::remainder(azimuth_rad_ + azimuth_rad, 2 * pi);
    elevation_rad_ = std::clamp(elevation_rad_ + elevation_rad, kLowest_rad, kHighest_rad);
}

void Camera::zoom(double steps) {
    distance_m_ = std::clamp(distance_m_ * std::pow(kZoomPerStep, steps), kNearest_m, kFarthest_m);
}

void Camera::reset_zoom() {
    distance_m_ = whole_table_m();
}

void Camera::follow(const std::optional<base::Vec3>& target_m) {
    target_m_ = target_m.value_or(base::Vec3{});
}

base::Vec3 Camera::eye_m() const {
    const double level_m = distance_m_ * std::cos(elevation_rad_);
    return target_m_ + base::Vec3{level_m * std::cos(azimuth_rad_),
                                  level_m * std::sin(azimuth_rad_),
                                  distance_m_ * std::sin(elevation_rad_)};
}

glm::mat4 Camera::view() const {
    return glm::lookAt(glm::vec3(eye_m()), glm::vec3(target_m_), glm::vec3(0.0F, 0.0F, 1.0F));
}

glm::mat4 Camera::projection(double aspect) const {
    return glm::mat4(glm::perspective(kFieldOfView_rad, aspect, kNear_m, kFar_m));
}

std::optional<base::Vec2> Camera::point_at(base::Vec2 place, double aspect, double height_m) const {
    const glm::dmat4 to_screen = glm::dmat4(projection(aspect)) * glm::dmat4(view());
    const glm::dvec4 far = glm::inverse(to_screen) * glm::dvec4(place, 1.0, 1.0);
    const base::Vec3 eye = eye_m();
    const base::Vec3 ray = base::Vec3(far) / far.w - eye;
    if (ray.z >= 0.0) return std::nullopt;
    const base::Vec3 point = eye + ray * ((height_m - eye.z) / ray.z);
    const bool is_in_room =
        std::fabs(point.x) < kFarthestPoint_m && std::fabs(point.y) < kFarthestPoint_m;
    return is_in_room ? std::optional(base::Vec2(point)) : std::nullopt;
}

std::optional<base::Vec2> Camera::place_of(const base::Vec3& point_m, double aspect) const {
    const glm::dvec4 at =
        glm::dmat4(projection(aspect)) * glm::dmat4(view()) * glm::dvec4(point_m, 1.0);
    if (at.w <= kNear_m) return std::nullopt;
    return base::Vec2(at) / at.w;
}

}  // namespace billiards::client
