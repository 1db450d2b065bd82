// Under what models are stored: another patient, preset, clip or light must never get the same key.
#include "live/store/model_key_of_drawing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/fingerprint.h"
#include "base/phantom.h"
#include "base/sha256.h"
#include "scene/choice/clip_choice.h"
#include "scene/choice/lights_choice.h"
#include "scene/choice/preset_choice.h"

namespace macula::live {
namespace {

constexpr glm::ivec3 kSize{12, 10, 8};

VolumeOptions options() {
    return {.size = kSize,
            .unit = Unit::hounsfield,
            .provenance = {.studyInstanceUid = "1.2", .seriesInstanceUid = "1.3"}};
}

std::vector<std::uint16_t> voxels() {
    std::vector<std::uint16_t> all(std::size_t(kSize.x * kSize.y * kSize.z));
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = std::uint16_t(i * 7);
    return all;
}

std::shared_ptr<const Volume> volumeOf(const VolumeOptions& o, std::vector<std::uint16_t> all) {
    return std::make_shared<const Volume>(std::move(Volume::create(o, std::move(all))).value());
}

scene::Drawing drawing() {
    return {.transferFunction =
                std::make_shared<const TransferFunction>(scene::choosePreset("cinematic-bone")->function),
            .lights = std::make_shared<const trace::LightRig>()};
}

session::ModelKey keyOf(const Volume& volume, const scene::Drawing& of) {
    PartDigests parts;
    return modelKeyOf(fingerprint(volume), volume, of, parts);
}

TEST(ModelKeyOfDrawing, IsOfWhatThingsAreAndNotOfTheirNames) {
    const auto volume = volumeOf(options(), voxels());
    const session::ModelKey key = keyOf(*volume, drawing());
    EXPECT_TRUE(key.isValid());
    VolumeOptions renamed = options();
    renamed.provenance = {.studyInstanceUid = "9.9", .seriesInstanceUid = "9.8", .description = "DOE"};
    scene::Drawing same = drawing();
    auto function = *same.transferFunction;
    function.title = "Another title";
    same.transferFunction = std::make_shared<const TransferFunction>(function);
    same.settings.seed = 7;
    same.settings.denoising = trace::Denoising::on;
    same.settings.exposure = 2.0;
    same.settings.toneMap = trace::ToneMap::hue;
    EXPECT_EQ(keyOf(*volumeOf(renamed, voxels()), same).digest(), key.digest());
}

TEST(ModelKeyOfDrawing, OtherVoxelsOrGeometryUnderTheSameUidsAreAnotherVolume) {
    const auto volume = volumeOf(options(), voxels());
    const session::ModelKey key = keyOf(*volume, drawing());
    const auto expectOther = [&](const VolumeOptions& o, std::vector<std::uint16_t> all, const char* what) {
        const auto other = volumeOf(o, std::move(all));
        const session::ModelKey otherKey = keyOf(*other, drawing());
        EXPECT_NE(otherKey.digest(), key.digest()) << what;
        EXPECT_EQ(kinshipOf(key, otherKey), Kinship::none) << what;
    };
    for (const std::size_t i : {std::size_t(0), std::size_t(501), voxels().size() - 1}) {
        auto all = voxels();
        ++all[i];
        expectOther(options(), std::move(all), "one voxel");
    }
    auto swapped = voxels();
    const std::ptrdiff_t slice = kSize.x * kSize.y;
    std::swap_ranges(swapped.begin() + 2 * slice, swapped.begin() + 3 * slice, swapped.begin() + 5 * slice);
    expectOther(options(), std::move(swapped), "slices exchanged");
    VolumeOptions spaced = options();
    spaced.worldFromVoxel[2][2] = 1.0 + 1e-12;
    expectOther(spaced, voxels(), "another spacing");
    VolumeOptions mirrored = options();
    mirrored.worldFromVoxel[0][0] = -1.0;
    expectOther(mirrored, voxels(), "mirrored");
}

TEST(ModelKeyOfDrawing, AnotherLookIsAnotherModelAndOnlyLightsAreKin) {
    const auto volume = volumeOf(options(), voxels());
    const session::ModelKey key = keyOf(*volume, drawing());
    EXPECT_EQ(kinshipOf(key, key), Kinship::none) << "it is itself";
    const auto kinshipWith = [&](const scene::Drawing& of) {
        const session::ModelKey other = keyOf(*volume, of);
        EXPECT_NE(other.digest(), key.digest());
        return kinshipOf(key, other);
    };
    scene::Drawing other = drawing();
    auto function = *other.transferFunction;
    function.opacity.front().value -= 1.0;
    other.transferFunction = std::make_shared<const TransferFunction>(function);
    EXPECT_EQ(kinshipWith(other), Kinship::none);
    other = drawing();
    other.clip = std::make_shared<const Clip>(clipFor(*scene::chooseClip("left-half"), *volume));
    EXPECT_EQ(kinshipWith(other), Kinship::none);
    // A second volume, where it lies, and its curve.
    Additions added;
    added.second.emplace();
    added.second->volume = volume;
    added.second->function = drawing().transferFunction;
    other = drawing();
    other.additions = std::make_shared<const Additions>(added);
    EXPECT_EQ(kinshipWith(other), Kinship::none);
    const session::ModelKey withSecond = keyOf(*volume, other);
    added.second->secondFromVolumeMm[3].x = 1.0;
    other.additions = std::make_shared<const Additions>(added);
    EXPECT_NE(keyOf(*volume, other).digest(), withSecond.digest());
    added.second->secondFromVolumeMm[3].x = 0.0;
    added.second->function = std::make_shared<const TransferFunction>(function);
    other.additions = std::make_shared<const Additions>(added);
    EXPECT_NE(keyOf(*volume, other).digest(), withSecond.digest());
    // And colours of segments.
    auto box = std::make_shared<TintBox>();
    box->volumeSize = volume->size();
    box->size = glm::ivec3(1);
    box->voxels = {1};
    Additions coloured;
    coloured.tints = SegmentTints{box, {{.rgb = {1.0f, 0.0f, 0.0f}, .opacity = 1.0f}}};
    other.additions = std::make_shared<const Additions>(coloured);
    EXPECT_EQ(kinshipWith(other), Kinship::none);
    const session::ModelKey red = keyOf(*volume, other);
    coloured.tints->colours.front().opacity = 0.5f;
    other.additions = std::make_shared<const Additions>(coloured);
    EXPECT_NE(keyOf(*volume, other).digest(), red.digest());
    other.additions = std::make_shared<const Additions>();
    EXPECT_EQ(keyOf(*volume, other).digest(), key.digest()) << "nothing is as before";
    other = drawing();
    other.settings.bounces = 3;
    EXPECT_EQ(kinshipWith(other), Kinship::none);
    other = drawing();
    other.settings.look = trace::Look::clear;
    EXPECT_EQ(kinshipWith(other), Kinship::none);
    other = drawing();
    other.settings.lightRotationDeg = 30.0;
    EXPECT_EQ(kinshipWith(other), Kinship::otherLights);
    trace::LightRig rig = *drawing().lights;
    rig.ambientZenith += glm::dvec3(0.125);
    other = drawing();
    other.lights = std::make_shared<const trace::LightRig>(rig);
    EXPECT_EQ(kinshipWith(other), Kinship::otherLights);

    session::ModelKey older = key;
    --older.trainer;
    EXPECT_EQ(kinshipOf(key, older), Kinship::otherVersion);
    session::ModelKey olderOther = keyOf(*volume, other);
    --olderOther.trainer;
    EXPECT_EQ(kinshipOf(key, olderOther), Kinship::otherVersion);
}

// Pictures of another tracer are other ones: what was learnt from them may be begun with, and no more.
TEST(ModelKeyOfDrawing, AModelOfAnotherTracerIsKinAndNotTheSame) {
    const auto volume = volumeOf(options(), voxels());
    const session::ModelKey key = keyOf(*volume, drawing());
    session::ModelKey older = key;
    const auto tracer = std::ranges::find(older.parts, "tracer", &session::KeyPart::name);
    ASSERT_NE(tracer, older.parts.end());
    tracer->digest = sha256Hex("an older one");
    EXPECT_NE(older.digest(), key.digest());
    EXPECT_EQ(kinshipOf(key, older), Kinship::otherVersion);
    older.parts.erase(tracer);  // of before there was a version
    EXPECT_TRUE(older.isValid());
    EXPECT_NE(older.digest(), key.digest());
    EXPECT_EQ(kinshipOf(key, older), Kinship::otherVersion);
    scene::Drawing other = drawing();
    other.settings.bounces = 3;
    EXPECT_EQ(kinshipOf(keyOf(*volume, other), older), Kinship::none);
}

}  // namespace
}  // namespace macula::live
