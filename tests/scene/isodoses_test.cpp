// Isodoses of a dose over a study: their values, their JSON, and how a dose is laid over.
#include "scene/second/isodoses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "pipeline/volume/json_reader.h"
#include "scene/second/dose_lines.h"
#include "scene/second/second_curve.h"
#include "scene/second/second_study.h"
#include "scene/state/second_volume_json.h"

namespace macula::scene {
namespace {

Result<SecondVolumeState> read(const nlohmann::ordered_json& json) {
    const JsonDocument document = JsonDocument::of(nlohmann::json(json), {});
    SecondVolumeState state = secondVolumeStateFrom(document.root());
    if (const auto status = document.status(); !status) return status.error();
    return state;
}

study::OpenedStudy doseStudy(const char* frame) {
    study::OpenedStudy study;
    study.volume = std::make_shared<const Volume>(*Volume::create({.size = {3, 3, 3},
                                                                   .unitsFromStored = {.slope = 0.01},
                                                                   .unit = Unit::other,
                                                                   .modality = "RTDOSE",
                                                                   .unitName = "Gy"},
                                                                  std::vector<std::uint16_t>(27, 5000)));
    study.frameOfReferenceUid = frame;
    study.dose = dicom::DoseFacts{.units = "GY", .type = "PHYSICAL", .summation = "PLAN"};
    return study;
}

TEST(Isodoses, LevelsInPercentFollowTheReference) {
    const study::DoseReference reference{.value = 60.0, .of = study::DoseReference::Of::prescription};
    const auto lines = doseLines(usualIsodoses(), reference);
    ASSERT_EQ(lines.size(), 7u);
    EXPECT_NEAR(lines[0].value, 64.2, 1e-9);
    EXPECT_NEAR(lines[6].value, 6.0, 1e-9);
    EXPECT_EQ(lines[2].percent, 95.0);
    EXPECT_TRUE(doseLines(usualIsodoses(), std::nullopt).empty()) << "of nothing there is no percentage";
    const Isodoses inGy{.areInPercent = false, .levels = {{.level = 20.0}, {.level = 45.0}}};
    const auto absolute = doseLines(inGy, reference);
    ASSERT_EQ(absolute.size(), 2u);
    EXPECT_EQ(absolute[0].value, 45.0) << "the highest first";
    EXPECT_EQ(absolute[0].percent, 75.0);
    EXPECT_FALSE(doseLines(inGy, std::nullopt)[0].percent);
}

TEST(Isodoses, HostileOnesHaveNoLines) {
    const study::DoseReference reference{.value = 60.0};
    for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity(), 1e7}) {
        const Isodoses isodoses{.levels = {{.level = 50.0}, {.level = bad}}};
        EXPECT_FALSE(isUsable(isodoses)) << bad;
        EXPECT_TRUE(doseLines(isodoses, reference).empty()) << bad;
    }
    EXPECT_FALSE(isUsable({.levels = std::vector<Isodose>(kMostIsodoses + 1, {.level = 1.0})}));
    EXPECT_FALSE(isUsable({.reference = 0.0}));
}

TEST(Isodoses, AreKeptInTheState) {
    SecondVolumeState state{.seriesDigest = "abc"};
    state.isodoses = usualIsodoses();
    state.isodoses->areInPercent = false;
    state.isodoses->areShown = false;
    state.isodoses->reference = 57.5;
    const auto kept = read(toJson(state));
    ASSERT_TRUE(kept) << kept.error().message;
    EXPECT_EQ(*kept, state);
    state.isodoses->levels[0].level = 1.0;
    EXPECT_NE(*kept, state);
    const auto none = read(toJson(SecondVolumeState{.seriesDigest = "abc"}));
    ASSERT_TRUE(none);
    EXPECT_FALSE(none->isodoses) << "as in views of older versions";
}

TEST(Isodoses, BadOnesAreRefused) {
    const nlohmann::ordered_json good = toJson([] {
        SecondVolumeState state{.seriesDigest = "abc"};
        state.isodoses = usualIsodoses();
        return state;
    }());
    ASSERT_TRUE(read(good));
    const std::vector<std::function<void(nlohmann::ordered_json&)>> edits{
        [](auto& j) { j["levels"][0]["level"] = -3; },
        [](auto& j) { j["levels"][0]["level"] = 0; },
        [](auto& j) { j["levels"][0]["level"] = 1e300; },
        [](auto& j) {
            j["levels"][0]["rgb"] = {1, 2};
        },
        [](auto& j) {
            j["levels"][0]["rgb"] = {1, 2, 300};
        },
        [](auto& j) { j["levels"][0]["more"] = 1; },
        [](auto& j) { j["unit"] = "rad"; },
        [](auto& j) { j["reference"] = 0; },
        [](auto& j) { j["levels"] = "all"; },
        [](auto& j) { j.erase("levels"); },
        [](auto& j) {
            for (int i = 0; i < 20; ++i) j["levels"].push_back(j["levels"][0]);
        }};
    for (std::size_t i = 0; i < edits.size(); ++i) {
        nlohmann::ordered_json bad = good;
        edits[i](bad["isodoses"]);
        EXPECT_FALSE(read(bad)) << i;
    }
}

TEST(Isodoses, ADoseLiesOverTheImagesOfItsFrameOfReference) {
    study::OpenedStudy images = doseStudy("2.25.1");
    images.dose.reset();
    const SecondVolumeState over = firstLink(images, doseStudy("2.25.1"), "pair");
    EXPECT_EQ(over.view, SecondVolumePlace::over);
    EXPECT_EQ(over.link, SecondVolumeLink::sameFrame);
    EXPECT_EQ(over.isodoses, usualIsodoses());
    ASSERT_TRUE(over.window);
    EXPECT_DOUBLE_EQ(over.window->center, 25.0);
    EXPECT_DOUBLE_EQ(over.window->width, 50.0);
    const SecondVolumeState elsewhere = firstLink(images, doseStudy("2.25.2"), "pair");
    EXPECT_EQ(elsewhere.view, SecondVolumePlace::beside);
    EXPECT_FALSE(elsewhere.isodoses);
    const auto reference = doseReference(doseStudy("2.25.1"), over.isodoses);
    ASSERT_TRUE(reference);
    EXPECT_EQ(reference->of, study::DoseReference::Of::maximum) << "no plan, no prescription";
    EXPECT_NEAR(reference->value, 50.0, 1e-9);
    EXPECT_FALSE(doseReference(images, over.isodoses));
}

TEST(Isodoses, DoNotChangeThe3dPicture) {
    SecondVolumeState with{.seriesDigest = "abc", .link = SecondVolumeLink::sameFrame, .in3d = true};
    SecondVolumeState without = with;
    with.isodoses = usualIsodoses();
    EXPECT_EQ(secondPartIn3d(with), secondPartIn3d(without));
    EXPECT_EQ(withLookOf(without, with).isodoses, with.isodoses);
}

}  // namespace
}  // namespace macula::scene
