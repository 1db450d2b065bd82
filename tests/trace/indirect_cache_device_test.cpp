// The cache of indirect light: what it knows, what it does to pictures, and when it is left alone.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "pipeline/gpu/transfer.h"
#include "pipeline/trace/accumulation.h"
#include "pipeline/trace/device_scene.h"
#include "pipeline/trace/reference_tracer.h"
#include "trace/gpu_scene.h"
#include "trace/small_scenes.h"

namespace macula::trace {
namespace {

using Content = IndirectCache::Content;

// A scene and its cache, traced as PathTracer does it.
class Cached {
  public:
    Cached(const std::shared_ptr<gpu::Device>& device, const scenes::SmallScene& scene)
        : scene_(scene),
          device_(std::make_shared<DeviceScene>(device)),
          kernels_(device),
          accumulation_(device),
          view_(*SceneView::create(device_)) {
        EXPECT_TRUE(device_->setVolume(scene.volume).ok());
        EXPECT_TRUE(device_->setEnvironment(scene.environment()).ok());
        EXPECT_TRUE(device_->setTransferFunction(scene.function).ok());
        EXPECT_TRUE(device_->setClip(scene.clip).ok());
    }

    IndirectCache& cache() { return device_->indirect(); }
    const shared::TraceParams& params() const { return view_.params(); }

    // Of a picture; row 0 on top.
    std::vector<glm::vec4> sums(const Settings& settings, std::uint32_t samples) {
        EXPECT_TRUE(view_.look(scene_.view, settings).ok());
        EXPECT_TRUE(cache().prepare({.sceneEdition = device_->edition(), .bounces = settings.bounces}).ok());
        EXPECT_TRUE(accumulation_.begin(scene_.view.width, scene_.view.height).ok());
        TraceVariant variant = variantOf(settings, kindOf(*device_));
        variant.usesIndirect = settings.indirect != Indirect::traced;
        constexpr std::uint32_t kOfPass = 4;  // the longest paths are not lost to the device's limit then
        for (std::uint32_t done = 0; done < samples; done += kOfPass) {
            accumulation_.plan().beginEven(std::min(kOfPass, samples - done));
            while (accumulation_.plan().hasPass())
                EXPECT_TRUE(accumulation_.step(view_, kernels_, variant, settings.bounces, 1000.0).ok());
        }
        const auto faults = accumulation_.film().faults();
        EXPECT_EQ(faults->nonFinite + faults->abandoned + faults->aboveBound, 0u);
        return *gpu::read<glm::vec4>(accumulation_.film().sums());
    }

    // Fills it with what the paths of some pictures find.
    void fill(Settings settings, int pictures, std::uint32_t samples) {
        for (int i = 0; i < pictures; ++i) {
            settings.seed = std::uint32_t(1000 + i);
            (void)sums(settings, samples);
        }
    }

  private:
    const scenes::SmallScene& scene_;
    std::shared_ptr<DeviceScene> device_;
    TraceKernels kernels_;
    Accumulation accumulation_;
    SceneView view_;
};

scenes::SmallScene whiteFurnace() {
    scenes::SmallScene scene = scenes::smallScenes().front();
    scene.function = scenes::ramp(80, 900, 0.4, 1.0);
    scene.function.colour = {{0.0, {1, 1, 1}}};
    scene.function.albedo = 1.0;
    scene.sky = {.width = 4, .height = 2, .radiance = std::vector<glm::vec3>(8, glm::vec3(1.0f))};
    scene.bounces = 1024;
    return scene;
}

Settings of(const scenes::SmallScene& scene, Indirect indirect, std::uint32_t seed = 1) {
    Settings settings = scene.settings(Look::cinematic, Filter::trilinear, seed);
    settings.indirect = indirect;
    return settings;
}

glm::dvec3 lightOf(const std::vector<glm::vec4>& sums) {
    glm::dvec3 light(0.0);
    for (const glm::vec4& sum : sums) light += glm::dvec3(sum);
    return light;
}

// Samples and light of all cells.
struct All {
    double cells = 0.0;
    double samples = 0.0;
    glm::dvec3 light{0.0};
};
All allOf(const Content& content, double unit) {
    All all;
    for (std::size_t i = 0; i < content.cells.size(); ++i) {
        EXPECT_EQ(content.tags[i] == 0, content.cells[i].w == 0);
        if (content.tags[i] == 0) continue;
        all.cells += 1.0;
        all.samples += content.cells[i].w;
        all.light += glm::dvec3(content.cells[i]) * unit;
    }
    return all;
}

class IndirectCacheTest : public DeviceTest {};

// Light that comes from everywhere and is never absorbed is 1 everywhere, and so is what its cells know.
// What is scattered once is not indirect: a vertex sees the sky past the matter.
TEST_F(IndirectCacheTest, KnowsTheLightOfAWhiteFurnace) {
    const scenes::SmallScene scene = whiteFurnace();
    Cached cached(device(), scene);
    const Settings settings = of(scene, Indirect::cached);
    // The direct and the indirect light of a vertex are 1 together.
    Settings once = settings;
    once.bounces = 1;
    const std::vector<glm::vec4> direct = cached.sums(once, 512);
    const Content nothing{
        .tags = std::vector<std::uint32_t>(shared::kIndirectBuckets * shared::kIndirectWays),
        .cells = std::vector<glm::uvec4>(shared::kIndirectBuckets * shared::kIndirectWays)};
    All all;
    for (std::uint32_t seed = 1; seed <= 40; ++seed) {
        // An empty one each time: where much is known, fewer paths go on to tell more.
        ASSERT_TRUE(cached.cache().prepare({.sceneEdition = seed}).ok());
        ASSERT_TRUE(cached.cache().write(nothing).ok());
        (void)cached.sums(of(scene, Indirect::cached, seed), 1);
        const All found = allOf(*cached.cache().read(), double(cached.params().indirectUnit));
        EXPECT_LT(found.cells, 2.0 * found.samples);
        all.samples += found.samples;
        all.light += found.light;
    }
    ASSERT_GT(all.samples, 2000.0);
    double coverage = 0.0;
    for (const glm::vec4& sum : direct) coverage += double(sum.a);
    const double indirect = 1.0 - lightOf(direct).r / coverage;
    EXPECT_GT(indirect, 0.15);
    EXPECT_NEAR(all.light.r / all.samples, indirect, 0.03);
    EXPECT_EQ(all.light.r, all.light.b);

    const std::vector<glm::vec4> last = cached.sums(settings, 512);
    double covered = 0.0;
    for (const glm::vec4& sum : last) covered += double(sum.a);
    EXPECT_NEAR(lightOf(last).g / covered, 1.0, 0.03);
}

// The same random numbers and the same table: the same samples, but for the few that a rounding sends
// elsewhere.
TEST_F(IndirectCacheTest, PathsEndInItAsThoseOfTheReference) {
    for (const std::size_t which : {0, 3, 6}) {
        const scenes::SmallScene scene = scenes::smallScenes().at(which);
        SCOPED_TRACE(scene.name);
        Cached cached(device(), scene);
        cached.fill(of(scene, Indirect::cached), 12, 4);
        for (const Indirect indirect : {Indirect::cached, Indirect::corrected}) {
            const Content content = *cached.cache().read();
            const std::vector<glm::vec4> sums = cached.sums(of(scene, indirect, 7), 4);
            const Medium medium =
                makeMedium(*scene.volume, makeBrickGrid(*scene.volume), scene.function, scene.clip);
            ReferenceTracer reference(*scene.volume, medium, scene.environment());
            const auto traced = reference.trace(cached.params(), Filter::trilinear, Precision::twofold, 0, 4);
            reference.useIndirect(content.tags, content.cells);
            const auto truth = reference.trace(cached.params(), Filter::trilinear, Precision::twofold, 0, 4);
            std::size_t different = 0;
            std::size_t used = 0;
            for (std::size_t i = 0; i < truth.size(); ++i) {
                const glm::dvec4 difference = glm::dvec4(sums[i]) - truth[i];
                if (glm::length(difference) > 1e-3 * (1.0 + glm::length(truth[i]))) ++different;
                if (glm::length(traced[i] - truth[i]) > 1e-3) ++used;
            }
            EXPECT_LE(different, truth.size() / 50);
            EXPECT_GT(used, truth.size() / 8) << "the cache must have had a part in it";
        }
    }
}

// As a control variate it may be as wrong as it likes.
TEST_F(IndirectCacheTest, AsAControlVariateItHasNoBias) {
    constexpr int kBatches = 24;
    constexpr std::uint32_t kSamples = 256;
    for (const std::size_t which : {0, 3}) {
        const scenes::SmallScene scene = scenes::smallScenes().at(which);
        SCOPED_TRACE(scene.name);
        Cached cached(device(), scene);
        cached.fill(of(scene, Indirect::cached), 12, 8);
        Content wrong = *cached.cache().read();
        for (glm::uvec4& cell : wrong.cells) cell = {3 * cell.r, cell.g / 2, 2 * cell.b, 64 * cell.w};
        for (glm::uvec4& cell : wrong.cells) cell *= glm::uvec4(64, 64, 64, 1);
        const auto mean = [&](Indirect indirect, bool isWrong) {
            glm::dvec3 sum(0.0);
            glm::dvec3 squares(0.0);
            for (int batch = 0; batch < kBatches; ++batch) {
                if (isWrong) {
                    EXPECT_TRUE(cached.cache().write(wrong).ok());
                }
                const glm::dvec3 light =
                    lightOf(cached.sums(of(scene, indirect, std::uint32_t(batch)), kSamples)) /
                    (double(kSamples) * 256.0);
                sum += light / double(kBatches);
                squares += light * light / double(kBatches);
            }
            const glm::dvec3 error =
                glm::sqrt(glm::max(squares - sum * sum, glm::dvec3(0.0)) / double(kBatches - 1));
            return std::pair(sum, error);
        };
        const auto [traced, chance] = mean(Indirect::traced, false);
        const auto [corrected, itsChance] = mean(Indirect::corrected, true);
        const auto [cachedLight, littleChance] = mean(Indirect::cached, true);
        for (int c = 0; c < 3; ++c) {
            const double error = std::hypot(chance[c], itsChance[c]);
            EXPECT_NEAR(corrected[c], traced[c], 4.5 * error) << c;
            EXPECT_LT(4.5 * error, 0.05 * traced[c]) << "the test must be able to see a bias";
            EXPECT_GT(std::abs(cachedLight[c] - traced[c]), 9.0 * error) << "what is wrong must show";
        }
    }
}

// A calcification in soft tissue: three pixels wide, and smaller than a cell. What scatters within it is most
// of its light, and must not be what cells know of the dark matter around it.
TEST_F(IndirectCacheTest, ASmallBrightThingKeepsItsLight) {
    constexpr glm::ivec3 kMiddle{9, 1, 9};
    const auto values = [&](int i, int j, int k) {
        const glm::ivec3 from = glm::abs(glm::ivec3(i, j, k) - kMiddle);
        return std::uint16_t(std::max({from.x, from.y, from.z}) <= 1 ? 900 : 300);
    };
    const glm::ivec3 size{18, 18, 18};
    const auto volume = scenes::volumeOf(size, scenes::grid(glm::dvec3(1.0), size), values);
    for (const auto& [opacity, albedo] : {std::pair(0.6, 0.1), std::pair(0.05, 1.0)}) {
        SCOPED_TRACE(albedo);
        scenes::SmallScene scene{
            .name = "a bright thing",
            .volume = volume,
            .function = scenes::ramp(80, 900, 0.5, 1.0),
            .view = scenes::lookAt(*volume, 20.0, scenes::kSmallPixels),
            .sky = {.width = 4, .height = 2, .radiance = std::vector<glm::vec3>(8, glm::vec3(1.0f))},
            .bounces = 64};
        scene.function.opacity = {{290, opacity}, {310, opacity}, {890, 0.95}, {900, 0.95}};
        scene.function.colour = {{300, glm::dvec3(albedo)}, {890, glm::dvec3(1.0)}};
        scene.function.albedo = 1.0;
        Cached cached(device(), scene);
        constexpr std::uint32_t kSamples = 256;
        const std::vector<glm::vec4> traced = cached.sums(of(scene, Indirect::traced), kSamples);
        cached.fill(of(scene, Indirect::cached), 100, 4);
        const std::vector<glm::vec4> sums = cached.sums(of(scene, Indirect::cached), kSamples);
        float brightest = 0.0f;
        for (const glm::vec4& pixel : traced) brightest = std::max(brightest, pixel.r);
        double expected = 0.0;
        double found = 0.0;
        for (std::size_t i = 0; i < traced.size(); ++i) {
            if (traced[i].r < 0.75f * brightest) continue;
            expected += double(traced[i].r);
            found += double(sums[i].r);
        }
        EXPECT_NEAR(found / expected, 1.0, 0.1);
    }
}

// Other light, and other matter, are not what it knows.
TEST_F(IndirectCacheTest, ForgetsWhenTheLightChanges) {
    const scenes::SmallScene scene = scenes::smallScenes().front();
    Settings settings = of(scene, Indirect::cached);
    PathTracer t = tracer(scene.volume, scene.function, scene.environment(), scene.view, settings);
    const auto picture = [&](const Settings& of) {
        EXPECT_TRUE(t.setSettings(of).ok());
        EXPECT_TRUE(*t.trace(4));
        return t.readback()->radiance;
    };
    const std::vector<glm::vec4> fresh = picture(settings);
    EXPECT_NE(picture(settings), fresh) << "the second picture uses what the first one found";
    ASSERT_TRUE(t.scene().setTransferFunction(scene.function).ok());
    EXPECT_EQ(picture(settings), fresh);
    (void)picture(settings);
    Settings brighter = settings;
    brighter.lightStrength = 2.0;
    std::vector<glm::vec4> twice = picture(brighter);
    for (glm::vec4& pixel : twice) pixel *= glm::vec4(0.5f, 0.5f, 0.5f, 1.0f);
    EXPECT_EQ(twice, fresh);
    EXPECT_EQ(picture(settings), fresh);
    // What is only seen otherwise is the same light.
    Settings seen = settings;
    seen.exposure = 3.0;
    EXPECT_NE(picture(seen), fresh);
}

// Where there is nothing to keep, or it would be wrong, pictures are those that are traced.
TEST_F(IndirectCacheTest, IsLeftAloneWhereItIsOfNoUse) {
    const std::vector<scenes::SmallScene> scenes = scenes::smallScenes();
    scenes::SmallScene onCamera = scenes.front();
    onCamera.sky.frame = LightFrame::camera;
    scenes::SmallScene once = scenes.front();
    once.bounces = 1;
    const scenes::SmallScene& forward = scenes.at(2);
    ASSERT_NE(forward.function.anisotropy, 0.0);
    const scenes::SmallScene& wet = scenes.at(8);
    ASSERT_NE(wet.function.surface.weight, 0.0);
    for (const scenes::SmallScene& scene : {onCamera, once, forward, wet}) {
        PathTracer t = tracer(scene.volume, scene.function, scene.environment(), scene.view,
                              of(scene, Indirect::cached));
        for (int i = 0; i < 2; ++i) {
            ASSERT_TRUE(t.setSettings(of(scene, Indirect::cached)).ok());
            ASSERT_TRUE(*t.trace(4));
        }
        const std::vector<glm::vec4> cached = t.readback()->radiance;
        ASSERT_TRUE(t.setSettings(of(scene, Indirect::traced)).ok());
        ASSERT_TRUE(*t.trace(4));
        EXPECT_EQ(t.readback()->radiance, cached) << scene.name;
    }
}

// Light is counted in units of what the sky gives: a millionth of it is kept as well as a million times.
TEST_F(IndirectCacheTest, KeepsLightOfAnyStrength) {
    scenes::SmallScene scene = scenes::smallScenes().front();
    const auto share = [&](double strength) {
        Cached cached(device(), scene);
        Settings settings = of(scene, Indirect::cached);
        settings.lightStrength = strength;
        cached.fill(settings, 2, 16);
        const All all = allOf(*cached.cache().read(), double(cached.params().indirectUnit));
        EXPECT_GT(all.samples, 100.0);
        for (const glm::vec4& sum : cached.sums(settings, 4))
            EXPECT_TRUE(std::isfinite(sum.r + sum.g + sum.b));
        return all.light.r / all.samples;
    };
    const double usual = share(1.0);
    EXPECT_GT(usual, 0.0);
    EXPECT_NEAR(share(1e6) * 1e-6, usual, 1e-5 * usual);
    EXPECT_NEAR(share(1e-6) * 1e6, usual, 1e-5 * usual);
    EXPECT_EQ(share(0.0), 0.0);
    scene.sky.radiance.assign(8, glm::vec3(0.0f));
    EXPECT_EQ(share(1.0), 0.0);
}

// The eye is inside of the matter, and 10 m away: cells are as small as they get, and large.
TEST_F(IndirectCacheTest, WorksFromAnyDistance) {
    scenes::SmallScene scene = whiteFurnace();
    scene.bounces = 8;
    for (const double distance : {0.2, 1e4}) {
        scene.view.camera.positionMm = {0.0, -distance, 0.0};
        scene.view.camera.targetMm = {0.0, 1.0, 0.0};
        scene.view.camera.verticalFovDeg = distance > 1e3 ? 0.1 : 60.0;
        Cached cached(device(), scene);
        cached.fill(of(scene, Indirect::cached), 2, 8);
        const All all = allOf(*cached.cache().read(), double(cached.params().indirectUnit));
        EXPECT_GT(all.samples, 50.0) << distance;
        for (const glm::vec4& sum : cached.sums(of(scene, Indirect::cached), 4))
            EXPECT_TRUE(std::isfinite(sum.r + sum.g + sum.b) && sum.r <= 4.2f * 4.0f);
    }
}

// Large pictures tell as much as small ones, and no more than there is room for.
TEST_F(IndirectCacheTest, SomePixelsOfALargePictureTell) {
    EXPECT_EQ(indirectStride(256, 256), 1);
    EXPECT_EQ(indirectStride(257, 256), 2);
    EXPECT_EQ(indirectStride(1, 65537), 2);
    for (const int size : {512, 4096, kMaxPictureSide}) {
        const int stride = indirectStride(size, size);
        const int columns = (size + stride - 1) / stride;
        EXPECT_LE(columns * columns, int(shared::kIndirectMostRecords)) << size;
        EXPECT_GT(2 * columns * columns, int(shared::kIndirectMostRecords) / 2) << size;
    }
}

}  // namespace
}  // namespace macula::trace
