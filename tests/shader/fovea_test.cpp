// The map of a foveated picture, its inverse, and its measure.
#include <gtest/gtest.h>

#include <random>

#include "shader/shader_lib.h"

namespace macula {
namespace {

template <class Lib>
class FoveaMap : public ::testing::Test {
  protected:
    using vec2 = typename Lib::vec2;
    using Real = typename Lib::vec2::value_type;
    using Fovea = typename Lib::Fovea;

    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    // Of any field of view, shape of picture, and gaze.
    Fovea any() {
        const double height = std::tan(between(0.001, 1.4));
        const vec2 half(Real(height * between(0.3, 3.0)), Real(height));
        const vec2 gaze(Real(between(-0.98, 0.98)) * half.x, Real(between(-0.98, 0.98)) * half.y);
        const double room = std::min(half.x - std::abs(gaze.x), half.y - std::abs(gaze.y));
        return {half, gaze, Real(room * between(0.0, 0.8)), Real(between(1.0, 16.0))};
    }
    vec2 anyPoint(const Fovea& f) { return vec2(Real(between(-1, 1)), Real(between(-1, 1))) * f.halfSize; }

    Lib lib;
    std::mt19937 engine_{31};
};

using Libs = ::testing::Types<ShaderLibSingle, ShaderLibTwofold>;
TYPED_TEST_SUITE(FoveaMap, Libs);

TYPED_TEST(FoveaMap, InverseIsExact) {
    const double tolerance = sizeof(typename TestFixture::Real) == 4 ? 1e-5 : 1e-12;
    double largest = 0.0;
    for (int trial = 0; trial < 20000; ++trial) {
        const auto fovea = this->any();
        const auto point = this->anyPoint(fovea);
        const double size = glm::length(glm::dvec2(fovea.halfSize));
        const auto seen = this->lib.seenFromStored(fovea, point);
        const auto back = this->lib.storedFromSeen(fovea, seen);
        largest = std::max(largest, glm::length(glm::dvec2(back) - glm::dvec2(point)) / size);
        const auto stored = this->lib.storedFromSeen(fovea, point);
        const auto again = this->lib.seenFromStored(fovea, stored);
        largest = std::max(largest, glm::length(glm::dvec2(again) - glm::dvec2(point)) / size);
        // And both stay in the picture.
        EXPECT_LE(std::abs(seen.x), fovea.halfSize.x * (1 + tolerance));
        EXPECT_LE(std::abs(stored.y), fovea.halfSize.y * (1 + tolerance));
    }
    EXPECT_LT(largest, tolerance);
}

TYPED_TEST(FoveaMap, GazeAndBorderStayAndTheFoveaIsMagnified) {
    using Point = typename TestFixture::vec2;
    for (int trial = 0; trial < 1000; ++trial) {
        const auto fovea = this->any();
        const double size = fovea.halfSize.x + fovea.halfSize.y;
        EXPECT_EQ(this->lib.seenFromStored(fovea, fovea.gaze), fovea.gaze);
        EXPECT_EQ(this->lib.storedFromSeen(fovea, fovea.gaze), fovea.gaze);
        const Point border(fovea.halfSize.x, this->anyPoint(fovea).y);
        EXPECT_NEAR(glm::length(this->lib.seenFromStored(fovea, border) - border), 0.0, 1e-5 * size);
        const Point near = fovea.gaze + Point(0.7 * fovea.radius);
        EXPECT_NEAR(glm::length(this->lib.seenFromStored(fovea, near) - fovea.gaze),
                    std::sqrt(2.0) * 0.7 * fovea.radius / fovea.magnification, 1e-5 * size);
    }
}

TEST(Fovea, ScaleHasNoStep) {
    ShaderLibTwofold lib;
    const ShaderLibTwofold::Fovea fovea{{1.2, 0.7}, {0.3, -0.2}, 0.25, 2.5};
    const glm::dvec2 along(std::cos(0.7), std::sin(0.7));
    const auto q = [&](double r) {
        return glm::length(lib.seenFromStored(fovea, fovea.gaze + along * r) - fovea.gaze);
    };
    constexpr double h = 1e-6;
    double before = (q(0.25 - h) - q(0.25 - 2 * h)) / h;
    const double after = (q(0.25 + 2 * h) - q(0.25 + h)) / h;
    EXPECT_NEAR(before, 0.4, 1e-6);
    EXPECT_NEAR(after, before, 1e-4);
    for (double r = 0.25; r < 0.8; r += 0.01) {  // and grows from there
        const double slope = (q(r + h) - q(r)) / h;
        EXPECT_GE(slope, before - 1e-6);
        before = slope;
    }
}

// The weights of the pixels are the solid angle of the picture, and each is the Jacobian of the map.
TEST(Fovea, SolidAnglesAddUpToThePicture) {
    ShaderLibTwofold lib;
    for (const double magnification : {1.0, 1.5, 4.0}) {
        const ShaderLibTwofold::Fovea fovea{{1.2, 0.7}, {0.5, -0.3}, 0.2, magnification};
        constexpr int kWidth = 1200;
        constexpr int kHeight = 700;
        const double pixel = 2.4 / kWidth * 1.4 / kHeight;
        double sum = 0.0;
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x)
                sum += lib.seenSolidAngle(fovea,
                                          {2.4 * (x + 0.5) / kWidth - 1.2, 1.4 * (y + 0.5) / kHeight - 0.7}) *
                       pixel;
        }
        const double exact = 4.0 * std::atan(1.2 * 0.7 / std::sqrt(1 + 1.2 * 1.2 + 0.7 * 0.7));
        EXPECT_NEAR(sum / exact, 1.0, 1e-4) << magnification;
        for (const glm::dvec2 at : {glm::dvec2(0.55, -0.31), glm::dvec2(-0.4, 0.2), glm::dvec2(1.1, 0.6)}) {
            constexpr double h = 1e-6;
            const glm::dvec2 dx = (lib.seenFromStored(fovea, at + glm::dvec2(h, 0)) -
                                   lib.seenFromStored(fovea, at - glm::dvec2(h, 0))) /
                                  (2 * h);
            const glm::dvec2 dy = (lib.seenFromStored(fovea, at + glm::dvec2(0, h)) -
                                   lib.seenFromStored(fovea, at - glm::dvec2(0, h))) /
                                  (2 * h);
            const glm::dvec2 seen = lib.seenFromStored(fovea, at);
            const double area = std::abs(dx.x * dy.y - dx.y * dy.x);
            EXPECT_NEAR(lib.seenSolidAngle(fovea, at) / (area / std::pow(1 + glm::dot(seen, seen), 1.5)), 1.0,
                        1e-6);
        }
    }
}

}  // namespace
}  // namespace macula
