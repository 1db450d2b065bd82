#version 460
// A picture of one slice of a volume: samples a 3D image, writes a 2D one.
layout(local_size_x = 8, local_size_y = 4) in;

layout(binding = 0) uniform sampler3D volume;
layout(binding = 1, rgba8) uniform writeonly image2D picture;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(picture);
    if (any(greaterThanEqual(pixel, size))) return;
    vec2 where = (vec2(pixel) + 0.5) / vec2(size);
    float value = textureLod(volume, vec3(where, 0.5), 0.0).r;
    imageStore(picture, pixel, vec4(where.x, where.y, value, 1.0));
}
