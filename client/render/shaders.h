// Gives the texts of the shaders. Light is linear inside, and takes the screen's gamma at the end.
#pragma once

namespace billiards::client {

/// The lamp over the table is a rectangle; shadows come from a map of the depths that its middle
/// sees. A place is looked up there a little off its surface, which is not to shade itself.
inline constexpr const char* kLitVertex = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
uniform mat4 model;
uniform mat3 model_normal;
uniform mat4 view_projection;
uniform mat4 to_shadow_map;
out vec3 world;
out vec3 world_normal;
out vec2 place;
out vec4 in_lamp;
const float kOffSurface_m = 0.0035;
void main() {
    vec4 at = model * vec4(position, 1.0);
    world = at.xyz;
    world_normal = normalize(model_normal * normal);
    place = uv;
    in_lamp = to_shadow_map * (at + vec4(kOffSurface_m * world_normal, 0.0));
    gl_Position = view_projection * at;
}
)";

/// A driver in software takes both ways of every branch: FINE and GLOSSY are defined, or not, in
/// programs of their own.
inline constexpr const char* kLitFragment = R"(
in vec3 world;
in vec3 world_normal;
in vec2 place;
in vec4 in_lamp;
uniform sampler2D picture;
uniform sampler2DShadow lamp_depths;
uniform vec3 eye;
uniform vec3 lamp;
uniform vec3 half_lamp;
uniform vec3 darkness;
uniform float gloss;
out vec4 color;

const vec3 kLampLight = vec3(1.0, 0.94, 0.84) * 1.75;
const vec3 kSky = vec3(0.30, 0.32, 0.36) * 0.50;
const vec3 kGround = vec3(0.13, 0.15, 0.12) * 0.95;
const float kUnderTable_m = -0.2;
const float kRoomBegins_m2 = 1.5 * 1.5;
const float kRoomEnds_m2 = 5.0 * 5.0;

// The part of the lamp that a place sees: 1 in its light, 0 in shadow, soft at the rim. Beyond the
// map all is light: its border is as far as can be.
float lit_part() {
#ifdef FINE
    vec2 texel = in_lamp.w / vec2(textureSize(lamp_depths, 0));
    float sum = 0.0;
    for (int i = 0; i < 25; ++i) {
        vec2 offset = vec2(i % 5, i / 5) * 1.7 - 3.4;
        sum += textureProj(lamp_depths, in_lamp + vec4(offset * texel, 0.0, 0.0));
    }
    return sum / 25.0;
#else
    return textureProj(lamp_depths, in_lamp);
#endif
}

// What a polished place sees of the lamp and of the room by its reflection.
vec3 reflected(vec3 n, vec3 to_eye) {
    vec3 way = reflect(-to_eye, n);
    vec2 on_lamp = world.xy + way.xy * (lamp.z - world.z) / max(way.z, 0.02);
    vec2 outside = abs(on_lamp) - half_lamp.xy;
    vec2 soft = vec2(mix(0.55, 0.05, gloss));
    vec2 within = 1.0 - smoothstep(-soft, soft, outside);
    float sees_lamp = within.x * within.y * step(0.0, way.z);
    return mix(kGround, kSky, way.z * 0.5 + 0.5) + kLampLight * (1.0 + 7.0 * gloss) * sees_lamp;
}

// From a picture's sRGB to light, within 0.002: a cubic is quicker than a power.
vec3 as_light(vec3 shown) {
    return shown * (shown * (shown * 0.305306011 + 0.682171111) + 0.012522878);
}

// From light to sRGB: bright light does not clip but fades to white, as on film (the curve of
// J. Hejl and R. Burgess-Dawson, which has the screen's gamma in it).
vec3 as_shown(vec3 light) {
    vec3 x = 1.1 * light;
    return (x * (6.2 * x + 0.5)) / (x * (6.2 * x + 1.7) + 0.06);
}

void main() {
    vec3 base = as_light(texture(picture, place).rgb);
    vec3 n = normalize(world_normal);
    // The nearest place of the lamp: it lights the whole length of the table alike.
    vec3 to_lamp = vec3(clamp(world.xy, -half_lamp.xy, half_lamp.xy), lamp.z) - world;
    float distance_2 = dot(to_lamp, to_lamp);
    to_lamp *= inversesqrt(distance_2);

    float facing = max(dot(n, to_lamp), 0.0);
    // The floor sees past the table to one end of the lamp or the other: the map knows its middle.
    float lit = mix(lit_part(), 1.0, world.z < kUnderTable_m ? 0.6 : 0.0);
    vec3 around = mix(kGround, kSky, n.z * 0.5 + 0.5);
    vec3 light = base * (around + kLampLight * facing * lit / (0.25 + 0.55 * distance_2));

#ifdef GLOSSY
    vec3 to_eye = normalize(eye - world);
    float fresnel = 1.0 - max(dot(n, to_eye), 0.0);
    fresnel *= fresnel;
    fresnel *= fresnel;
    float mirror = gloss * (0.05 + 0.6 * fresnel);
    light += mirror * reflected(n, to_eye) * mix(0.35, 1.0, lit);
#endif
    float away = smoothstep(kRoomBegins_m2, kRoomEnds_m2, dot(world.xy, world.xy));
    color = vec4(mix(as_shown(light), darkness, away), 1.0);
}
)";

/// For pictures that darken what lies under them: drawn by multiplication.
inline constexpr const char* kShadeFragment = R"(
in vec2 place;
uniform sampler2D picture;
out vec4 color;
void main() {
    color = vec4(texture(picture, place).rgb, 1.0);
}
)";

inline constexpr const char* kDepthVertex = R"(
layout(location = 0) in vec3 position;
uniform mat4 model;
uniform mat4 view_projection;
void main() {
    gl_Position = view_projection * model * vec4(position, 1.0);
}
)";

inline constexpr const char* kDepthFragment = R"(
void main() {}
)";

}  // namespace billiards::client
