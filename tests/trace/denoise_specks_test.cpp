// Pixels that stand out alone after the filter: what of them goes, and what must stay. In double.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "trace/denoise_pictures.h"

namespace macula::trace {
namespace {

// A picture as the filter might leave it: given light, all of one remaining standard deviation.
struct Left {
    TruePicture picture;
    DenoiseGuides guides;
    std::vector<glm::dvec4> masses;
    DenoiseState state;

    Left(const TruePicture& of, double deviation, const std::function<double(int, int)>& light)
        : picture(of), guides(of.guides()) {
        const DenoiseFilm film = of.film(4, 1);
        state = denoisePrepare(of.push(), denoiseGather(of.push(), film, guides, guides, {}), guides, masses);
        for (std::size_t i = 0; i < masses.size(); ++i) {
            const double l = light(int(i) % of.width, int(i) / of.width);
            state.colours[i] = glm::dvec4(l * glm::dvec3(masses[i]), masses[i].w);
            state.noises[i].x = deviation * deviation;
        }
    }
    std::vector<glm::dvec4> shown() const { return denoiseSpecks(picture.push(), state, guides, masses); }
    // Light per mass.
    double lightOf(const std::vector<glm::dvec4>& pixels, int x, int y) const {
        const auto i = std::size_t(y * picture.width + x);
        return pixels[i].y / masses[i].y;
    }
};

TruePicture flat(int width, int height) {
    return {width, height, [](int, int) { return TruePixel{}; }};
}

glm::dvec4 total(const std::vector<glm::dvec4>& pixels) {
    return std::accumulate(pixels.begin(), pixels.end(), glm::dvec4(0.0));
}

// But for rounding.
void expectUnchanged(const Left& left, std::size_t which = 0) {
    const auto shown = left.shown();
    for (std::size_t i = 0; i < shown.size(); ++i) {
        for (int c = 0; c < 4; ++c)
            EXPECT_NEAR(shown[i][c], left.state.colours[i][c], 1e-12) << "case " << which << ", pixel " << i;
    }
}

TEST(DenoiseSpecks, OneIsLimitedToItsNeighboursWhoGetItsLight) {
    for (const double speck : {3.0, 0.2}) {
        const Left left(flat(9, 9), 10.0, [&](int x, int y) { return x == 4 && y == 4 ? speck : 1.0; });
        const auto shown = left.shown();
        EXPECT_NEAR(left.lightOf(shown, 4, 4), 1.0, 1e-12);
        EXPECT_NEAR(left.lightOf(shown, 3, 3), 1.0 + (speck - 1.0) / 8.0, 1e-12);
        EXPECT_NEAR(left.lightOf(shown, 5, 4), 1.0 + (speck - 1.0) / 8.0, 1e-12);
        EXPECT_NEAR(left.lightOf(shown, 6, 4), 1.0, 1e-12);
        EXPECT_NEAR(total(shown).y, total(left.state.colours).y, 1e-12);
    }
}

// So it vanishes as samples come in.
TEST(DenoiseSpecks, ByTwoStandardDeviationsOfItsOwnAtMost) {
    const auto light = [](int x, int y) { return x == 4 && y == 4 ? 3.0 : 1.0; };
    const Left some(flat(9, 9), 0.25, light);
    EXPECT_NEAR(some.lightOf(some.shown(), 4, 4), 2.5, 1e-12);
    const Left none(flat(9, 9), 0.0, light);
    expectUnchanged(none);
    Left certain(flat(9, 9), 10.0, light);
    certain.state.noises[4 * 9 + 4].x = 0.0;  // all but the pixel itself are uncertain
    expectUnchanged(certain);
}

// However noisy: none of their pixels stands out of all its neighbours.
TEST(DenoiseSpecks, LinesEndsCornersAndStepsStay) {
    const std::vector<std::function<bool(int, int)>> shapes{
        [](int, int y) { return y == 6; },                               // a line over all of the picture
        [](int x, int y) { return x == 6 && y > 2 && y < 9; },           // one with two ends
        [](int x, int y) { return x == y; },                             // aslant
        [](int x, int y) { return y == (x + 1) / 2; },                   // in steps
        [](int x, int y) { return (x == 3 && y < 9) || y == 8; },        // with a corner
        [](int x, int y) { return x > 5 && y > 4; },                     // a face
        [](int x, int y) { return x >= 4 && x < 6 && y >= 4 && y < 6; }  // two pixels each way
    };
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        for (const double inside : {2.0, 0.3}) {
            const Left left(flat(13, 13), 10.0, [&](int x, int y) { return shapes[i](x, y) ? inside : 1.0; });
            expectUnchanged(left, i);
        }
    }
}

TEST(DenoiseSpecks, WhatStandsOutOfALineGoesAlongIt) {
    const Left left(flat(13, 13), 10.0, [](int x, int y) { return y != 6 ? 1.0 : x == 6 ? 2.4 : 2.0; });
    const auto shown = left.shown();
    for (int x = 0; x < 13; ++x) {
        EXPECT_NEAR(left.lightOf(shown, x, 5), 1.0, 1e-12) << x;
        EXPECT_NEAR(left.lightOf(shown, x, 7), 1.0, 1e-12) << x;
    }
    EXPECT_LT(left.lightOf(shown, 6, 6), 2.39);
    EXPECT_GT(left.lightOf(shown, 5, 6), 2.005);
    EXPECT_NEAR(left.lightOf(shown, 5, 6), left.lightOf(shown, 7, 6), 1e-12);
}

// What is left of the contrast of a line one pixel wide, of other depth, of what the filter left of it.
double contrastKept(std::uint32_t samples, double angle) {
    constexpr int kSize = 48;
    const auto away = [&](int x, int y) {
        return std::abs((x - kSize / 2) * std::sin(angle) - (y - kSize / 2) * std::cos(angle));
    };
    const double half = 0.5 * std::max(std::abs(std::sin(angle)), std::abs(std::cos(angle)));
    const TruePicture picture(kSize, kSize, [&](int x, int y) {
        TruePixel p;
        if (away(x, y) <= half) {
            p.light = glm::dvec3(2.0);
            p.depthMm = 95.0;
        }
        return p;
    });
    const DenoiseGuides guides = picture.guides();
    const auto contrast = [&](const std::vector<glm::dvec4>& pixels) {
        double line = 0.0;
        double beside = 0.0;
        int inLine = 0;
        int inBeside = 0;
        for (int i = 0; i < kSize * kSize; ++i) {
            const double far = away(i % kSize, i / kSize);
            const double light = pixels[std::size_t(i)].y;
            if (far <= half) line += light, ++inLine;
            if (far > 4.0 && far < 12.0) beside += light, ++inBeside;
        }
        return line / inLine / (beside / inBeside) - 1.0;
    };
    double before = 0.0;
    double after = 0.0;
    for (std::uint32_t seed = 0; seed < 4; ++seed) {
        std::vector<glm::dvec4> masses;
        const DenoiseRecord record =
            denoiseGather(picture.push(), picture.film(samples, seed), guides, guides, {});
        const DenoiseState state = filtered(picture.push(), record, guides, masses);
        before += contrast(filtered(picture.push(), record, guides, masses, Denoising::on, false).colours);
        after += contrast(denoiseSpecks(picture.push(), state, guides, masses));
    }
    EXPECT_GT(before, 0.0);
    return after / before;
}

// Before the filter, by itself.
TEST(DenoiseSpecksFirst, ADotIsLimitedToItsBrightestNeighbour) {
    const auto first = [](double dot, double samples, double noise) {
        const TruePicture picture = flat(9, 9);
        const DenoiseGuides guides = picture.guides();
        const std::size_t count = 81;
        DenoiseRecord record{std::vector<glm::dvec4>(count, glm::dvec4(0.0)),
                             std::vector<glm::dvec2>(count, {1.0, samples})};
        for (std::size_t i = 0; i < count; ++i) record.means[i] = picture.truth(i);
        std::vector<glm::dvec4> masses;
        DenoiseState state = denoisePrepare(picture.push(), record, guides, masses);
        for (int c = 0; c < 3; ++c) state.colours[40][c] *= dot;
        for (glm::dvec4& each : state.noises) each.x = noise;
        const double before = total(state.colours).y;
        const std::vector<glm::dvec4> after =
            denoiseSpecksFirst(picture.push(), record, state, guides, masses);
        EXPECT_NEAR(total(after).y, before, 1e-12 * before);
        EXPECT_GT(after[30].y, state.colours[30].y - 1e-15);
        return after[40].y / picture.truth(40).y;
    };
    EXPECT_NEAR(first(20.0, 1.0, 100.0), 1.0, 1e-9);
    EXPECT_NEAR(first(5.0, 1.0, 100.0), 3.0, 1e-9) << "from four times on, and all from seven times on";
    EXPECT_GT(first(20.0, 1.0, 0.01), 19.0) << "little noise explains little";
    EXPECT_GT(first(20.0, 1e4, 1.0), 19.9) << "so many samples are right";
    EXPECT_DOUBLE_EQ(first(3.9, 1.0, 100.0), 3.9) << "no dot";
}

// By how much the filter takes the middle of 9 x 9 pixels for noisier than its samples tell.
double doubtOf(const std::function<double(int, int)>& light, double samples) {
    const TruePicture picture = flat(9, 9);
    const DenoiseGuides guides = picture.guides();
    DenoiseRecord record;
    for (int i = 0; i < 81; ++i) {
        const glm::dvec4 mean = picture.truth(0) * glm::dvec4(glm::dvec3(light(i % 9, i / 9)), 1.0);
        const double l = glm::dot(glm::dvec3(mean), glm::dvec3(0.2126, 0.7152, 0.0722));
        record.means.push_back(mean);
        record.moments.emplace_back(2.0 * l * l, samples);
    }
    const auto noiseWith = [&](int doubts) {
        shared::DenoisePush push = picture.push();
        push.doubts = doubts;
        std::vector<glm::dvec4> masses;
        return denoisePrepare(push, record, guides, masses).noises[40].x;
    };
    EXPECT_GT(noiseWith(0), 0.0);
    return noiseWith(1) / noiseWith(0);
}

// What a dot adds to the variance hides it as well; light that has structure of its own is not blurred for
// that.
TEST(DenoiseDoubt, IsOfDotsAndNotOfLightThatDiffersFromPixelToPixel) {
    for (const double bright : {1e-6, 1.0, 1e6}) {
        SCOPED_TRACE(bright);
        const auto dots = [&](int x, int y) { return (x == 4 && y == 4 ? 20.0 : 1.0) * bright; };
        EXPECT_NEAR(doubtOf(dots, 1.0), 1.0 + 24.0 / 4.0, 1e-9);
        EXPECT_NEAR(doubtOf(dots, 8.0), 1.0 + 24.0 / 67.0, 1e-9);
        EXPECT_NEAR(doubtOf(dots, 1e4), 1.0, 1e-6);
        EXPECT_GT(
            doubtOf([&](int x, int y) { return (x == 5 && y < 5 && y > 2 ? 20.0 : 1.0) * bright; }, 1.0), 2.0)
            << "two of them, beside the pixel";
        const auto chequered = [&](int x, int y) { return ((x + y) % 2 == 0 ? 1.5 : 0.5) * bright; };
        EXPECT_DOUBLE_EQ(doubtOf(chequered, 1.0), 1.0);
        const auto line = [&](int, int y) { return (y == 4 ? 3.0 : 1.0) * bright; };
        EXPECT_DOUBLE_EQ(doubtOf(line, 1.0), 1.0);
        const auto gap = [&](int x, int y) { return (x == 4 && y == 4 ? 0.0 : 1.0) * bright; };
        EXPECT_DOUBLE_EQ(doubtOf(gap, 1.0), 1.0) << "a dark pixel is no dot";
    }
}

// A sample is as noisy as it is bright here: peaks of the line go too, as peaks elsewhere do.
TEST(DenoiseSpecks, OfANoisyLineLittleIsLost) {
    for (const double angle : {0.0, 0.3, std::numbers::pi / 4}) {
        EXPECT_GT(contrastKept(1, angle), 0.78) << angle;
        EXPECT_GT(contrastKept(4, angle), 0.85) << angle;
        EXPECT_LT(contrastKept(4, angle), 1.05) << angle;
    }
}

// Brighter or darker than each neighbour, by a twelfth of that.
int specksOf(const TruePicture& picture, const std::vector<glm::dvec4>& pixels) {
    int count = 0;
    for (int y = 1; y + 1 < picture.height; ++y) {
        for (int x = 1; x + 1 < picture.width; ++x) {
            double low = 1e30;
            double high = 0.0;
            for (int i = 0; i < 9; ++i) {
                if (i == 4) continue;
                const double other = pixels[std::size_t((y + i / 3 - 1) * picture.width + x + i % 3 - 1)].y;
                low = std::min(low, other);
                high = std::max(high, other);
            }
            const double own = pixels[std::size_t(y * picture.width + x)].y;
            count += own > high * 13.0 / 12.0 || own < low * 11.0 / 12.0 ? 1 : 0;
        }
    }
    return count;
}

TEST(DenoiseSpecks, OfSoftTissueAreFewAndItIsNearerToTheTruth) {
    const TruePicture picture = softTissue(72);
    const DenoiseGuides guides = picture.guides();
    for (const std::uint32_t samples : {1u, 4u, 16u}) {
        std::vector<glm::dvec4> masses;
        const DenoiseRecord record =
            denoiseGather(picture.push(), picture.film(samples, samples), guides, guides, {});
        const DenoiseState state = filtered(picture.push(), record, guides, masses);
        const auto shown = denoiseSpecks(picture.push(), state, guides, masses);
        const auto withSpecks =
            filtered(picture.push(), record, guides, masses, Denoising::on, false).colours;
        ASSERT_GT(specksOf(picture, withSpecks), 40) << samples;
        EXPECT_LT(specksOf(picture, shown), (samples == 1 ? 0.5 : 0.25) * specksOf(picture, withSpecks))
            << samples;
        EXPECT_LT(meanSquaredError(picture, shown), 0.9 * meanSquaredError(picture, withSpecks)) << samples;
        EXPECT_NEAR(total(shown).y / total(withSpecks).y, 1.0, 1e-12) << samples;
    }
}

TEST(DenoiseSpecks, OfWhatHasConvergedNothingChanges) {
    const TruePicture picture = softTissue(40);
    const DenoiseGuides guides = picture.guides();
    constexpr std::uint32_t kSamples = 1u << 13;
    std::vector<glm::dvec4> masses;
    const DenoiseState state =
        filtered(picture.push(), denoiseGather(picture.push(), picture.film(kSamples, 3), guides, guides, {}),
                 guides, masses);
    const auto shown = denoiseSpecks(picture.push(), state, guides, masses);
    double squares = 0.0;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        // In standard errors of the plain mean.
        const double change = (shown[i].y - state.colours[i].y) / picture.truth(i).y * std::sqrt(kSamples);
        EXPECT_LT(std::abs(change), 0.3) << i;
        squares += change * change;
    }
    EXPECT_LT(std::sqrt(squares / double(shown.size())), 0.03);
}

// Nothing flows to or from what is empty, over the edge of the picture, or over a step of depth.
TEST(DenoiseSpecks, StayWhereNothingAroundIsTheSame) {
    const TruePicture dot(9, 9, [](int x, int y) {
        TruePixel p;
        p.coverage = x == 4 && y == 4 ? 1.0 : 0.0;
        return p;
    });
    Left alone(dot, 10.0, [](int x, int y) { return x == 4 && y == 4 ? 3.0 : 0.0; });
    for (std::size_t i = 0; i < alone.masses.size(); ++i) {
        alone.masses[i] = i == 4 * 9 + 4 ? glm::dvec4(0.8, 0.7, 0.6, 1.0) : glm::dvec4(0.0);
        alone.state.colours[i] = 3.0 * alone.masses[i];
    }
    EXPECT_EQ(alone.shown()[4 * 9 + 4].y, alone.state.colours[4 * 9 + 4].y);
    EXPECT_EQ(alone.shown()[4 * 9 + 5], glm::dvec4(0.0));

    const TruePicture step(16, 9, [](int x, int) {
        TruePixel p;
        p.depthMm = x < 8 ? 100.0 : 130.0;
        return p;
    });
    const Left edge(step, 10.0, [](int x, int y) { return x == 7 && y == 4 ? 3.0 : 1.0; });
    const auto shown = edge.shown();
    EXPECT_LT(edge.lightOf(shown, 7, 4), 2.0);  // five of eight neighbours take of it
    EXPECT_GT(edge.lightOf(shown, 6, 4), 1.1);
    EXPECT_NEAR(edge.lightOf(shown, 8, 4), 1.0, 1e-9);

    const TruePicture thin(9, 9, [](int x, int) {
        TruePixel p;
        p.coverage = x == 4 ? 0.2 : 1.0;
        return p;
    });
    const Left veil(thin, 10.0, [](int x, int y) { return x == 4 && y == 4 ? 3.0 : 1.0; });
    const auto kept = veil.shown();
    for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(kept[i].w, veil.state.colours[i].w) << i;
    EXPECT_NEAR(total(kept).y, total(veil.state.colours).y, 1e-10);
}

TEST(DenoiseSpecks, TakesPicturesOfAnyShapeAndWhateverNoiseIsToldOf) {
    for (const auto& [width, height] :
         {std::pair(1, 1), std::pair(1, 17), std::pair(23, 1), std::pair(2, 2), std::pair(3, 2)}) {
        for (const double deviation : {0.0, 1.0, 1e15, std::numeric_limits<double>::infinity(),
                                       std::numeric_limits<double>::quiet_NaN()}) {
            const Left left(flat(width, height), deviation,
                            [](int x, int y) { return (x * 7 + y * 5) % 3 == 0 ? 1e9 : 1.0; });
            const auto shown = left.shown();
            for (const glm::dvec4& pixel : shown) {
                ASSERT_TRUE(std::isfinite(pixel.x + pixel.y + pixel.z + pixel.w)) << deviation;
                ASSERT_GE(std::min({pixel.x, pixel.y, pixel.z}), 0.0);
            }
            EXPECT_NEAR(total(shown).y / total(left.state.colours).y, 1.0, 1e-9);
            if (width * height == 1) {
                EXPECT_EQ(shown, left.state.colours);
            }
        }
    }
}

}  // namespace
}  // namespace macula::trace
