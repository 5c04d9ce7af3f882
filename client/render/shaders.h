// Gives the texts of the shaders. Light is linear inside, and takes the screen's gamma at the end.
#pragma once

namespace billiards::client {

/// The lamp over the table is a rectangle; shadows come from a map of the depths that its middle
/// sees.
inline constexpr const char* kLitVertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
uniform mat4 model;
uniform mat3 model_normal;
uniform mat4 view_projection;
uniform mat4 lamp_view_projection;
out vec3 world;
out vec3 world_normal;
out vec2 place;
out vec4 in_lamp;
void main() {
    vec4 at = model * vec4(position, 1.0);
    world = at.xyz;
    world_normal = model_normal * normal;
    place = uv;
    in_lamp = lamp_view_projection * at;
    gl_Position = view_projection * at;
}
)";

inline constexpr const char* kLitFragment = R"(#version 330 core
in vec3 world;
in vec3 world_normal;
in vec2 place;
in vec4 in_lamp;
uniform sampler2D picture;
uniform sampler2DShadow lamp_depths;
uniform vec3 eye;
uniform vec3 lamp;
uniform float gloss;
out vec4 color;

const vec3 kLampLight = vec3(1.0, 0.95, 0.86) * 2.6;
const vec3 kSky = vec3(0.30, 0.33, 0.40) * 0.55;
const vec3 kGround = vec3(0.16, 0.12, 0.09) * 0.45;

// The part of the lamp that a place sees: 1 in its light, 0 in shadow, soft at the rim.
float lit_part() {
    vec3 at = in_lamp.xyz / in_lamp.w * 0.5 + 0.5;
    if (any(lessThan(at, vec3(0.0))) || any(greaterThan(at, vec3(1.0)))) return 1.0;
    float step = 1.1 / float(textureSize(lamp_depths, 0).x);
    float sum = 0.0;
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            sum += texture(lamp_depths, vec3(at.xy + vec2(x, y) * step, at.z - 0.0006));
        }
    }
    return sum / 9.0;
}

// Bright light does not clip but fades to white; then the screen's gamma.
vec3 as_shown(vec3 light) {
    return pow(1.0 - exp(-1.6 * light), vec3(1.0 / 2.2));
}

void main() {
    vec3 base = texture(picture, place).rgb;
    vec3 n = normalize(world_normal);
    vec3 to_eye = normalize(eye - world);
    vec3 to_lamp = lamp - world;
    float distance = length(to_lamp);
    to_lamp /= distance;

    float fall_off = 1.0 / (0.35 + 0.5 * distance * distance);
    float facing = max(dot(n, to_lamp), 0.0);
    float lit = facing > 0.0 ? lit_part() : 0.0;
    vec3 around = mix(kGround, kSky, n.z * 0.5 + 0.5);

    vec3 half_way = normalize(to_lamp + to_eye);
    float shine = gloss * pow(max(dot(n, half_way), 0.0), mix(24.0, 220.0, gloss)) * lit;
    float rim = gloss * 0.22 * pow(1.0 - max(dot(n, to_eye), 0.0), 4.0);
    vec3 light = base * (around + kLampLight * facing * lit * fall_off);
    color = vec4(as_shown(light + kLampLight * shine * 0.5 + kSky * rim), 1.0);
}
)";

inline constexpr const char* kDepthVertex = R"(#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 model;
uniform mat4 view_projection;
void main() {
    gl_Position = view_projection * model * vec4(position, 1.0);
}
)";

inline constexpr const char* kDepthFragment = R"(#version 330 core
void main() {}
)";

}  // namespace billiards::client
