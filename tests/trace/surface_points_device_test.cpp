// Points on visible matter: that they lie on it, evenly, and show the light that leaves it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "shader/statistics.h"
#include "trace/extreme_scenes.h"
#include "trace/gpu_scene.h"

namespace macula::trace {
namespace {

using scenes::grid;
using scenes::volumeOf;
using statistics::kDeviateLimit;

constexpr glm::ivec3 kSize{48, 44, 40};
constexpr double kRadius = 17.0;

// 1000 inside, 0 outside, 500 at `radius` around the origin.
std::shared_ptr<const Volume> ball(double radius, const glm::dvec3& spacingMm = glm::dvec3(1.0)) {
    const glm::dmat4 toWorld = grid(spacingMm, kSize);
    return volumeOf(kSize, toWorld, [=](int i, int j, int k) {
        const double r = glm::length(transformPoint(toWorld, glm::dvec3(i, j, k)));
        return static_cast<std::uint16_t>(std::clamp(500.0 + 500.0 * (radius - r), 0.0, 1000.0));
    });
}

TransferFunction above(double value, double perMm, double albedo = 0.8) {
    TransferFunction function = scenes::homogeneous(perMm, albedo);
    function.opacity = {{value, 0.0}, {value, 0.5}};
    return function;
}

struct Found {
    SurfacePoints points;
    std::vector<glm::dvec3> atMm;  // patient LPS
};

class SurfacePointsTest : public DeviceTest {
  protected:
    static Found find(PathTracer& tracer, const SurfacePointOptions& options) {
        auto result = tracer.surfacePoints(options);
        EXPECT_TRUE(result.ok()) << result.error().message;
        Found found{std::move(result).value(), {}};
        for (const SurfacePoint& p : found.points.points)
            found.atMm.push_back(found.points.originMm + glm::dvec3(p.positionMm));
        return found;
    }
    static PathTracer under(const std::shared_ptr<const Volume>& volume, const TransferFunction& function,
                            const Settings& settings = {.seed = 3}) {
        return tracer(volume, function, Environment::constant(glm::vec3(1.0f)), scenes::lookAt(*volume),
                      settings);
    }
};

// 96 parts of equal area of a sphere, 8 along z and 12 around.
std::vector<double> partsOfSphere(const std::vector<glm::dvec3>& at) {
    std::vector<double> parts(96, 0.0);
    for (const glm::dvec3& p : at) {
        const double z = std::clamp(0.5 + 0.5 * p.z / glm::length(p), 0.0, 0.9999);
        const double turn = 0.5 + std::atan2(p.y, p.x) / (2.0 * std::numbers::pi);
        parts[std::size_t(z * 8.0) * 12 + std::size_t(std::clamp(turn, 0.0, 0.9999) * 12.0)] += 1.0;
    }
    return parts;
}

void expectEvenBall(const Found& found, double perMm) {
    const double count = double(found.atMm.size());
    ASSERT_GT(count, 1900.0);
    ASSERT_LE(count, 2000.0);
    // A ray ends as deep with the probability exp(-depth * perMm) at most: 20 mean free paths none of them.
    double depth = 0.0;
    for (const glm::dvec3& p : found.atMm) {
        EXPECT_NEAR(glm::length(p), kRadius - 10.0 / perMm, 10.0 / perMm + 0.2);  // 0.2: interpolation
        depth += (kRadius - glm::length(p)) / count;
    }
    EXPECT_NEAR(depth, 0.0, 1.0 / perMm + 0.1);
    const std::vector<double> expected(96, count / 96.0);
    // More evenly than chance: that would fail 999 times in 1000.
    EXPECT_LT(statistics::chiSquareDeviate(partsOfSphere(found.atMm), expected), -3.0);
    // The integral of min(2 E2(depth), 1) over a flat surface is 0.90; a visibility of 8 rays is noisy.
    const double sphere = 4.0 * std::numbers::pi * kRadius * kRadius;
    EXPECT_NEAR(found.points.areaMm2 * count / sphere, 0.9, 0.09);
}

TEST_F(SurfacePointsTest, LieEvenlyOnADenseBall) {
    PathTracer t = under(ball(kRadius), above(500, 10.0));
    const Found found = find(t, {.count = 2000, .paths = 32});
    expectEvenBall(found, 10.0);
    double offset = 0.0;
    double extinction = 0.0;
    const double count = double(found.atMm.size());
    for (std::size_t i = 0; i < found.atMm.size(); ++i) {
        const SurfacePoint& p = found.points.points[i];
        EXPECT_NEAR(p.radiusMm, std::sqrt(found.points.areaMm2), 1e-4);
        const glm::dvec3 inwards = -glm::normalize(found.atMm[i]);
        offset += glm::dot(glm::dvec3(p.centreMm), inwards) / double(p.radiusMm) / count;
        extinction += double(p.extinctionPerMm) / count;
    }
    // Nearly half of the ball around each is filled: the middle of that is 3/8 of the radius inwards. They
    // lie a mean free path deep, which is 0.06 of the radius: the middle is 0.02 nearer, and 0.04 more is
    // filled.
    EXPECT_NEAR(offset, 0.375 - 0.02, 0.015);
    EXPECT_NEAR(extinction, 5.0 + 0.3, 0.25);
    EXPECT_EQ(found.points.lostPaths, 0u);
}

TEST_F(SurfacePointsTest, AreEvenWhateverTheVoxels) {
    PathTracer t = under(ball(kRadius, {0.8, 1.0, 2.0}), above(500, 10.0));
    const Found found = find(t, {.count = 2000, .paths = 32});
    expectEvenBall(found, 10.0);
}

TEST_F(SurfacePointsTest, AreInProportionToExtinctionInTranslucentMatter) {
    // Two halves, one twice as dense; both so thin that each place is seen from more than a quarter of all
    // directions.
    const glm::dmat4 toWorld = grid(glm::dvec3(1.0), kSize);
    const auto volume = volumeOf(kSize, toWorld, [](int i, int, int) { return i < kSize.x / 2 ? 100 : 200; });
    TransferFunction function = scenes::homogeneous(1.0);
    function.opacity = {{150.0, 0.005}, {150.0, 0.01}};
    function.density = 1.0;
    PathTracer t = under(volume, function);
    const Found found = find(t, {.count = 2000, .paths = 32});
    ASSERT_GT(found.atMm.size(), 1900u);
    double dense = 0.0;
    for (const glm::dvec3& p : found.atMm) dense += p.x > 0.0 ? 1.0 : 0.0;
    const double count = double(found.atMm.size());
    const double share = std::log1p(-0.01) / (std::log1p(-0.01) + std::log1p(-0.005));
    EXPECT_NEAR(dense / count, share, kDeviateLimit * std::sqrt(share * (1.0 - share) / count));
    // Each place counts in full: the area is the integral of extinction.
    const double voxels = double(kSize.x) * kSize.y * kSize.z;
    const double integral = -0.5 * voxels * (std::log1p(-0.01) + std::log1p(-0.005));
    EXPECT_NEAR(found.points.areaMm2 * count / integral, 1.0, 0.05);
    // And in depth: no part of it has more than another.
    std::vector<double> parts(8, 0.0);
    for (const glm::dvec3& p : found.atMm)
        parts[std::size_t(std::clamp((p.y / kSize.y + 0.5) * 8.0, 0.0, 7.99))] += 1.0;
    EXPECT_LT(statistics::chiSquareDeviate(parts, std::vector<double>(8, count / 8.0)), kDeviateLimit);
}

TEST_F(SurfacePointsTest, NoneInWhatClipAndMaskRemove) {
    const auto volume = ball(kRadius);
    PathTracer t = under(volume, above(500, 10.0));
    Clip clip;
    clip.planes = {{{1.0, 0.0, 0.0}, 3.0}};
    clip.cut = Octant{.pointMm = {8.0, 0.0, 0.0}, .towards = {1, -1, 1}};
    ASSERT_TRUE(t.scene().setClip(clip).ok());
    const Found cut = find(t, {.count = 2000, .paths = 32});
    std::size_t onPlane = 0;
    for (const glm::dvec3& p : cut.atMm) {
        EXPECT_GT(p.x, 3.0 - 1e-3);
        EXPECT_FALSE(p.x > 8.001 && p.y < -1e-3 && p.z > 1e-3) << p.x << ' ' << p.y << ' ' << p.z;
        onPlane += p.x < 3.5 ? 1 : 0;
    }
    // The cut is as visible as the rest: a disc over a cap, less what the octant takes.
    const double disc = kRadius * kRadius - 9.0;
    const double whole = disc + 2.0 * kRadius * (kRadius - 3.0);
    EXPECT_NEAR(double(onPlane) / double(cut.atMm.size()), disc / whole, 0.06);

    std::vector<std::uint16_t> labels;
    for (int k = 0; k < kSize.z; ++k)
        for (int j = 0; j < kSize.y; ++j)
            for (int i = 0; i < kSize.x; ++i) labels.push_back(j < kSize.y / 2 ? 1 : 0);
    auto map = LabelMap::create(kSize, volume->worldFromVoxel(), {{.number = 1, .label = "a"}}, labels);
    Clip masked;
    masked.mask = Mask{std::make_shared<const LabelMap>(std::move(map).value()), {1}, Keep::inside};
    ASSERT_TRUE(t.scene().setClip(masked).ok());
    const Found half = find(t, {.count = 1000, .paths = 32});
    ASSERT_GT(half.atMm.size(), 900u);
    for (const glm::dvec3& p : half.atMm) EXPECT_LT(p.y, 1e-3);  // half way between the voxels

    // What is behind a mask of everything cannot be seen.
    masked.mask->numbers = {7};
    ASSERT_TRUE(t.scene().setClip(masked).ok());
    EXPECT_TRUE(find(t, {.count = 100}).atMm.empty());
}

TEST_F(SurfacePointsTest, LieOnFacesThatShowValues) {
    const auto volume = volumeOf(kSize, grid(glm::dvec3(1.0), kSize), [](int, int, int) { return 750; });
    PathTracer t = under(volume, above(900, 1.0));  // nothing of which can be seen otherwise
    Clip clip;
    clip.planes = {{{1.0, 0.0, 0.0}, 2.5}};
    clip.greyFaces =
        DisplayWindow{.center = 500.0, .width = 1000.0, .explanation = {}, .function = "LINEAR_EXACT"};
    ASSERT_TRUE(t.scene().setClip(clip).ok());
    const Found found = find(t, {.count = 1000, .paths = 32});
    ASSERT_GT(found.atMm.size(), 950u);
    for (std::size_t i = 0; i < found.atMm.size(); ++i) {
        EXPECT_NEAR(found.atMm[i].x, 2.5, 0.02);
        const SurfacePoint& p = found.points.points[i];
        // 0.75 of sRGB is 0.5225 of light, and the tone map takes 0.04 from it.
        EXPECT_NEAR(p.radiance.x, 0.5625, 1e-3);
        EXPECT_GT(p.centreMm.x, 0.2f * p.radiusMm);
    }
    const double area = double(kSize.y) * kSize.z;
    EXPECT_NEAR(found.points.areaMm2 * double(found.atMm.size()) / area, 0.9, 0.1);

    // Matter behind a face is hidden by it: the rest of the dense block is seen at its other sides.
    ASSERT_TRUE(t.scene().setTransferFunction(above(500, 10.0)).ok());
    const Found block = find(t, {.count = 2000, .paths = 32});
    for (std::size_t i = 0; i < block.atMm.size(); ++i) {
        const glm::dvec3& p = block.atMm[i];
        const bool side = p.x > 22.0 || std::abs(p.y) > 20.0 || std::abs(p.z) > 18.0;
        EXPECT_TRUE(side || std::abs(p.x - 2.5) < 0.02) << p.x << ' ' << p.y << ' ' << p.z;
    }
}

double mean(const SurfacePoints& points) {
    double sum = 0.0;
    for (const SurfacePoint& p : points.points) sum += double(p.radiance.y);
    return sum / double(points.points.size());
}

// An even sky, and no loss: what leaves is what comes in.
TEST_F(SurfacePointsTest, ShineLikeTheSkyInAWhiteFurnace) {
    PathTracer t = under(ball(kRadius), above(500, 0.5, 1.0), {.bounces = kMaxBounces, .seed = 4});
    const Found found = find(t, {.count = 500, .paths = 128});
    EXPECT_EQ(found.points.lostPaths, 0u);
    // Of 12 seeds the mean was 0.9995 and the standard deviation 0.012.
    EXPECT_NEAR(mean(found.points), 1.0, kDeviateLimit * 0.012);
}

// Their light is that of the pictures, from wherever it is looked at. They count all directions alike and a
// picture by the cosine, which is some percent for matter that shines nearly as evenly as a sheet of paper.
TEST_F(SurfacePointsTest, ShineAsInPictures) {
    for (const double perMm : {0.05, 10.0}) {
        PathTracer t = under(ball(kRadius), above(500, perMm, 0.8), {.bounces = 4, .seed = 5});
        const double points = mean(find(t, {.count = 1000, .paths = 64}).points);
        double radiance = 0.0;
        double coverage = 0.0;
        for (const ViewDirection from :
             {ViewDirection::anterior, ViewDirection::left, ViewDirection::superior}) {
            const auto volume = ball(kRadius);
            ASSERT_TRUE(
                t.setView(
                     {.camera = frameBox(volume->worldBox(), from, 20.0, 1.0), .width = 32, .height = 32})
                    .ok());
            ASSERT_TRUE(*t.trace(16));
            const auto image = t.readback();
            for (const glm::vec4& pixel : image->radiance) {
                radiance += double(pixel.y);
                coverage += double(pixel.w);
            }
        }
        EXPECT_NEAR(points / (radiance / coverage), 1.0, 0.04) << perMm;
    }
}

TEST_F(SurfacePointsTest, AreOnThePatientsLeftWhereTheMatterIs) {
    const glm::dmat4 toWorld = grid(glm::dvec3(1.0), kSize, {100.0, -50.0, 20.0});
    const auto volume = volumeOf(kSize, toWorld, [](int i, int j, int k) {
        return i >= 40 && i < 44 && j >= 4 && j < 8 && k >= 30 && k < 34 ? 1000 : 0;
    });
    PathTracer t = under(volume, above(500, 10.0));
    const Found found = find(t, {.count = 300, .paths = 32});
    ASSERT_GT(found.atMm.size(), 280u);
    const glm::dvec3 centre = transformPoint(toWorld, {41.5, 5.5, 31.5});
    glm::dvec3 sum(0.0);
    for (const glm::dvec3& p : found.atMm) {
        const glm::dvec3 apart = glm::abs(p - centre);
        EXPECT_LT(std::max({apart.x, apart.y, apart.z}), 2.1);
        sum += p / double(found.atMm.size());
    }
    EXPECT_GT(centre.x, 115.0);  // towards the patient's left
    EXPECT_LT(glm::distance(sum, centre), 0.4);
}

TEST_F(SurfacePointsTest, AreFiniteInExtremeScenes) {
    const auto first = ball(kRadius);
    PathTracer t = under(first, above(500, 1.0));
    for (const scenes::ExtremeScene& scene : scenes::extremeScenes()) {
        ASSERT_TRUE(t.scene().setVolume(scene.volume).ok());
        ASSERT_TRUE(t.scene().setTransferFunction(scene.function).ok());
        ASSERT_TRUE(t.scene().setEnvironment(scene.environment).ok());
        ASSERT_TRUE(t.setView(scene.view).ok());
        const Found found = find(t, {.count = 200, .paths = 32});
        ASSERT_LE(found.atMm.size(), 200u) << scene.name;
        if (scene.name == "all the same value, unseen" || scene.name == "nothing to see") {
            EXPECT_TRUE(found.atMm.empty()) << scene.name;
        } else if (scene.name == "a thousand to one along the view") {
            EXPECT_GT(found.atMm.size(), 10u);  // 1 mm thick, and so faint that one ray in 100 meets it
        } else if (scene.name != "almost nothing" && scene.name != "next to nothing") {
            EXPECT_GT(found.atMm.size(), 150u) << scene.name;
        }
        const float reach = 0.5f * static_cast<float>(scene.volume->worldBox().diagonal()) * 1.0001f;
        for (const SurfacePoint& p : found.points.points) {
            ASSERT_LE(glm::length(p.positionMm), reach) << scene.name;
            ASSERT_TRUE(p.radiusMm > 0.0f && std::isfinite(p.radiusMm)) << scene.name;
            ASSERT_TRUE(p.extinctionPerMm >= 0.0f && std::isfinite(p.extinctionPerMm)) << scene.name;
            for (int i = 0; i < 3; ++i) {
                ASSERT_TRUE(p.radiance[i] >= 0.0f && std::isfinite(p.radiance[i])) << scene.name;
                ASSERT_LE(std::abs(p.centreMm[i]), p.radiusMm) << scene.name;
                for (int j = 0; j < 3; ++j) ASSERT_TRUE(std::isfinite(p.spreadMm2[i][j])) << scene.name;
            }
        }
    }
}

TEST_F(SurfacePointsTest, LieOnTheDensestMatter) {
    PathTracer t = under(ball(kRadius), above(500, 1e3));
    const Found found = find(t, {.count = 100, .paths = 32});
    EXPECT_GT(found.atMm.size(), 90u);
    for (const glm::dvec3& p : found.atMm) EXPECT_NEAR(glm::length(p), kRadius, 0.2);
}

TEST_F(SurfacePointsTest, AreTheSameForASeedAndCanBeCancelled) {
    PathTracer t = under(ball(kRadius), above(500, 10.0));
    const SurfacePointOptions options{.count = 300, .paths = 48};
    const SurfacePoints first = find(t, options).points;
    int asked = 0;
    const auto cancelled = t.surfacePoints(options, [&] { return ++asked < 2; });
    ASSERT_FALSE(cancelled.ok());
    EXPECT_EQ(cancelled.error().code, ErrorCode::cancelled);
    EXPECT_EQ(asked, 2);
    const SurfacePoints again = find(t, options).points;
    ASSERT_EQ(first.points.size(), again.points.size());
    for (std::size_t i = 0; i < first.points.size(); ++i) {
        EXPECT_EQ(first.points[i].positionMm, again.points[i].positionMm);
        EXPECT_EQ(first.points[i].radiance, again.points[i].radiance);
    }
    // A dispatch at a time they are the same; and nothing is gone on with when something else is looked at.
    std::optional<SurfacePoints> inPieces;
    int pieces = 0;
    while (!inPieces) {
        auto some = t.someSurfacePoints(options, [] { return false; });
        ASSERT_TRUE(some.ok()) << some.error().message;
        inPieces = *std::move(some);
        ++pieces;
    }
    EXPECT_GT(pieces, 2);
    ASSERT_EQ(inPieces->points.size(), first.points.size());
    for (std::size_t i = 0; i < first.points.size(); ++i)
        EXPECT_EQ(first.points[i].radiance, inPieces->points[i].radiance);
    ASSERT_TRUE(t.someSurfacePoints(options, [] { return false; }).ok());
    ASSERT_TRUE(t.setSettings({.seed = 99}).ok());
    const auto other = t.someSurfacePoints(options, {});
    ASSERT_TRUE(other.ok() && *other);
    EXPECT_EQ((*other)->points[0].positionMm, find(t, options).points.points[0].positionMm);
    EXPECT_NE(first.points[0].positionMm, find(t, options).points.points[0].positionMm);
    for (const SurfacePointOptions& bad :
         {SurfacePointOptions{.count = 0}, SurfacePointOptions{.count = kMaxSurfacePoints + 1},
          SurfacePointOptions{.paths = 0}, SurfacePointOptions{.candidatesPerPoint = 0}})
        EXPECT_EQ(t.surfacePoints(bad).error().code, ErrorCode::usage);
}

}  // namespace
}  // namespace macula::trace
