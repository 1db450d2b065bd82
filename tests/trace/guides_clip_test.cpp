// Guides where a clip cuts through matter, with bare cuts and with faces that show grey: the device and the
// reference against a march in double (what it shares with them: dense_scene.h).
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "pipeline/trace/reference_tracer.h"
#include "trace/dense_scene.h"
#include "trace/gpu_scene.h"
#include "trace/small_scenes.h"

namespace macula::trace {
namespace {

constexpr double kStepVoxels = 0.01;

struct DenseGuide {
    double depthMm = -1.0;
    double coverage = 0.0;
    glm::dvec3 albedo{0.0};
    bool isCut = false;   // the depth is that of a face of the clip: matter before it hides less than 0.45
    bool isBare = false;  // a face with next to no matter before it
};

// The linear light that the tone map and the display's curve turn into `encoded`: in the middle of its range
// it takes 0.04 away. The window below leaves all values of the lump there.
double lightOfGrey(double encoded) {
    return scenes::linearOf(encoded) + 0.04;
}

DenseGuide denseGuide(const scenes::DenseScene& scene, const Clip& clip, const glm::dvec3& eyeMm, double x,
                      double y) {
    DenseGuide guide;
    const glm::dvec3 direction = scene.eyeDirection(x, y);
    const glm::dvec2 span = scene.inside(eyeMm, direction);
    if (span.y <= span.x) return guide;
    const double low = clip.greyFaces ? clip.greyFaces->center - 0.5 * clip.greyFaces->width : 0.0;
    double depth = 0.0;
    double seen = 0.0;
    bool removedBefore = false;
    for (double at = span.x + 0.5 * kStepVoxels; at < span.y; at += kStepVoxels) {
        const glm::dvec3 mm = eyeMm + direction * at;
        const glm::dvec3 voxel = scene.voxelOf(mm);
        const auto around = scene.around(voxel);
        const bool removed = !shows(clip, mm);
        const bool entered = removedBefore && !removed;
        removedBefore = removed;
        if (removed) continue;
        const double before = depth;
        const double grey = (scene.valueOf(around) - low) / (clip.greyFaces ? clip.greyFaces->width : 1.0);
        const bool isFace = entered && clip.greyFaces && grey > 0.0 && !scene.isMasked(around);
        if (!isFace && scene.isMasked(around)) continue;
        depth = isFace ? 1e9 : depth + scene.extinctionAt(voxel, around) * kStepVoxels;
        const double share = std::max(std::exp(-before) - std::exp(-std::min(depth, std::log(2.0))), 0.0);
        if (share > 0.0) {
            seen += share;
            guide.albedo += share * (isFace ? glm::dvec3(lightOfGrey(grey)) : scene.albedoAt(voxel));
        }
        if (before < std::log(2.0) && depth >= std::log(2.0)) {
            guide.depthMm = isFace ? at - 0.5 * kStepVoxels : at;
            guide.isCut = isFace && std::exp(-before) > 0.55;
            guide.isBare = isFace && before < 1e-3;
        }
        if (isFace) break;
    }
    guide.coverage = -std::expm1(-depth);
    if (seen > 0.0) guide.albedo /= seen;
    return guide;
}

// How far a normal at this depth of a ray is from the gradient there; which way along it does not count where
// the surface is seen on edge.
double degreesOff(const scenes::DenseScene& scene, const glm::dvec3& eyeMm, const glm::dvec3& direction,
                  double depthMm, const glm::dvec3& normal) {
    glm::dvec3 gradient = scene.gradientPerMm(scene.voxelOf(eyeMm + direction * depthMm));
    if (glm::length(gradient) < 1e-9) return glm::length(normal) == 0.0 ? 0.0 : 180.0;
    gradient = glm::normalize(gradient);
    const double towards = glm::dot(gradient, direction);
    double cosine = -std::copysign(1.0, towards) * glm::dot(gradient, normal);
    if (std::abs(towards) < 0.01) cosine = std::abs(cosine);
    return glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
}

class Errors {
  public:
    void add(const DenseGuide& truth, const GuideOf<double>& guide, double degreesOff) {
        coverage_.push_back(std::abs(guide.coverage - truth.coverage));
        // Below one half there is no depth: what is that near to it may have one or not.
        if ((truth.depthMm > 0.0) != (guide.depthMm > 0.0)) {
            EXPECT_NEAR(truth.coverage, 0.5, 0.06);
        }
        if (truth.coverage > 0.02) albedo_.push_back(glm::distance(guide.albedo, truth.albedo));
        if (truth.depthMm < 0.0 || guide.depthMm < 0.0) return;
        depth_.push_back(std::abs(guide.depthMm - truth.depthMm));
        EXPECT_LT(degreesOff, 0.1);  // float tells 0.03 degrees
        if (!truth.isCut) return;
        ++cuts_;
        EXPECT_LT(depth_.back(), 0.6 * kStepVoxels + 1e-3);
        EXPECT_GT(guide.coverage, 0.9999);
        if (truth.isBare) {
            EXPECT_LT(albedo_.back(), 0.01);
        }
    }
    // In soft matter the guides look once in a voxel or four times: a depth is right to a part of one. Faces
    // are where they are. A normal is that of the depth that was found.
    void judge(bool grey) {
        EXPECT_GT(depth_.size(), 600u);
        EXPECT_LT(quantile(depth_, 0.5), 0.1);
        EXPECT_LT(quantile(depth_, 0.95), 0.7);
        EXPECT_LT(quantile(coverage_, 0.95), 0.02);
        EXPECT_LT(quantile(albedo_, 0.5), 0.004);
        EXPECT_LT(quantile(albedo_, 0.95), 0.04);
        if (grey) {
            EXPECT_GT(cuts_, 200);
        }
    }

  private:
    static double quantile(std::vector<double>& values, double q) {
        std::sort(values.begin(), values.end());
        return values[std::size_t(q * double(values.size() - 1))];
    }
    std::vector<double> depth_, coverage_, albedo_;
    int cuts_ = 0;
};

struct ClippedScene {
    std::string name;
    Clip clip;
};

std::vector<ClippedScene> clippedScenes(const Volume& volume) {
    std::vector<ClippedScene> scenes;
    const DisplayWindow grey{.center = 400, .width = 1600, .explanation = {}, .function = "LINEAR_EXACT"};
    Clip plane{.planes = {{glm::normalize(glm::dvec3(0.3, 1, -0.2)), -1.5}}};
    scenes.push_back({"plane", plane});
    plane.greyFaces = grey;
    scenes.push_back({"grey plane", plane});
    Clip cuts;
    cuts.box = OrientedBox{.centreMm = {3, -4, 2},
                           .axes = glm::dmat3(glm::rotate(glm::dmat4(1.0), 0.5, glm::dvec3(0, 0, 1))),
                           .halfSizeMm = {3.1, 4.2, 2.7}};
    cuts.ofBox = Keep::outside;
    cuts.cut = Octant{.pointMm = {-1.2, 0.4, -0.6}, .towards = {-1, -1, -1}};
    scenes.push_back({"box and corner", cuts});
    cuts.greyFaces = grey;
    scenes.push_back({"grey box and corner", cuts});
    std::vector<std::uint16_t> labels;
    for (int k = 0; k < scenes::kSmallSize.z; ++k) {
        for (int j = 0; j < scenes::kSmallSize.y; ++j) {
            for (int i = 0; i < scenes::kSmallSize.x; ++i) labels.push_back(i + k > 14 ? 2 : 1);
        }
    }
    cuts.mask = Mask{
        std::make_shared<const LabelMap>(
            std::move(LabelMap::create(scenes::kSmallSize, volume.worldFromVoxel(),
                                       {{.number = 1, .label = "a"}, {.number = 2, .label = "b"}}, labels))
                .value()),
        {1},
        Keep::inside};
    scenes.push_back({"grey box and corner, half masked", cuts});
    Clip ball{.ball = Ball{.centreMm = {0, -4, 1}, .radiusMm = 6.0}, .ofBall = Keep::outside};
    scenes.push_back({"ball", ball});
    ball.greyFaces = grey;
    scenes.push_back({"grey ball", ball});
    return scenes;
}

using GuidesAtCuts = DeviceTest;

TEST_F(GuidesAtCuts, AreThoseOfADenseMarch) {
    const auto volume =
        scenes::volumeOf(scenes::kSmallSize, scenes::grid(glm::dvec3(1.0), scenes::kSmallSize), scenes::lump);
    TransferFunction tissue = scenes::ramp(80, 900, 0.6, 1.0);
    tissue.colour = {{80, {0.9, 0.3, 0.2}}, {900, {0.9, 0.9, 0.8}}};
    View view = scenes::lookAt(*volume, 20.0, 40);
    view.camera.positionMm += glm::dvec3(9, 0, 14);
    const Environment sky = Environment::constant(glm::vec3(1.0f));
    PathTracer t = tracer(volume, tissue, sky, view, {});
    for (const ClippedScene& scene : clippedScenes(*volume)) {
        SCOPED_TRACE(scene.name);
        ASSERT_TRUE(t.scene().setClip(scene.clip).ok());
        const auto onDevice = t.readGuides();
        ASSERT_TRUE(onDevice.ok());
        std::optional<MaskBits> bits;
        if (scene.clip.mask) bits = maskBits(*scene.clip.mask, *volume);
        const Medium medium =
            makeMedium(*volume, makeBrickGrid(*volume), tissue, scene.clip, bits ? &*bits : nullptr);
        const auto ofReference = ReferenceTracer(*volume, medium, sky, bits ? &*bits : nullptr)
                                     .guides(*makeTraceParams(*volume, medium, sky, view, {}, scene.clip),
                                             *guidePush(view, view), Precision::twofold);
        const scenes::DenseScene dense(*volume, tissue, scene.clip, view, Filter::trilinear);
        Errors errors;
        for (int y = 0; y < view.height; ++y) {
            for (int x = 0; x < view.width; ++x) {
                const auto i = std::size_t(y * view.width + x);
                const glm::dvec3 eye = view.camera.positionMm;
                const DenseGuide truth =
                    denseGuide(dense, scene.clip, eye, (x + 0.5) / view.width, (y + 0.5) / view.height);
                const GuidePixel& d = (*onDevice)[i];
                const glm::dvec3 direction =
                    dense.eyeDirection((x + 0.5) / view.width, (y + 0.5) / view.height);
                errors.add(truth,
                           {.depthMm = d.depthMm,
                            .confidence = d.confidence,
                            .coverage = d.coverage,
                            .beforeMm = d.beforeMm,
                            .albedo = d.albedo,
                            .normal = d.normal,
                            .motion = d.motion},
                           degreesOff(dense, eye, direction, d.depthMm, d.normal));
                errors.add(truth, ofReference[i],
                           degreesOff(dense, eye, direction, ofReference[i].depthMm, ofReference[i].normal));
            }
        }
        errors.judge(scene.clip.greyFaces.has_value());
    }
}

}  // namespace
}  // namespace macula::trace
