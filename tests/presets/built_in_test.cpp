// The presets and rigs that are carried in the program.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/paths.h"
#include "pipeline/trace/light_rig_json.h"
#include "pipeline/volume/transfer_function_json.h"
#include "presets/catalogue.h"
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
    EXPECT_EQ(presets::transferFiles().size(), test::filesIn("presets/transfer", ".json"));
    EXPECT_GE(presets::transferFiles().size(), 31u) << "all of 3D Slicer's";
    std::set<int> numbers{0};
    std::set<std::string> ids;
    for (const auto& file : presets::transferFiles()) {
        const auto preset = transferFunctionFromJson(file.text, std::string(file.name));
        ASSERT_TRUE(preset.ok()) << file.name << ": " << preset.error().message << " " << preset.error().hint;
        EXPECT_EQ(preset->name, file.name);
        EXPECT_FALSE(preset->title.empty());
        EXPECT_FALSE(preset->modalities.empty());
        EXPECT_FALSE(preset->source.empty());
        EXPECT_TRUE(numbers.insert(preset->number.value_or(0)).second)
            << file.name << ": the number is taken";
        const std::size_t id = file.text.find("\"id\": ");
        ASSERT_NE(id, std::string_view::npos) << file.name;
        EXPECT_TRUE(ids.emplace(file.text.substr(id, 44)).second) << file.name << ": the id is taken";
    }
    EXPECT_EQ(presets::lightFiles().size(), test::filesIn("presets/lights", ".json"));
    for (const auto& file : presets::lightFiles()) {
        const auto rig = trace::lightRigFromJson(file.text, std::string(file.name));
        ASSERT_TRUE(rig.ok()) << file.name << ": " << rig.error().message << " " << rig.error().hint;
        EXPECT_EQ(rig->name, file.name);
    }
}

// What each preset is for, in values a radiologist knows.
TEST(PresetFiles, ShowWhatTheyAreFor) {
    const TransferFunction bone = builtIn("cinematic-bone");
    EXPECT_EQ(opacityAt(bone, 60.0), 0.0) << "muscle hides bone";
    EXPECT_GT(opacityAt(bone, 700.0), 0.8);

    const TransferFunction vessels = builtIn("cinematic-vessels");
    EXPECT_EQ(opacityAt(vessels, 60.0), 0.0);
    EXPECT_GT(opacityAt(vessels, 300.0), 0.5);
    const glm::dvec3 blood = colourAt(vessels, 250.0);
    EXPECT_GT(blood.r, 1.5 * blood.b) << "contrast is red";
    const glm::dvec3 cortex = colourAt(withCurvesSwapped(vessels), 700.0);
    EXPECT_LT(cortex.r, 1.2 * cortex.b) << "bone is ivory";

    const TransferFunction skin = builtIn("cinematic-soft-tissue");
    EXPECT_GT(opacityAt(skin, 40.0), 0.2);
    EXPECT_EQ(opacityAt(skin, -900.0), 0.0);

    const TransferFunction lung = builtIn("cinematic-lung");
    EXPECT_EQ(opacityAt(lung, -1000.0), 0.0) << "air around the patient is fog";
    EXPECT_GT(opacityAt(lung, -800.0), 0.0);
    EXPECT_EQ(opacityAt(lung, 40.0), 0.0) << "soft tissue hides the lung";
}

TEST(PresetFiles, ShowTheBodyPartsTheyAreFor) {
    const TransferFunction head = builtIn("cinematic-head");
    EXPECT_EQ(opacityAt(head, 80.0), 0.0) << "fresh blood hides nothing";
    EXPECT_GT(opacityAt(withCurvesSwapped(head), 200.0), opacityAt(head, 200.0)) << "thin bones end steeply";

    const TransferFunction coronary = builtIn("cinematic-coronary");
    EXPECT_LT(opacityAt(coronary, 120.0), 0.05) << "the wall hides its arteries";
    EXPECT_GT(opacityAt(coronary, 380.0), 0.4);
    const glm::dvec3 calcium = colourAt(coronary, 900.0);
    EXPECT_LT(calcium.r, 1.2 * calcium.b) << "plaque is as blood";

    const TransferFunction abdomen = builtIn("cinematic-abdomen");
    EXPECT_LT(opacityAt(abdomen, 60.0), 0.01) << "muscle hides the organs";
    EXPECT_GT(opacityAt(abdomen, 115.0), 0.2);

    const TransferFunction liver = builtIn("cinematic-liver");
    EXPECT_LT(opacityAt(liver, 110.0), 0.01);
    EXPECT_GT(opacityAt(liver, 170.0), 0.4);

    const TransferFunction kidney = builtIn("cinematic-kidney");
    const glm::dvec3 urine = colourAt(kidney, 900.0);
    EXPECT_GT(urine.g, 1.5 * urine.b) << "urine with contrast agent is golden";

    const TransferFunction tendons = builtIn("cinematic-tendons");
    EXPECT_GT(opacityAt(tendons, 100.0), 20.0 * opacityAt(tendons, 55.0)) << "muscle hides tendons";

    const TransferFunction teeth = builtIn("cinematic-dental");
    EXPECT_GT(opacityAt(teeth, 1700.0), 10.0 * opacityAt(teeth, 900.0)) << "the jaw hides roots";

    const TransferFunction colon = builtIn("cinematic-colon");
    EXPECT_EQ(opacityAt(colon, -1000.0), 0.0);
    EXPECT_GT(opacityAt(colon, -500.0), 0.5);
    EXPECT_EQ(opacityAt(colon, -100.0), 0.0) << "no light comes in";
    const glm::dvec3 tagged = colourAt(colon, 400.0);
    EXPECT_GT(tagged.g, 2.0 * tagged.b) << "tagged residue is as the wall";

    EXPECT_EQ(opacityAt(builtIn("cinematic-mr-vessels"), 300.0), 0.0) << "brain hides vessels";
    EXPECT_LT(opacityAt(builtIn("cinematic-mr-knee"), 250.0), 0.03) << "muscle hides cartilage";
}

// Blood with contrast agent and bone have the same values: where these change little it is blood, where they
// change steeply it is bone. Both are as opaque, so that flights need no gradient.
TEST(PresetFiles, TellBloodFromBoneByTheGradient) {
    const auto redness = [](const TransferFunction& function, double value) {
        const glm::dvec3 colour = colourAt(function, value);
        return colour.r / colour.b;
    };
    for (const char* name : {"cinematic-chest", "cinematic-heart", "cinematic-vessels"}) {
        const TransferFunction preset = builtIn(name);
        ASSERT_TRUE(usesSteepCurves(preset)) << name;
        EXPECT_EQ(preset.steep.opacity, preset.opacity) << name;
        const TransferFunction steep = withCurvesSwapped(preset);
        for (const double value : {250.0, 320.0}) {
            EXPECT_GT(redness(preset, value), 2.0) << name << " " << value;
            EXPECT_LT(redness(steep, value), 1.5) << name << " " << value;
        }
    }
}

// Only one of 3D Slicer's presets needs the gradient, and one of our own.
TEST(PresetFiles, AllCanBeDrawnAsTheyAre) {
    std::vector<std::string> ofGradients;
    for (const auto& file : presets::transferFiles()) {
        const TransferFunction preset = builtIn(file.name);
        EXPECT_TRUE(validate(preset).ok()) << file.name;
        if (usesGradientOpacity(preset)) ofGradients.emplace_back(file.name);
    }
    EXPECT_EQ(ofGradients, (std::vector<std::string>{"cinematic-airways", "uct-skull"}));
}

TEST(PresetFiles, AreFoundByNameInAnyCaseAndByNumber) {
    const auto all = presets::builtInPresets();
    ASSERT_TRUE(all.ok());
    EXPECT_EQ(all->front().source, "Macula");
    const auto found = [&](std::string_view typed) {
        std::string names;
        for (const TransferFunction& preset : *all) {
            if (presets::isMeant(preset, typed)) names += preset.name;
        }
        return names;
    };
    EXPECT_EQ(found("CT-Bone"), "ct-bone");
    EXPECT_EQ(found("ct-bone"), "ct-bone");
    EXPECT_EQ(found("3"), "ct-bone");
    EXPECT_EQ(found("uCT-Skull"), "uct-skull");
    EXPECT_EQ(found("101"), "cinematic-bone");
    EXPECT_EQ(found("CT-Bon"), "");
    EXPECT_EQ(found("03"), "");
    EXPECT_EQ(found(""), "");
}

}  // namespace
}  // namespace macula
