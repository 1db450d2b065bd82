#include "pipeline/splat/files/spz.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "base/phantom.h"
#include "base/worst.h"
#include "pipeline/splat/files/gzip.h"
#include "splat/model_support.h"

namespace macula::splat {
namespace {

std::vector<std::byte> packed(const std::vector<std::uint8_t>& data, const std::string& comment = {}) {
    auto result = gzip(std::as_bytes(std::span(data)), comment);
    EXPECT_TRUE(result.ok());
    return *result;
}

std::vector<std::uint8_t> unpacked(const std::vector<std::byte>& bytes, std::size_t size) {
    std::vector<std::uint8_t> data(size);
    Gunzip stream(bytes);
    EXPECT_TRUE(stream.read(std::as_writable_bytes(std::span(data))) && stream.rest(0).has_value());
    return data;
}

Splats there(const Splats& splats, SpzVersion version = SpzVersion::zstd) {
    const auto file = encodeSpz(splats, version);
    EXPECT_TRUE(file.ok());
    const auto read = decodeSpz(file->bytes);
    EXPECT_TRUE(read.ok()) << read.error().message;
    return read->splats;
}

double sRgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

// The bounds that spz.h states.
TEST(Spz, RoundTripKeepsWhatItSays) {
    for (int degree = 0; degree <= kMaxShDegree; ++degree) {
        for (const ColourSpace space : {ColourSpace::linear, ColourSpace::display}) {
            Splats splats = testing::randomModel(2000, degree, 11);
            splats.colourSpace = space;
            splats.lowPass = kLowPasses[(2 * std::size_t(degree) + std::size_t(space)) % kLowPasses.size()];
            const SpzVersion version = degree % 2 == 0 ? SpzVersion::zstd : SpzVersion::gzip;
            const auto file = encodeSpz(splats, version);
            ASSERT_TRUE(file.ok());
            EXPECT_EQ(file->clamped, 0u);
            const auto read = decodeSpz(file->bytes);
            ASSERT_TRUE(read.ok()) << read.error().message;
            const Splats& s = read->splats;
            EXPECT_EQ(s.originMm, splats.originMm);
            EXPECT_EQ(s.axes, Axes::patientLps);
            EXPECT_EQ(s.colourSpace, space);
            EXPECT_EQ(s.lowPass, splats.lowPass);
            ASSERT_EQ(s.shDegree, degree);
            ASSERT_EQ(s.size(), splats.size());
            for (std::size_t i = 0; i < s.size(); ++i) {
                for (int c = 0; c < 3; ++c) {
                    // 300 mm leaves 14 fractional bits; float32 adds its own rounding.
                    ASSERT_NEAR(s.position[i][c], splats.position[i][c], std::ldexp(1.0, -15) + 2e-5);
                    ASSERT_NEAR(s.logScale[i][c], splats.logScale[i][c], 1.0 / 32 + 1e-6);
                    const double before = 0.5 + 0.28209479 * splats.dc[i][c];
                    const double after = 0.5 + 0.28209479 * s.dc[i][c];
                    if (space == ColourSpace::display) {
                        ASSERT_NEAR(after, before, 0.0037);
                    } else {
                        ASSERT_NEAR(sRgb(after), sRgb(before), 0.0037);
                    }
                }
                const auto opacity = [](float logit) {
                    return 1 / (1 + std::exp(-static_cast<double>(logit)));
                };
                ASSERT_NEAR(opacity(s.opacityLogit[i]), opacity(splats.opacityLogit[i]), 1.0 / 510 + 1e-6);
            }
            for (std::size_t k = 0; k < s.sh.size(); ++k) {
                for (int c = 0; c < 3; ++c) {
                    // What is kept is the coefficient times the slope of its colour, which is 1 or at
                    // least 0.44.
                    const double bound = space == ColourSpace::display ? 1.0 / 256 : 1.0 / 256 / 0.44;
                    ASSERT_NEAR(s.sh[k][c], splats.sh[k][c], bound + 1e-6);
                }
            }
        }
    }
}

// Two angles: of the axes of a splat before and after.
TEST(Spz, RotationsAreOffByLittle) {
    const Splats splats = testing::randomModel(5000, 0, 13);
    const Splats s = there(splats);
    double worst = 0.0;
    for (std::size_t i = 0; i < s.size(); ++i) {
        const glm::dvec4 a = glm::normalize(glm::dvec4(splats.rotation[i]));
        const glm::dvec4 b = glm::normalize(glm::dvec4(s.rotation[i]));
        // std::min gives its first one where that is not a number.
        worst = test::worse(worst, 2.0 * std::acos(std::min(std::abs(glm::dot(a, b)), 1.0)));
    }
    RecordProperty("worst_rotation_rad", std::to_string(worst));
    EXPECT_LT(worst, 0.0048);
}

TEST(Spz, SecondTripChangesNothingMore) {
    Splats splats = testing::randomModel(500, 1, 17);
    splats.colourSpace = ColourSpace::display;
    const Splats once = there(splats);
    const Splats twice = there(once);
    EXPECT_TRUE(testing::sameBits(once.position, twice.position));
    EXPECT_TRUE(testing::sameBits(once.logScale, twice.logScale));
    EXPECT_TRUE(testing::sameBits(once.opacityLogit, twice.opacityLogit));
    EXPECT_TRUE(testing::sameBits(once.dc, twice.dc));
    EXPECT_TRUE(testing::sameBits(once.sh, twice.sh));
    EXPECT_EQ(encodeSpz(splats)->bytes, encodeSpz(splats)->bytes);
    const auto gzipped = encodeSpz(splats, SpzVersion::gzip)->bytes;
    EXPECT_EQ(gzipped, encodeSpz(splats, SpzVersion::gzip)->bytes);
    EXPECT_TRUE(testing::sameBits(decodeSpz(gzipped)->splats, once));  // both say the same
}

// One splat in each version, with bytes worked out by hand from the format's description.
std::vector<std::uint8_t> byHand(std::uint8_t version) {
    std::vector<std::uint8_t> data{'N', 'G', 'S', 'P', version, 0, 0, 0, 1, 0, 0, 0, 1, 8, 1, 0};
    const auto add = [&](std::initializer_list<int> bytes) {
        for (const int b : bytes) data.push_back(static_cast<std::uint8_t>(b));
    };
    if (version == 1)
        add({0x00, 0x3e, 0x00, 0xc0, 0x00, 0x34});  // halves 1.5, -2, 0.25
    else
        add({0x80, 0x01, 0x00, 0x00, 0xfe, 0xff, 0x40, 0x00, 0x00});  // 384, -512, 64 of 256
    add({51});                                                        // opacity 0.2
    add({255, 0, 51});                                                // dc 3.333, -3.333, -2
    add({160, 176, 144});                                             // scales 1, e, 1/e
    if (version < 3)
        add({255, 127, 128});  // (0, 1, ~0, ~0)
    else
        add({0x69, 0xa5, 0x95, 0x36});               // see below
    add({0, 128, 192, 64, 128, 160, 255, 96, 128});  // -1 0 .5, -.5 0 .25, ~1 -.25 0
    return data;
}

// The splat of version 3 as version 4 has it, with a record of somebody else before the table. Each stream is
// a zstd frame (RFC 8878) of one raw block: no library is needed to write it.
std::vector<std::byte> containerByHand() {
    std::vector<std::uint8_t> data = byHand(3);
    const std::vector<std::uint8_t> body(data.begin() + 16, data.end());
    data.resize(16);
    data[4] = 4;
    data[14] |= 2;  // has records
    data[15] = 6;   // streams
    const auto add = [&](std::initializer_list<int> bytes) {
        for (const int b : bytes) data.push_back(static_cast<std::uint8_t>(b));
    };
    add({32 + 12, 0, 0, 0});  // where the table lies
    data.resize(32);
    add({2, 0, 0xbe, 0xad, 4, 0, 0, 0, 1, 2, 3, 4});  // a type, 4 bytes
    const std::array<int, 6> sizes{9, 1, 3, 3, 4, 9};
    constexpr int kFrame = 9;
    for (const int size : sizes) add({size + kFrame, 0, 0, 0, 0, 0, 0, 0, size, 0, 0, 0, 0, 0, 0, 0});
    auto next = body.begin();
    for (const int size : sizes) {
        add({0x28, 0xb5, 0x2f, 0xfd, 0x20, size});  // magic, one segment, its size
        add({size << 3 | 1, 0, 0});                 // the last block, raw
        data.insert(data.end(), next, next + size);
        next += size;
    }
    const auto bytes = std::as_bytes(std::span(data));
    return {bytes.begin(), bytes.end()};
}

TEST(Spz, ReadsAllVersions) {
    for (const std::uint8_t version : {1, 2, 3, 4}) {
        const auto read = decodeSpz(version == 4 ? containerByHand() : packed(byHand(version)));
        ASSERT_TRUE(read.ok()) << read.error().message;
        const Splats& s = read->splats;
        ASSERT_EQ(s.size(), 1u);
        EXPECT_EQ(s.axes, Axes::unknown);
        EXPECT_EQ(s.colourSpace, ColourSpace::display);
        EXPECT_EQ(s.lowPass, LowPass::compensated);  // by the flag
        EXPECT_EQ(s.position[0], glm::vec3(1.5f, 2.0f, -0.25f));
        EXPECT_NEAR(s.opacityLogit[0], std::log(0.25), 1e-6);
        EXPECT_NEAR(s.dc[0].x, 10.0 / 3, 1e-5);
        EXPECT_NEAR(s.dc[0].y, -10.0 / 3, 1e-5);
        EXPECT_NEAR(s.dc[0].z, -2.0, 1e-5);
        EXPECT_EQ(s.logScale[0], glm::vec3(0, 1, -1));
        // Bands of y, z, x: the first two have changed their sign.
        EXPECT_EQ(s.sh[0], glm::vec3(1.0f, 0.0f, -0.5f));
        EXPECT_EQ(s.sh[1], glm::vec3(0.5f, 0.0f, -0.25f));
        EXPECT_EQ(s.sh[2], glm::vec3(127 / 128.0f, -0.25f, 0.0f));
        if (version < 3) {
            EXPECT_NEAR(std::abs(s.rotation[0][1]), 1.0, 1e-4);
        } else {
            // x is the largest; y = -361, z = +361, w = +361 of 511 / sqrt(2): 0.5 each but for rounding.
            // Then y and z turn.
            EXPECT_NEAR(s.rotation[0][1], 0.5, 2e-3);
            EXPECT_NEAR(s.rotation[0][2], 0.5, 2e-3);
            EXPECT_NEAR(s.rotation[0][3], -0.5, 2e-3);
            EXPECT_NEAR(s.rotation[0][0], 0.5, 2e-3);
        }
    }
}

TEST(Spz, OursIsLaidOutAsTheFormatSays) {
    Splats splats;
    splats.colourSpace = ColourSpace::display;
    splats.shDegree = 1;
    splats.resize(1);
    splats.position[0] = glm::vec3(1.5f, 2.0f, -0.25f);
    splats.opacityLogit[0] = std::log(0.25f);
    splats.dc[0] = glm::vec3(3.3f, -3.3f, -2.0f);
    splats.logScale[0] = glm::vec3(0, 1, -1);
    splats.rotation[0] = glm::vec4(0.99f, 1, 0.99f, -0.99f);
    splats.sh = {{1.0f, 0.0f, -0.5f}, {0.5f, 0.0f, -0.25f}, {127 / 128.0f, -0.25f, 0.0f}};
    const auto file = encodeSpz(splats, SpzVersion::gzip);
    ASSERT_TRUE(file.ok());
    EXPECT_EQ(file->clamped, 0u);
    std::vector<std::uint8_t> expected = byHand(3);
    const std::vector<std::uint8_t> data = unpacked(file->bytes, expected.size());
    expected[13] = 20;  // fractional bits; so 20 instead of 8
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int fixed = std::array{384, -512, 64}[axis] * 4096;
        for (std::size_t k = 0; k < 3; ++k)
            expected[16 + 3 * axis + k] =
                static_cast<std::uint8_t>((static_cast<unsigned>(fixed) >> (8 * k)) & 255u);
    }
    expected[16 + 10] = 254;
    expected[16 + 11] = 1;
    // 0.99 / |q| = 0.4975 = 359.5 of 511 / sqrt(2): the rotation is compared by value elsewhere.
    for (std::size_t k = 0; k < data.size(); ++k) {
        if (k >= 32 && k < 36) continue;
        EXPECT_EQ(int{data[k]}, int{expected[k]}) << k;
    }
    EXPECT_EQ(data[35] >> 6, 0);  // x is the largest
}

// What others look at of a file of version 4: header, the zone of records, table, and where the streams end.
TEST(Spz, ContainerIsLaidOutAsTheFormatSays) {
    for (const int degree : {0, 1}) {
        const std::vector<std::byte> bytes = encodeSpz(testing::randomModel(200, degree, 53))->bytes;
        const auto number = [&](std::size_t at, std::size_t size) {
            std::uint64_t value = 0;
            for (std::size_t k = 0; k < size; ++k)
                value |= std::to_integer<std::uint64_t>(bytes[at + k]) << (8 * k);
            return value;
        };
        const std::size_t streams = degree == 0 ? 5 : 6;
        EXPECT_EQ(number(0, 4), 0x5053474eu);
        EXPECT_EQ(number(4, 4), 4u);
        EXPECT_EQ(number(8, 4), 200u);
        EXPECT_EQ(number(12, 1), std::uint64_t(degree));
        EXPECT_EQ(number(14, 1), 3u);  // antialiased, has records
        EXPECT_EQ(number(15, 1), streams);
        const std::size_t table = number(16, 4);
        EXPECT_EQ(number(20, 8) | number(28, 4), 0u);
        EXPECT_EQ(table, 32 + 8 + number(36, 4));  // one record, which fills the zone
        EXPECT_NE(number(32, 4) >> 16, 0u);        // its vendor, who is neither Adobe nor Niantic
        EXPECT_NE(number(32, 4) >> 16, 0xadbeu);
        EXPECT_NE(number(32, 4) >> 16, 0x4e41u);
        const std::array<std::uint64_t, 6> unpacked{1800, 200, 600, 600, 800, 1800};
        std::size_t end = table + 16 * streams;
        for (std::size_t k = 0; k < streams; ++k) {
            EXPECT_EQ(number(table + 16 * k + 8, 8), unpacked[k]);
            EXPECT_EQ(number(end, 4), 0xfd2fb528u);  // a zstd frame
            end += number(table + 16 * k, 8);
        }
        EXPECT_EQ(end, bytes.size());
    }
}

// The left marker of the phantom stays in it, and seen from any side a model has the colours and shape
// that it had.
TEST(Spz, LeftStaysLeft) {
    Splats splats = testing::randomModel(40, 3, 19);
    splats.colourSpace = ColourSpace::display;
    splats.originMm = glm::dvec3(3, -4, 5);
    const double half = phantom::markerHalfEdgeMm();
    for (glm::vec3& p : splats.position)
        p = glm::vec3(phantom::markerCentreMm() - splats.originMm + 0.003 * half * glm::dvec3(p));
    ASSERT_GT(phantom::markerCentreMm().x, 0.0);
    const Splats s = there(splats);
    constexpr double kThird = 0.57735026918962576;
    const std::array<glm::dvec3, 6> directions{
        {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0.6, 0.8, 0}, {0, 0.6, -0.8}, {kThird, -kThird, kThird}}};
    for (std::size_t i = 0; i < s.size(); ++i) {
        const glm::dvec3 world = s.originMm + glm::dvec3(s.position[i]);
        EXPECT_EQ(phantom::valueHu(world), 1000);
        EXPECT_NE(phantom::valueHu({-world.x, world.y, world.z}), 1000);
        for (const glm::dvec3& d : directions) {
            const glm::dvec3 difference = testing::colourAlong(s, i, d) - testing::colourAlong(splats, i, d);
            // 15 coefficients, each off by 1/256 at most, and the constant one.
            EXPECT_LT(glm::length(difference), 0.04) << i;
            const double before = glm::dot(d, testing::covariance(splats, i) * d);
            const double after = glm::dot(d, testing::covariance(s, i) * d);
            const glm::vec3 widths = glm::exp(2.0f * splats.logScale[i]);
            const double widest = std::max({widths.x, widths.y, widths.z});
            EXPECT_NEAR(after, before, 0.07 * before + 0.008 * widest) << i;
        }
    }
}

// What others read: x as it is, y up and z back; the same hand.
TEST(Spz, FileIsRightHanded) {
    Splats splats;
    splats.resize(3);
    splats.position = {{100, 0, 0}, {0, 100, 0}, {0, 0, 100}};
    const std::vector<std::uint8_t> data = unpacked(encodeSpz(splats, SpzVersion::gzip)->bytes, 16 + 3 * 20);
    glm::dmat3 axes(0.0);
    for (std::size_t i = 0; i < 9; ++i) {
        std::uint32_t raw = 0;
        for (std::size_t k = 0; k < 3; ++k) raw |= std::uint32_t{data[16 + 3 * i + k]} << (8 + 8 * k);
        axes[static_cast<int>(i / 3)][static_cast<int>(i % 3)] = static_cast<std::int32_t>(raw) / 256.0;
    }
    axes /= std::ldexp(1.0, data[13]);
    EXPECT_EQ(axes[0], glm::dvec3(100, 0, 0));
    EXPECT_EQ(axes[1], glm::dvec3(0, -100, 0));
    EXPECT_EQ(axes[2], glm::dvec3(0, 0, -100));
    EXPECT_GT(glm::determinant(axes), 0.0);
}

TEST(Spz, TransportTakesFewBytes) {
    const auto plain = encodeSpz(testing::randomModel(10000, 0, 23));
    const auto first = encodeSpz(testing::randomModel(10000, 1, 23));
    ASSERT_TRUE(plain.ok() && first.ok());
    RecordProperty("bytes_per_splat_degree_0", std::to_string(plain->bytes.size() / 10000.0));
    RecordProperty("bytes_per_splat_degree_1", std::to_string(first->bytes.size() / 10000.0));
    // Random numbers are the worst there are: nothing is found in them.
    EXPECT_LT(plain->bytes.size(), 205000u);
    EXPECT_LT(first->bytes.size(), 295000u);
}

TEST(Spz, WhatDoesNotFitIsClampedAndCounted) {
    Splats splats = testing::randomModel(6, 1, 29);
    splats.logScale[0].y = -12.0f;
    splats.dc[1].z = 100.0f;
    splats.sh[3 * 2 + 1].x = 50.0f;
    splats.opacityLogit[3] = 80.0f;  // reads as almost 1
    const auto file = encodeSpz(splats);
    ASSERT_TRUE(file.ok());
    EXPECT_EQ(file->clamped, 3u);
    const Splats s = decodeSpz(file->bytes)->splats;
    EXPECT_EQ(s.logScale[0].y, -10.0f);
    EXPECT_GT(s.opacityLogit[3], 6.9f);
    splats.position[0].x = 9e6f;
    EXPECT_FALSE(encodeSpz(splats).ok());
    splats.position[0].x = 8e6f;
    EXPECT_NEAR(there(splats).position[0].x, 8e6f, 0.5f);
}

}  // namespace
}  // namespace macula::splat
