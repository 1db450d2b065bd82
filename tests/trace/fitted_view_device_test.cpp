// Views that fit: what is seen fills nine tenths of the picture, and is in the middle of it.
#include <algorithm>

#include "base/phantom.h"
#include "presets/catalogue.h"
#include "trace/gpu_scene.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

// Of what hides more than a part of what is behind it.
struct Silhouette {
    glm::dvec2 low{1e9};  // pixels
    glm::dvec2 high{-1e9};
};
Silhouette silhouetteOf(const std::vector<double>& alpha, const glm::ivec2& sizePx, double least) {
    Silhouette found;
    for (int y = 0; y < sizePx.y; ++y) {
        for (int x = 0; x < sizePx.x; ++x) {
            if (alpha[std::size_t(y * sizePx.x + x)] <= least) continue;
            found.low = glm::min(found.low, glm::dvec2(x, y));
            found.high = glm::max(found.high, glm::dvec2(x, y) + 1.0);
        }
    }
    return found;
}

// A ball of 9 mm beside the middle of a volume of 96 x 144 x 120 mm.
std::shared_ptr<const Volume> smallBall(double spacingMm) {
    const glm::dvec3 spacing = spacingMm * glm::dvec3(1.0, 1.5, 1.25);
    const glm::ivec3 size(96.0 / spacingMm);
    const glm::dmat4 toWorld =
        affine({spacing.x, 0, 0}, {0, spacing.y, 0}, {0, 0, spacing.z}, {10.0, -20.0, 30.0});
    return scenes::volumeOf(size, toWorld, [=](int i, int j, int k) {
        const glm::dvec3 mm = spacing * glm::dvec3(i, j, k) - glm::dvec3(30.3, 100.2, 80.7);
        return static_cast<std::uint16_t>(std::clamp(1000.0 + 100.0 * (9.0 - glm::length(mm)), 0.0, 4000.0));
    });
}

class FittedViewOf : public DeviceTest {
  protected:
    static PathTracer tracerOf(const std::shared_ptr<const Volume>& volume,
                               const TransferFunction& function) {
        return tracer(volume, function, Environment::constant(glm::vec3(1.0f)), {}, {.bounces = 1});
    }
    static void expectFits(PathTracer& t, bool isThin, const glm::ivec2& sizePx, ViewDirection from,
                           const std::string& what) {
        const auto outline = t.outlineMm();
        ASSERT_TRUE(outline.ok());
        const Camera camera =
            framePoints(*outline, standardBasis(from), 30.0, double(sizePx.x) / double(sizePx.y));
        ASSERT_TRUE(t.setView({.camera = camera, .width = sizePx.x, .height = sizePx.y}).ok());
        // What is thin has specks of noise around it where it is traced, and is marched instead.
        std::vector<double> alpha;
        if (isThin) {
            const auto guides = t.readGuides();
            ASSERT_TRUE(guides.ok());
            for (const GuidePixel& pixel : *guides) alpha.push_back(pixel.coverage);
        } else {
            ASSERT_TRUE(*t.trace(8));
            const auto image = t.readback();
            ASSERT_TRUE(image.ok());
            for (const glm::vec4& pixel : image->radiance) alpha.push_back(pixel.a);
        }
        const Silhouette seen = silhouetteOf(alpha, sizePx, isThin ? 0.05 : 0.2);
        const glm::dvec2 part = (seen.high - seen.low) / glm::dvec2(sizePx);
        EXPECT_GE(std::max(part.x, part.y), 0.88) << what;
        EXPECT_LE(std::max(part.x, part.y), 0.92) << what;
        // In the middle.
        const glm::dvec2 aside = (seen.low + seen.high) / glm::dvec2(sizePx) - 1.0;
        EXPECT_LT(std::abs(aside.x), 0.04) << what;
        EXPECT_LT(std::abs(aside.y), 0.04) << what;
    }
};

constexpr std::array<ViewDirection, 6> kSides{ViewDirection::anterior, ViewDirection::posterior,
                                              ViewDirection::left,     ViewDirection::right,
                                              ViewDirection::superior, ViewDirection::inferior};

TEST_F(FittedViewOf, ASmallBallBesideTheMiddle) {
    TransferFunction dense = scenes::homogeneous(3.0);
    dense.opacity = {{1000, 0.0}, {1000, 0.5}};
    for (const double spacingMm : {1.0, 3.0}) {
        PathTracer t = tracerOf(smallBall(spacingMm), dense);
        for (const glm::ivec2& sizePx : {glm::ivec2(100, 100), glm::ivec2(150, 90), glm::ivec2(90, 120)}) {
            if (spacingMm > 1.0 && sizePx.x != 150) continue;  // one shape will do
            for (const ViewDirection from :
                 {ViewDirection::anterior, ViewDirection::left, ViewDirection::superior})
                expectFits(t, false, sizePx, from,
                           std::to_string(spacingMm) + " " + std::to_string(sizePx.x) + " from " +
                               std::to_string(int(from)));
        }
    }
}

TEST_F(FittedViewOf, ThePhantomUnderPresets) {
    const auto volume = std::make_shared<const Volume>(
        phantom::make({.size = {128, 112, 80}, .spacingMm = {2.4, 2.4, 3.75}}));
    const auto presets = presets::builtInPresets();
    ASSERT_TRUE(presets.ok());
    int drawn = 0;
    for (const TransferFunction& preset : *presets) {
        if (preset.name != "cinematic-chest" && preset.name != "cinematic-bone") continue;
        ++drawn;
        const bool isThin = preset.name == "cinematic-chest";
        PathTracer t = tracerOf(volume, preset);
        for (const ViewDirection from : kSides)
            expectFits(t, isThin, {200, 200}, from, preset.name + " " + std::to_string(int(from)));
        ASSERT_TRUE(t.scene().setClip({.planes = {{{1, 0, 0}, 0.0}}}).ok());
        expectFits(t, isThin, {200, 200}, ViewDirection::anterior, preset.name + " half");
    }
    EXPECT_EQ(drawn, 2);
}

TEST_F(FittedViewOf, NothingIsNothing) {
    const auto volume = smallBall(3.0);
    TransferFunction nothing = scenes::homogeneous(3.0);
    nothing.opacity = {{60000, 0.0}, {60000, 0.5}};
    PathTracer t = tracer(volume, nothing, Environment::constant(glm::vec3(1.0f)), {}, {});
    EXPECT_TRUE(t.outlineMm()->empty());
    EXPECT_FALSE(PathTracer::create(device())->outlineMm().ok());
    // What a face of a clip may show counts.
    const Clip faces{.planes = {{{0, 1, 0}, 60.0}},
                     .greyFaces = DisplayWindow{.center = 1000, .width = 10, .function = "LINEAR_EXACT"}};
    ASSERT_TRUE(t.scene().setClip(faces).ok());
    EXPECT_FALSE(t.outlineMm()->empty());
}

}  // namespace
}  // namespace macula::trace
