// What a scene says of itself: where it is seen, and by which key its pictures are kept.
#include "pipeline/hybrid/views/traced_scene.h"

#include <gtest/gtest.h>

#include <set>

#include "trace/extreme_scenes.h"

namespace macula::hybrid {
namespace {

using scenes::blob;
using scenes::grid;
using scenes::ramp;

constexpr glm::ivec3 kSize{32, 24, 16};

std::shared_ptr<const Volume> volume(std::uint16_t high = 1000) {
    return scenes::volumeOf(kSize, grid(glm::dvec3(2.0), kSize), blob(kSize, high));
}

std::string keyOf(const std::shared_ptr<const Volume>& of, const TransferFunction& function, const Clip& clip,
                  const trace::Environment& lights, const trace::View& view, const trace::Settings& settings,
                  std::uint32_t samples) {
    const auto scene = TracedScene::create(of, function, clip, lights);
    EXPECT_TRUE(scene.ok());
    const auto key = scene->pictureKey(view, settings, samples);
    EXPECT_TRUE(key.ok());
    return *key;
}

TEST(TracedScene, KeysTellApartAllThatAPictureDependsOn) {
    const auto of = volume();
    const TransferFunction function = ramp(100, 900, 0.3, 1.0);
    const auto lights = trace::Environment::constant(glm::vec3(1.0f));
    const trace::View view = scenes::lookAt(*of);
    const auto base = [&] { return keyOf(of, function, {}, lights, view, {}, 64); };
    EXPECT_EQ(base(), base());
    EXPECT_EQ(base(), keyOf(volume(), function, {}, lights, view, {}, 64)) << "an equal volume";

    std::set<std::string> keys{base()};
    keys.insert(keyOf(volume(999), function, {}, lights, view, {}, 64));
    keys.insert(keyOf(of, ramp(100, 901, 0.3, 1.0), {}, lights, view, {}, 64));
    TransferFunction coloured = function;
    coloured.colour.front().colour.g *= 0.5;
    keys.insert(keyOf(of, coloured, {}, lights, view, {}, 64));
    TransferFunction forward = function;
    forward.anisotropy = 0.3;
    keys.insert(keyOf(of, forward, {}, lights, view, {}, 64));
    Clip ball;
    ball.ball = Ball{.centreMm = {}, .radiusMm = 10.0};
    keys.insert(keyOf(of, function, ball, lights, view, {}, 64));
    ball.removedCastsShadow = true;
    keys.insert(keyOf(of, function, ball, lights, view, {}, 64));
    keys.insert(
        keyOf(of, function, {}, trace::Environment::constant(glm::vec3(1.0f, 1.0f, 0.9f)), view, {}, 64));
    trace::View other = view;
    other.camera.positionMm.x += 1.0;
    keys.insert(keyOf(of, function, {}, lights, other, {}, 64));
    other = view;
    ++other.width;
    keys.insert(keyOf(of, function, {}, lights, other, {}, 64));
    other = view;
    other.camera.verticalFovDeg += 0.1;
    keys.insert(keyOf(of, function, {}, lights, other, {}, 64));
    keys.insert(keyOf(of, function, {}, lights, view, {.bounces = 5}, 64));
    keys.insert(keyOf(of, function, {}, lights, view, {.seed = 1}, 64));
    keys.insert(keyOf(of, function, {}, lights, view, {.filter = trace::Filter::stochastic}, 64));
    keys.insert(keyOf(of, function, {}, lights, view, {.denoising = trace::Denoising::on}, 64));
    keys.insert(keyOf(of, function, {}, lights, view, {.denoising = trace::Denoising::little}, 64));
    keys.insert(keyOf(of, function, {}, lights, view, {}, 65));
    EXPECT_EQ(keys.size(), 17u);
    for (const std::string& key : keys) EXPECT_EQ(key.size(), 64u);
}

// Labels of the left half: what a mask hides is not seen, and it counts in the key.
TEST(TracedScene, MasksAndClipsBoundWhatIsSeenEvenIfTheyCastShadow) {
    const auto of = volume();
    const TransferFunction function = ramp(100, 900, 0.3, 1.0);
    const auto lights = trace::Environment::constant(glm::vec3(1.0f));
    const Box all = TracedScene::create(of, function, {}, lights)->seenMm();
    std::vector<std::uint16_t> labels(of->voxelCount());
    for (std::size_t i = 0; i < labels.size(); ++i) labels[i] = i % 32 < 8 ? 1 : 0;
    Clip clip;
    clip.mask = Mask{.labels = std::make_shared<const LabelMap>(*LabelMap::create(
                         kSize, of->worldFromVoxel(), {{.number = 1, .label = "half"}}, labels)),
                     .numbers = {1}};
    clip.removedCastsShadow = true;
    const auto masked = TracedScene::create(of, function, clip, lights);
    ASSERT_TRUE(masked.ok());
    EXPECT_LT(masked->seenMm().high.x, all.high.x - 16.0);
    EXPECT_EQ(masked->seenMm().low.x, all.low.x);
    const trace::View view = scenes::lookAt(*of);
    EXPECT_NE(*masked->pictureKey(view, {}, 1), keyOf(of, function, {}, lights, view, {}, 1));
}

TEST(TracedScene, OfNothingTheBoxIsEmpty) {
    const auto scene = TracedScene::create(volume(), ramp(2000, 3000, 0.3, 1.0), {},
                                           trace::Environment::constant(glm::vec3(1.0f)));
    ASSERT_TRUE(scene.ok());
    EXPECT_GT(scene->seenMm().low.x, scene->seenMm().high.x);
}

}  // namespace
}  // namespace macula::hybrid
