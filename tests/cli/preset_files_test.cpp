// The presets and rigs that are carried in the program.
#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/trace/light_rig_json.h"
#include "pipeline/volume/transfer_function_json.h"
#include "presets/embedded_files.h"

namespace macula {
namespace {

TransferFunction builtIn(std::string_view name) {
    for (const auto& file : presets::transferFiles()) {
        if (file.name != name) continue;
        const auto read = transferFunctionFromJson(file.text, std::string(name));
        EXPECT_TRUE(read.ok());
        if (read.ok()) return *read;
    }
    ADD_FAILURE() << "no preset " << name;
    return {};
}

TEST(PresetFiles, AllAreReadAndNamedAsTheirFile) {
    EXPECT_GE(presets::transferFiles().size(), 5u);
    for (const auto& file : presets::transferFiles()) {
        const auto preset = transferFunctionFromJson(file.text, std::string(file.name));
        ASSERT_TRUE(preset.ok()) << file.name << ": " << preset.error().message << " " << preset.error().hint;
        EXPECT_EQ(preset->name, file.name);
        EXPECT_FALSE(preset->title.empty());
        EXPECT_FALSE(preset->modalities.empty());
        EXPECT_EQ(preset->fitToVolume.has_value(), preset->unit == Unit::raw) << file.name;
    }
    EXPECT_GE(presets::lightFiles().size(), 4u);
    for (const auto& file : presets::lightFiles()) {
        const auto rig = trace::lightRigFromJson(file.text, std::string(file.name));
        ASSERT_TRUE(rig.ok()) << file.name << ": " << rig.error().message << " " << rig.error().hint;
        EXPECT_EQ(rig->name, file.name);
    }
}

// What each preset is for, in values a radiologist knows.
TEST(PresetFiles, ShowWhatTheyAreFor) {
    const TransferFunction bone = builtIn("ct-bone");
    EXPECT_EQ(opacityAt(bone, 60.0), 0.0) << "muscle hides bone";
    EXPECT_GT(opacityAt(bone, 700.0), 0.8);

    const TransferFunction vessels = builtIn("ct-contrast-vessels");
    EXPECT_EQ(opacityAt(vessels, 60.0), 0.0);
    EXPECT_GT(opacityAt(vessels, 300.0), 0.5);
    const glm::dvec3 blood = colourAt(vessels, 250.0);
    EXPECT_GT(blood.r, 1.5 * blood.b) << "contrast is red";
    const glm::dvec3 cortex = colourAt(vessels, 700.0);
    EXPECT_LT(cortex.r, 1.2 * cortex.b) << "bone is ivory";

    const TransferFunction skin = builtIn("ct-soft-tissue");
    EXPECT_GT(opacityAt(skin, 40.0), 0.2);
    EXPECT_EQ(opacityAt(skin, -900.0), 0.0);

    const TransferFunction lung = builtIn("ct-lung");
    EXPECT_EQ(opacityAt(lung, -1000.0), 0.0) << "air around the patient is fog";
    EXPECT_GT(opacityAt(lung, -800.0), 0.0);
    EXPECT_EQ(opacityAt(lung, 40.0), 0.0) << "soft tissue hides the lung";
}

TEST(PresetFiles, WritingAndReadingGivesTheSame) {
    for (const auto& file : presets::transferFiles()) {
        const TransferFunction preset = builtIn(file.name);
        const auto again = transferFunctionFromJson(toJson(preset), "again");
        ASSERT_TRUE(again.ok()) << again.error().message;
        EXPECT_EQ(toJson(*again), toJson(preset));
        EXPECT_EQ(again->albedo, preset.albedo);
        EXPECT_EQ(again->anisotropy, preset.anisotropy);
        EXPECT_EQ(again->fitToVolume.has_value(), preset.fitToVolume.has_value());
        ASSERT_EQ(again->opacity.size(), preset.opacity.size());
        for (std::size_t i = 0; i < preset.opacity.size(); ++i) {
            EXPECT_EQ(again->opacity[i].value, preset.opacity[i].value);
            EXPECT_EQ(again->opacity[i].opacity, preset.opacity[i].opacity);
        }
    }
}

}  // namespace
}  // namespace macula
