// What edits show before they are traced, of the phantom, small.
#include "evaluate/edits.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "evaluate/benchmark_reports.h"
#include "gpu/shared_device.h"
#include "scene/choice/lights_choice.h"

namespace macula::evaluate {
namespace {

namespace fs = std::filesystem;

constexpr int kSidePx = 64;

class EditsOnDevice : public gpu::SharedDeviceTest {};

TEST_F(EditsOnDevice, AnEstimateIsOfWhatTheEditShows) {
    Progress progress;
    BenchStudy study = std::move(openBenchStudy({.preset = "cinematic-bone",
                                                 .thenPreset = "cinematic-soft-tissue",
                                                 .lights = scene::kDefaultLights,
                                                 .size = kSidePx},
                                                progress))
                           .value();
    study.device = device();
    const fs::path folder = fs::path(testing::TempDir()) / "macula-edits";
    fs::remove_all(folder);
    fs::create_directories(folder);
    EditsOptions options{.sizePx = glm::ivec2(kSidePx), .truthSamples = 8, .pictures = folder};
    options.model = {.points = {.count = 1000},
                     .views = 6,
                     .samplesPerPixel = 1,
                     .directions = 8,
                     .sizePx = kSidePx,
                     .iterations = 60,
                     .capacity = 1000};
    const auto measured = measureEdits(study, options, progress);
    ASSERT_TRUE(measured) << measured.error().message;
    const auto report = reportOf(study, options, *measured);
    std::set<std::string> names;
    for (const auto& edit : report["edits"]) {
        const std::string name = edit["edit"];
        names.insert(name);
        EXPECT_GT(edit["estimateMs"].get<double>(), 0.0) << name;
        EXPECT_GT(edit["drawMs"].get<double>(), 0.0) << name;
        EXPECT_GT(edit["splats"].get<int>(), 100) << name;
        // What is opaque is there, and what is hidden is not.
        EXPECT_LT(edit["estimated"]["lacks"].get<double>(), 0.01) << name;
        EXPECT_LT(edit["estimated"]["remains"].get<double>(), 0.03) << name;
        // A model of 60 steps lights soft tissue after bone roughly: FLIP 0.39 under `studio`, which has
        // little sky.
        EXPECT_LT(edit["estimated"]["flip"].get<double>(), 0.45) << name;
        EXPECT_GT(edit["small"]["flip"].get<double>(), 0.0) << name;
    }
    EXPECT_EQ(names.size(), 8u);
    for (const char* name :
         {"opening", "none", "clip 0.25", "clip 0.5", "clip 0.5 grey", "preset cinematic-soft-tissue"})
        EXPECT_TRUE(names.contains(name)) << name;
    for (const char* file :
         {"opening.png", "clip-0.5-grey.png", "clip-0.5-grey-small.png", "none-traced.png"})
        EXPECT_TRUE(fs::exists(folder / file)) << file;
    fs::remove_all(folder);
}

}  // namespace
}  // namespace macula::evaluate
