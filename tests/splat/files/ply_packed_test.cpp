// The packed PLY of SuperSplat, packed here by its definition: numbers come back to the step that their bits
// have.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <sstream>

#include "pipeline/splat/files/ply.h"
#include "pipeline/splat/model/constant_colour.h"

namespace macula::splat {
namespace {

constexpr int kSplats = 300;  // more than one chunk

struct Made {
    glm::vec3 position, logScale, colour;
    glm::vec4 rotation;  // w, x, y, z
    float opacity;
};

Made made(int n) {
    const float t = float(n) / float(kSplats);
    const glm::vec4 turn(std::cos(9.0f * t), std::sin(7.0f * t), std::cos(5.0f * t + 1.0f), 0.3f - t);
    return {{-5.0f + 10.0f * t, 20.0f * t * t, 3.0f - t},
            {-4.0f + t, -3.0f - t, -2.0f},
            {0.1f + 0.8f * t, 0.5f, 1.0f - t},
            glm::normalize(turn),
            0.05f + 0.9f * t};
}

const glm::vec3 kLow(-5.0f, 0.0f, 2.0f);
const glm::vec3 kHigh(5.0f, 20.0f, 3.0f);
const glm::vec3 kLowScale(-4.0f, -4.0f, -2.5f);
const glm::vec3 kHighScale(-3.0f, -3.0f, -1.5f);

std::uint32_t unorm(float value, int bits) {
    const float most = float((1u << bits) - 1);
    return std::uint32_t(std::lround(std::clamp(value, 0.0f, 1.0f) * most));
}

std::uint32_t packed111011(const glm::vec3& share) {
    return unorm(share.x, 11) << 21 | unorm(share.y, 10) << 11 | unorm(share.z, 11);
}

std::uint32_t packedRotation(glm::vec4 q) {
    int largest = 0;
    for (int n = 1; n < 4; ++n)
        if (std::abs(q[n]) > std::abs(q[largest])) largest = n;
    if (q[largest] < 0.0f) q = -q;
    auto word = std::uint32_t(largest);
    for (int n = 0; n < 4; ++n)
        if (n != largest) word = word << 10 | unorm(q[n] / std::sqrt(2.0f) + 0.5f, 10);
    return word;
}

template <class T>
void put(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

std::string file(bool hasColourBounds, bool hasSh, int chunks = 2) {
    std::string header =
        "ply\nformat binary_little_endian 1.0\nelement chunk " + std::to_string(chunks) + "\n";
    for (const char* bound : {"min", "max", "min_scale", "max_scale"})
        for (const char* axis : {"x", "y", "z"})
            header += "property float " + std::string(bound) + "_" + axis + "\n";
    for (const char* bound : {"min", "max"})
        for (const char* channel : {"r", "g", "b"})
            if (hasColourBounds) header += "property float " + std::string(bound) + "_" + channel + "\n";
    header += "element vertex " + std::to_string(kSplats) + "\n";
    for (const char* word : {"position", "rotation", "scale", "color"})
        header += "property uint packed_" + std::string(word) + "\n";
    if (hasSh) header += "element sh " + std::to_string(kSplats) + "\n";
    for (int n = 0; n < 9 && hasSh; ++n) header += "property uchar f_rest_" + std::to_string(n) + "\n";
    std::string bytes = header + "end_header\n";
    for (int chunk = 0; chunk < chunks; ++chunk) {
        for (const glm::vec3& bound : {kLow, kHigh, kLowScale, kHighScale})
            for (int axis = 0; axis < 3; ++axis) put(bytes, bound[axis]);
        for (int n = 0; n < 6 && hasColourBounds; ++n) put(bytes, n < 3 ? 0.0f : 2.0f);
    }
    for (int n = 0; n < kSplats; ++n) {
        const Made m = made(n);
        const glm::vec3 colour = hasColourBounds ? 0.5f * m.colour : m.colour;
        put(bytes, packed111011((m.position - kLow) / (kHigh - kLow)));
        put(bytes, packedRotation(m.rotation));
        put(bytes, packed111011((m.logScale - kLowScale) / (kHighScale - kLowScale)));
        put(bytes, unorm(colour.x, 8) << 24 | unorm(colour.y, 8) << 16 | unorm(colour.z, 8) << 8 |
                       unorm(m.opacity, 8));
    }
    for (int n = 0; n < kSplats && hasSh; ++n)
        for (int k = 0; k < 9; ++k) bytes += char(k == 4 ? 255 : k == 8 ? 0 : 128);
    return bytes;
}

Result<ModelFile> parse(const std::string& bytes) {
    std::istringstream stream(bytes);
    return readPly(stream, bytes.size());
}

TEST(PlyPacked, IsReadToTheStepOfItsBits) {
    for (const bool hasColourBounds : {false, true}) {
        const auto model = parse(file(hasColourBounds, true));
        ASSERT_TRUE(model) << model.error().message;
        const Splats& splats = model->splats;
        ASSERT_EQ(splats.size(), std::size_t(kSplats));
        ASSERT_EQ(splats.shDegree, 1);
        for (int n = 0; n < kSplats; ++n) {
            const Made m = made(n);
            const auto i = std::size_t(n);
            const glm::vec3 step = (kHigh - kLow) / glm::vec3(2047.0f, 1023.0f, 2047.0f);
            EXPECT_TRUE(glm::all(glm::lessThan(glm::abs(splats.position[i] - m.position), 0.51f * step)))
                << n;
            EXPECT_LT(glm::length(splats.logScale[i] - m.logScale), 1e-3f) << n;
            const float same = std::abs(glm::dot(splats.rotation[i], m.rotation));
            EXPECT_GT(same, 0.99999f) << n << ": the same turn";
            const glm::vec3 colour = colourOfDc(splats.dc[i]);
            EXPECT_LT(glm::length(colour - m.colour), hasColourBounds ? 0.008f : 0.004f) << n;
            const float opacity = 1.0f / (1.0f + std::exp(-splats.opacityLogit[i]));
            EXPECT_NEAR(opacity, m.opacity, 0.002f) << n;
            // Channel by channel: the fifth is the second coefficient of green, the last the third of blue.
            EXPECT_NEAR(splats.sh[3 * i + 1].y, 4.0f, 1e-5f);
            EXPECT_NEAR(splats.sh[3 * i + 2].z, -4.0f, 1e-5f);
            EXPECT_NEAR(splats.sh[3 * i].x, 0.0157f, 1e-3f);
        }
    }
}

TEST(PlyPacked, DamagedOnesAreRefused) {
    const std::string whole = file(true, false);
    ASSERT_TRUE(parse(whole));
    const auto refused = [](const std::string& bytes) {
        const auto model = parse(bytes);
        return !model && model.error().code == ErrorCode::inputNotUsable;
    };
    for (std::size_t bytes = 0; bytes < whole.size(); bytes += 97)
        EXPECT_TRUE(refused(whole.substr(0, bytes)));
    EXPECT_TRUE(refused(file(true, false, 1))) << "one chunk for 300 splats";
    std::string changed = whole;
    changed.replace(changed.find("packed_scale"), 12, "packed_scull");
    EXPECT_TRUE(refused(changed));
    changed = whole;
    changed.replace(changed.find("min_scale_y"), 11, "mix_scale_y");
    EXPECT_TRUE(refused(changed));
    changed = whole;
    changed.replace(changed.find("vertex 300"), 10, "vertex 999999999999");
    EXPECT_TRUE(refused(changed));
    // Bounds that are no numbers make splats that are none.
    changed = whole;
    const float nan = std::nanf("");
    std::memcpy(&changed[changed.find("end_header\n") + 11], &nan, sizeof nan);
    EXPECT_TRUE(refused(changed));
}

}  // namespace
}  // namespace macula::splat
