// What somebody means by a name: built-in, a file, or a word that is nothing, and then what there is.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "pipeline/volume/transfer_function_json.h"
#include "scene/choice/built_in_list.h"
#include "scene/choice/catalogue.h"
#include "scene/choice/clip_choice.h"
#include "scene/choice/lights_choice.h"
#include "scene/choice/nearest_name.h"
#include "scene/choice/preset_choice.h"
#include "scene/choice/quality_choice.h"
#include "scene/choice/typed_values.h"
#include "support.h"

namespace macula::scene {
namespace {

using dicom::test::TemporaryFolder;

template <class T>
void expectNoSuchName(const Result<T>& chosen, const std::string& typed, const std::string& meant) {
    ASSERT_FALSE(chosen) << typed;
    EXPECT_EQ(chosen.error().code, ErrorCode::usage);
    EXPECT_EQ(chosen.error().where, typed);
    EXPECT_TRUE(chosen.error().hint.english().starts_with("Did you mean " + meant + "? There are: "))
        << chosen.error().hint;
}

TEST(NearestName, IsTheOneWithTheFewestChanges) {
    EXPECT_EQ(nearestName("ct-bon", {"ct-aaa", "ct-bone", "ct-bones"}), "ct-bone");
    EXPECT_EQ(nearestName("ct-bone", {"ct-bone"}), "ct-bone");
    EXPECT_EQ(nearestName("lung", {"ct-bone", "mr-angio"}), "");  // more than a third would change
    EXPECT_EQ(choiceAmong("lung", {"ct-bone", "mr-angio"}), "There are: ct-bone, mr-angio.");
}

// The hint is one look-up, for whatever is chosen.
TEST(Choice, OfAWordThatIsNothingTellsWhatThereIs) {
    expectNoSuchName(choosePreset("cinematic-bonne"), "cinematic-bonne", "cinematic-bone");
    expectNoSuchName(chooseLights("studioo"), "studioo", "studio");
    expectNoSuchName(chooseClip("left-hal"), "left-hal", "left-half");
    expectNoSuchName(chooseQuality("draftt"), "draftt", "draft");
    const auto catalogue = builtInCatalogue();
    ASSERT_TRUE(catalogue);
    expectNoSuchName(findPreset(*catalogue, "cinematic-bonne"), "cinematic-bonne", "cinematic-bone");
    expectNoSuchName(findLights(*catalogue, "studioo"), "studioo", "studio");
}

// The window's look-up and the command's find the same.
TEST(Choice, ByNameIsThatOfTheCatalogue) {
    const auto catalogue = builtInCatalogue();
    ASSERT_TRUE(catalogue);
    for (const auto& preset : catalogue->presets) {
        const auto chosen = choosePreset(preset->name);
        ASSERT_TRUE(chosen) << preset->name;
        EXPECT_EQ(toJson(chosen->function), toJson(*preset));
        ASSERT_TRUE(preset->number) << preset->name;
        const auto byNumber = findPreset(*catalogue, std::to_string(*preset->number));
        ASSERT_TRUE(byNumber);
        EXPECT_EQ(*byNumber, preset);
    }
    for (const trace::Look look : {trace::Look::cinematic, trace::Look::clear, trace::Look::mip})
        EXPECT_EQ(defaultLights(*catalogue, look)->name, defaultLightsFor(look));
}

TEST(Choice, OfAFileIsReadAndNotNamed) {
    const TemporaryFolder folder;
    const std::string path = (folder / "doe-john.json").string();
    std::ofstream(path) << R"({"version": 1, "name": "mine", "title": "Mine", "samplesPerPixel": 3,
                              "bounces": 2, "filter": "stochastic", "denoise": false})";
    const auto quality = chooseQuality(path);
    ASSERT_TRUE(quality) << quality.error().message;
    EXPECT_EQ(quality->samplesPerPixel, 3u);
    EXPECT_EQ(quality->bounces, 2);
    EXPECT_EQ(publicClipName(path), "custom");
    EXPECT_EQ(publicLightsName(path), "custom");
    EXPECT_EQ(publicPresetName(path), "custom");
    EXPECT_EQ(publicLightsName("studio"), "studio");

    const auto missing = chooseQuality((folder / "no.json").string());
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, ErrorCode::inputNotUsable);
}

TEST(Choice, OfNumbersTakesAllOfTheWord) {
    const auto window = parseWindow("-60.5, 350.25");
    ASSERT_TRUE(window);
    EXPECT_EQ(window->center, -60.5);
    EXPECT_EQ(window->width, 350.25);
    for (const char* text :
         {"", "1", "1,2,", "1,2,3", "1,2x", "x1,2", "1;2", "1,0", "1,-2", "nan,1", "1,inf"})
        EXPECT_FALSE(parseWindow(text)) << text;
    const auto background = parseBackground("0,0.5,1");
    ASSERT_TRUE(background);
    EXPECT_EQ(*background, glm::vec3(0.0f, 0.5f, 1.0f));
    for (const char* text : {"", "0,1", "0,0.5,1.5", "0,0.5,-1", "0,0,5,1", "0,0.5,nan"})
        EXPECT_FALSE(parseBackground(text)) << text;
}

TEST(Choice, OfNoClipLeavesAll) {
    const auto none = chooseClip("");
    ASSERT_TRUE(none);
    EXPECT_TRUE(none->clip.isNothing());
    EXPECT_EQ(publicClipName(""), "none");
}

// A model stays where it is; so does its light.
TEST(Choice, OfLightsForAModelRefusesThoseOfTheCamera) {
    EXPECT_TRUE(choosePatientLights("studio"));
    ASSERT_TRUE(chooseLights("headlight"));
    const auto lamp = choosePatientLights("headlight");
    ASSERT_FALSE(lamp);
    EXPECT_EQ(lamp.error().code, ErrorCode::usage);
}

TEST(BuiltIns, FromTheFastestQualityOn) {
    const auto all = builtIns();
    ASSERT_TRUE(all);
    EXPECT_FALSE(all->presets.empty());
    EXPECT_TRUE(std::ranges::is_sorted(all->qualities, {}, &trace::Quality::samplesPerPixel));
}

TEST(DifferentNames, AreGivenToPresetsOfTheSameName) {
    const auto named = [](const char* name) {
        presets::ImportedPreset preset;
        preset.function.name = name;
        return preset;
    };
    const presets::ImportedPresets imported{named("a"), named("b"), named("a"), named("a"), named("a-2")};
    std::vector<std::string> names;
    for (const TransferFunction& function : withDifferentNames(imported)) names.push_back(function.name);
    EXPECT_EQ(names, (std::vector<std::string>{"a", "b", "a-2", "a-3", "a-2-2"}));
}

}  // namespace
}  // namespace macula::scene
