// Presets that a person owns: their names, the shelf they stand on, and the store that keeps them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>

#include "base/phantom.h"
#include "live/store/preset_shelf.h"
#include "live/store/stored_presets.h"
#include "pipeline/volume/transfer_function_json.h"
#include "scene/choice/catalogue.h"
#include "scene/choice/preset_kinds.h"
#include "scene/transfer/own_copy.h"
#include "session/store.h"

namespace macula::live {
namespace {

namespace fs = std::filesystem;
using session::DocumentKind;

TEST(PresetNames, AreTrimmedAndOnOneLine) {
    EXPECT_EQ(*checkedPresetName("  Bone,\t warm \n"), "Bone, warm");
    EXPECT_EQ(*checkedPresetName("\u00a0Knochen\u3000мягкий "), "Knochen мягкий");
    EXPECT_EQ(*checkedPresetName("骨"), "骨");
    EXPECT_EQ(*checkedPresetName("a/b: \"c\" <d> & e"), "a/b: \"c\" <d> & e");
}

TEST(PresetNames, WhatCannotBeOneIsRefusedInWords) {
    const auto refused = [](std::string_view name) {
        const auto checked = checkedPresetName(name);
        EXPECT_FALSE(checked.ok()) << name;
        return checked ? std::string()
                       : checked.error().message.english() + "|" + checked.error().hint.english();
    };
    EXPECT_EQ(refused(""), "The preset needs a name.|Type one.");
    EXPECT_EQ(refused(" \t\u2003"), refused(""));
    EXPECT_NE(refused(std::string(kMostPresetNameLetters + 1, 'x')).find("too long"), std::string::npos);
    EXPECT_NE(refused(std::string(1'000'000, 'x')).find("too long"), std::string::npos);
    // A name of which the last letter stands behind a blank is not cut in silence.
    EXPECT_NE(refused(std::string(kMostPresetNameLetters, 'x') + " y").find("too long"), std::string::npos);
    for (const char* unreadable : {"\xff", "a\xc3", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xc0\xaf", "\x80"})
        EXPECT_NE(refused(unreadable).find("cannot be read"), std::string::npos);
    for (const char* unseen : {"a\u202e", "a\u200bb", "\ufeffa", "a\x01", "a\u0085"})
        EXPECT_NE(refused(unseen).find("cannot be seen"), std::string::npos);
}

TEST(PresetNames, AsManyLettersAsAreAllowedFitTheStoreInEveryScript) {
    std::string name;
    for (std::size_t i = 0; i < kMostPresetNameLetters; ++i) name += "\U00020000";
    EXPECT_EQ(*checkedPresetName(name), name);
    EXPECT_FALSE(checkedPresetName(name + "x").ok());
}

TEST(PresetNames, TheNearestOfAnyTextIsAName) {
    EXPECT_EQ(nearestPresetName(""), "Preset");
    EXPECT_EQ(nearestPresetName("\xff\u202e"), "Preset");
    EXPECT_EQ(nearestPresetName(" CT\nBone "), "CT Bone");
    const std::string longest = nearestPresetName(std::string(300, 'x'));
    EXPECT_EQ(longest.size(), kMostPresetNameLetters);
    EXPECT_TRUE(checkedPresetName(longest).ok());
}

class OwnPresets : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "macula-presets-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
    }
    void TearDown() override { fs::remove_all(folder_); }

    session::Store open() {
        auto store = session::Store::open({.folder = folder_ / "sessions"});
        EXPECT_TRUE(store.ok()) << (store ? Text() : store.error().message);
        return std::move(store).value();
    }
    PresetShelf shelf() const { return PresetShelf(catalogue_.presets); }
    // As another run of the program finds them.
    StoredPresets stored() {
        session::Store store = open();
        auto read = readStoredPresets(store);
        EXPECT_TRUE(read.ok()) << (read ? Text() : read.error().message);
        return std::move(read).value();
    }
    PresetShelf reopened() {
        PresetShelf next = shelf();
        next.join(stored());
        return next;
    }
    void write(PresetShelf& from) {
        session::Store store = open();
        for (const PresetDocument& document : from.takeChanges()) {
            const auto done = writePresetDocument(store, document);
            EXPECT_TRUE(done.ok()) << (done ? Text() : done.error().message);
        }
    }
    const TransferFunction& bone() const { return **scene::findPreset(catalogue_, "ct-bone"); }
    static std::vector<std::string> titles(const PresetShelf& shelf) {
        std::vector<std::string> titles;
        for (const auto& preset : shelf.own()) titles.push_back(preset->title());
        return titles;
    }
    scene::StudyState seenState() const {
        scene::StudyState state;
        state.seriesDigest = "feedc0de";
        state.settings.look = trace::Look::mip;
        state.settings.exposure = 2.5;
        state.lights = catalogue_.lights.back();
        state.clip = *catalogue_.clips.front();
        state.windows.at(std::size_t(trace::Look::mip)) = DisplayWindow{
            .center = 40.0, .width = 400.0, .explanation = "Doe^John", .function = "LINEAR_EXACT"};
        state.slices.crosshairMm = glm::dvec3(1.0);
        state.slices.window =
            DisplayWindow{.center = 50.0, .width = 350.0, .explanation = "Doe^John", .function = {}};
        state.measurements.resize(1);
        state.leavesTableOut = true;
        state.camera = Camera{.positionMm = {10.0, -700.0, 5.0}, .targetMm = {3.0, 2.0, 1.0}};
        return state;
    }

    fs::path folder_;
    scene::Catalogue catalogue_ = *scene::builtInCatalogue();
    std::shared_ptr<const Volume> volume_ =
        std::make_shared<const Volume>(phantom::make({.size = {24, 20, 16}}));
};

TEST_F(OwnPresets, SurviveReopeningWithTheirNamesAndCurves) {
    PresetShelf first = shelf();
    const auto id = first.add("  Knochen, мягкий 骨 ", bone());
    ASSERT_TRUE(id.ok()) << id.error().message;
    ASSERT_TRUE(first.add("Second", *catalogue_.presets.front()).ok());
    write(first);
    const PresetShelf second = reopened();
    EXPECT_EQ(titles(second), (std::vector<std::string>{"Knochen, мягкий 骨", "Second"}));
    const auto preset = second.find(*id);
    ASSERT_NE(preset, nullptr);
    EXPECT_EQ(preset->function->opacity, bone().opacity);
    EXPECT_EQ(preset->function->colour, bone().colour);
    EXPECT_TRUE(*preset == *first.find(*id));
    EXPECT_EQ(scene::copiedFrom(*preset->function), "ct-bone");
    EXPECT_EQ(preset->function->number, std::nullopt);
}

TEST_F(OwnPresets, HaveKeysThatFilesTakeAndThatNoOtherHas) {
    PresetShelf all = shelf();
    std::set<std::string> keys;
    for (const char* name : {"Кость", "骨", "CT Bone", "Cinematic  Kopf"}) {
        const auto id = all.add(name, bone());
        ASSERT_TRUE(id.ok()) << name << ": " << id.error().message;
        const TransferFunction& function = *all.find(*id)->function;
        EXPECT_TRUE(keys.insert(function.name).second) << function.name;
        EXPECT_FALSE(scene::findPreset(catalogue_, function.name).ok()) << function.name;
        const auto read = transferFunctionFromJson(toJson(function), {});
        ASSERT_TRUE(read.ok()) << read.error().message;
        EXPECT_EQ(read->title, name == std::string("Cinematic  Kopf") ? "Cinematic Kopf" : name);
    }
}

TEST_F(OwnPresets, NoTwoHaveOneNameAndNoneThatOfABuiltInOne) {
    PresetShelf all = shelf();
    ASSERT_TRUE(all.add("Mine", bone()).ok());
    for (const char* taken : {"Mine", " mine ", "CT-Bone", "ct-bone"}) {
        const auto again = all.add(taken, bone());
        ASSERT_FALSE(again.ok()) << taken;
        EXPECT_EQ(again.error().code, ErrorCode::usage);
    }
    EXPECT_EQ(all.own().size(), 1u);
    EXPECT_EQ(all.nearestFreeName("Mine"), "Mine (2)");
    EXPECT_EQ(all.nearestFreeName("Free"), "Free");
    const std::string longest(kMostPresetNameLetters, 'x');
    ASSERT_TRUE(all.add(longest, bone()).ok());
    EXPECT_EQ(all.nearestFreeName(longest), std::string(kMostPresetNameLetters - 4, 'x') + " (2)");
    // Of a script whose letters have several bytes.
    std::string wide;
    for (std::size_t i = 0; i < kMostPresetNameLetters; ++i) wide += "骨";
    ASSERT_TRUE(all.add(wide, bone()).ok());
    EXPECT_TRUE(all.add(all.nearestFreeName(wide), bone()).ok());
}

TEST_F(OwnPresets, AreRenamedRemovedAndPutBack) {
    PresetShelf all = shelf();
    const PresetRef a = *all.add("A", bone());
    const PresetRef b = *all.add("B", bone());
    EXPECT_FALSE(all.rename(b, "a").ok());
    EXPECT_TRUE(all.rename(a, "a").ok()) << "of its own name another spelling";
    ASSERT_TRUE(all.rename(a, "Z").ok());
    EXPECT_FALSE(all.rename("ct-bone", "Mine").ok()) << "built in";
    write(all);
    EXPECT_EQ(titles(reopened()), (std::vector<std::string>{"B", "Z"}));
    EXPECT_EQ(all.remove("ct-bone"), nullptr);
    const auto removed = all.remove(a);
    ASSERT_NE(removed, nullptr);
    write(all);
    EXPECT_EQ(titles(reopened()), std::vector<std::string>{"B"});
    ASSERT_TRUE(all.rename(b, "Z").ok());
    all.putBack(*removed);
    write(all);
    EXPECT_EQ(titles(reopened()), (std::vector<std::string>{"Z", "Z (2)"})) << "its name was taken meanwhile";
    EXPECT_NE(all.find(a), nullptr);
}

TEST_F(OwnPresets, CurvesThatNoFileHoldsAreRefusedAndNothingChanges) {
    PresetShelf all = shelf();
    TransferFunction wrong = bone();
    wrong.opacity.front().value = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(all.add("NaN", wrong).ok());
    wrong = bone();
    wrong.opacity.clear();
    EXPECT_FALSE(all.add("Empty", wrong).ok());
    wrong = bone();
    wrong.opacity.back().value = 1e12;
    const auto far = all.add("Far", wrong);
    ASSERT_FALSE(far.ok());
    EXPECT_TRUE(far.error().message.english().starts_with("The preset cannot be kept: "))
        << far.error().message;
    wrong = bone();
    wrong.opacity.assign(5000, {.value = 0.0, .opacity = 1.0});
    EXPECT_FALSE(all.add("Many points", wrong).ok());
    EXPECT_TRUE(all.own().empty());
    EXPECT_TRUE(all.takeChanges().empty());
}

TEST_F(OwnPresets, AllThatWasSeenComesBackAndNothingOfTheStudy) {
    PresetShelf first = shelf();
    const scene::StudyState state = seenState();
    const PresetRef id = *first.add("As seen", bone(), seenOf(state, *volume_));
    write(first);
    const auto preset = reopened().find(id);
    ASSERT_NE(preset, nullptr);
    ASSERT_TRUE(preset->seen.has_value());
    EXPECT_EQ(toJson(*preset).find("Doe"), std::string::npos);
    EXPECT_EQ(toJson(*preset).find("feedc0de"), std::string::npos);

    scene::StudyState next;
    next.seriesDigest = "of the other";
    next.measurements.resize(2);
    use(*preset, *volume_, next);
    EXPECT_EQ(next.seriesDigest, "of the other");
    EXPECT_EQ(next.measurements.size(), 2u);
    EXPECT_FALSE(next.leavesTableOut);
    EXPECT_EQ(next.slices.crosshairMm, std::nullopt);
    EXPECT_EQ(next.settings, state.settings);
    EXPECT_EQ(*next.lights, *state.lights);
    EXPECT_EQ(next.clip->name, state.clip->name);
    EXPECT_EQ(next.windows.at(std::size_t(trace::Look::mip))->width, 400.0);
    EXPECT_EQ(next.slices.window->width, 350.0);
    const Camera camera = cameraIn(*preset->seen->camera, *volume_);
    EXPECT_LT(glm::distance(camera.positionMm, state.camera->positionMm), 1e-9);
    EXPECT_LT(glm::distance(camera.targetMm, state.camera->targetMm), 1e-9);
    EXPECT_EQ(camera.up, state.camera->up);
}

TEST_F(OwnPresets, WindowsInHounsfieldUnitsAreNotUsedOnOtherValues) {
    PresetShelf all = shelf();
    const PresetRef id = *all.add("As seen", bone(), seenOf(seenState(), *volume_));
    const auto raw = Volume::create({.size = glm::ivec3(2), .unit = Unit::raw, .modality = "MR"},
                                    std::vector<std::uint16_t>(8, 7));
    scene::StudyState next;
    use(*all.find(id), *raw, next);
    EXPECT_EQ(next.settings.look, trace::Look::mip);
    EXPECT_EQ(next.windows.at(std::size_t(trace::Look::mip)), std::nullopt);
    EXPECT_EQ(next.slices.window, std::nullopt);
}

TEST_F(OwnPresets, RawWindowsOfOneStudyAreNotThoseOfAnother) {
    const auto raw = Volume::create({.size = glm::ivec3(2), .unit = Unit::raw, .modality = "MR"},
                                    std::vector<std::uint16_t>(8, 7));
    TransferFunction function = bone();
    function.unit = Unit::raw;
    ASSERT_TRUE(suits(function, raw->unit()));
    PresetShelf all = shelf();
    const PresetRef id = *all.add("As seen", function, seenOf(seenState(), *volume_));
    scene::StudyState next;
    use(*all.find(id), *raw, next);
    EXPECT_EQ(next.settings.look, trace::Look::mip);
    EXPECT_EQ(next.windows.at(std::size_t(trace::Look::mip)), std::nullopt);
    EXPECT_EQ(next.slices.window, std::nullopt);
}

TEST_F(OwnPresets, ParallelRaysComeBackAndFitTheOtherVolume) {
    scene::StudyState state = seenState();
    state.camera->parallelHeightMm = 37.5;
    PresetShelf first = shelf();
    const PresetRef id = *first.add("As seen", bone(), seenOf(state, *volume_));
    write(first);
    const auto preset = reopened().find(id);
    ASSERT_NE(preset, nullptr);
    EXPECT_TRUE(*preset == *first.find(id));
    EXPECT_NEAR(cameraIn(*preset->seen->camera, *volume_).parallelHeightMm, 37.5, 1e-9);
    phantom::Options twice{.size = {24, 20, 16}};
    twice.spacingMm *= 2.0;
    const Volume larger = phantom::make(twice);
    EXPECT_NEAR(cameraIn(*preset->seen->camera, larger).parallelHeightMm,
                37.5 * larger.worldBox().diagonal() / volume_->worldBox().diagonal(), 1e-9);
}

TEST_F(OwnPresets, FavouritesAndThoseUsedLastSurviveReopening) {
    PresetShelf first = shelf();
    const PresetRef own = *first.add("Mine", bone());
    first.setFavourite(own, true);
    first.setFavourite("ct-lung", true);
    first.setFavourite("ct-fat", true);
    first.setFavourite("ct-fat", false);
    first.noteUsed("ct-lung", "CT");
    first.noteUsed("mr-angio", "MR");
    first.noteUsed(own, "CT");
    first.noteUsed("ct-lung", "CT");
    write(first);
    const PresetShelf second = reopened();
    EXPECT_TRUE(second.isFavourite(own));
    EXPECT_TRUE(second.isFavourite("ct-lung"));
    EXPECT_FALSE(second.isFavourite("ct-fat"));
    EXPECT_EQ(second.lastUsed("CT"), (std::vector<PresetRef>{"ct-lung", own}));
    EXPECT_EQ(second.lastUsed("MR"), std::vector<PresetRef>{"mr-angio"});
    EXPECT_TRUE(second.lastUsed("US").empty());
}

TEST_F(OwnPresets, ThoseUsedLastAreNotMoreThanFit) {
    PresetShelf all = shelf();
    for (int i = 0; i < 100; ++i) all.noteUsed("preset-" + std::to_string(i), "CT");
    EXPECT_EQ(all.lastUsed("CT").size(), kMostLastUsed);
    EXPECT_EQ(all.lastUsed("CT").front(), "preset-99");
    write(all);
    EXPECT_EQ(reopened().lastUsed("CT"), all.lastUsed("CT"));
}

TEST_F(OwnPresets, OfTwoWindowsNothingIsLost) {
    PresetShelf first = shelf();
    PresetShelf second = shelf();
    ASSERT_TRUE(first.add("Mine", bone()).ok());
    ASSERT_TRUE(second.add("Mine", *catalogue_.presets.front()).ok());
    first.setFavourite("ct-lung", true);
    second.setFavourite("ct-fat", true);
    write(first);
    write(second);
    const PresetShelf third = reopened();
    EXPECT_EQ(titles(third), (std::vector<std::string>{"Mine", "Mine (2)"}));
    EXPECT_NE(third.own()[0]->function->name, third.own()[1]->function->name);
    EXPECT_TRUE(third.isFavourite("ct-lung") && third.isFavourite("ct-fat"));
}

TEST_F(OwnPresets, ADamagedOneIsLeftOutAndTheOthersAreThere) {
    PresetShelf first = shelf();
    ASSERT_TRUE(first.add("MARKERAAAA", bone()).ok());
    ASSERT_TRUE(first.add("Sound", bone()).ok());
    write(first);
    const fs::path file = folder_ / "sessions" / "sessions.db";
    std::stringstream content;
    content << std::ifstream(file, std::ios::binary).rdbuf();
    std::string bytes = content.str();
    std::size_t changed = 0;
    for (std::size_t at = 0; (at = bytes.find("MARKERAAAA", at)) != std::string::npos; ++changed)
        bytes.replace(at, 10, "MARKERBBBB");
    ASSERT_GT(changed, 0u);
    std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
    const StoredPresets read = stored();
    EXPECT_EQ(read.damaged, 1u);
    ASSERT_EQ(read.own.size(), 1u);
    EXPECT_EQ(read.own.front().title(), "Sound");
}

TEST_F(OwnPresets, WhatThisVersionDoesNotUnderstandStaysInTheStore) {
    const std::string newer = R"({"version": 2, "title": "From the future", "shape": [1, 2]})";
    {
        session::Store store = open();
        for (const char* text : {newer.c_str(), "{}", R"({"version": 1, "title": "x", "preset": 7})",
                                 R"({"version": 1, "title": "\u202e", "preset": {"volumeProperties": []}})"})
            ASSERT_TRUE(store
                            .putDocument(
                                {DocumentKind::preset, {}, "own-" + std::to_string(std::string(text).size())},
                                2, text, {})
                            .ok());
        ASSERT_TRUE(store.putDocument({DocumentKind::favourite, {}, "preset x"}, 1, "{}", {}).ok());
        ASSERT_TRUE(store
                        .putDocument({DocumentKind::favourite, {}, std::string(kLastUsedDocument)}, 1,
                                     R"({"version": 1, "lastUsed": 3})", {})
                        .ok());
        ASSERT_TRUE(store.putDocument({DocumentKind::favourite, {}, "of something else"}, 1, "{}", {}).ok());
        ASSERT_TRUE(store.putDocument({DocumentKind::preset, {}, "windows of slices"}, 1, "{}", {}).ok());
    }
    const StoredPresets read = stored();
    EXPECT_EQ(read.unreadable, 6u);
    EXPECT_EQ(read.damaged, 0u);
    EXPECT_TRUE(read.own.empty() && read.favourites.empty() && read.lastUsed.empty());
    session::Store store = open();
    const auto kept = store.getDocument({DocumentKind::preset, {}, "own-" + std::to_string(newer.size())});
    ASSERT_TRUE(kept.ok() && kept->has_value());
    EXPECT_EQ((*kept)->json, newer);
}

TEST(PresetKinds, EachVolumeHasItsOwn) {
    const scene::Catalogue catalogue = *scene::builtInCatalogue();
    const auto fitting = [&](Unit unit, const char* modality) {
        const auto volume = Volume::create({.size = glm::ivec3(2), .unit = unit, .modality = modality},
                                           std::vector<std::uint16_t>(8, 7));
        const scene::FitsVolume fits(*volume);
        std::set<std::string> names;
        for (const auto& preset : catalogue.presets)
            if (fits(*preset)) names.insert(preset->name);
        return names;
    };
    const auto ct = fitting(Unit::hounsfield, "CT");
    EXPECT_TRUE(ct.contains("ct-bone") && ct.contains("cinematic-chest"));
    for (const char* other : {"uct-skull", "uct-bone-8bit", "mr-angio", "us-fetal", "cinematic-mr"})
        EXPECT_FALSE(ct.contains(other)) << other;
    const auto mr = fitting(Unit::raw, "MR");
    EXPECT_TRUE(mr.contains("mr-angio") && mr.contains("cinematic-mr") && mr.contains("dti-fa-brain"));
    EXPECT_FALSE(mr.contains("ct-bone") || mr.contains("uct-skull"));
    EXPECT_TRUE(fitting(Unit::raw, "US").contains("us-fetal"));
    EXPECT_TRUE(fitting(Unit::raw, "CT").contains("uct-skull"));
    EXPECT_EQ(fitting(Unit::suvBodyWeight, "PT"), std::set<std::string>{"cinematic-pet"});
    // Nothing is made for it: what it is shown with is there.
    EXPECT_EQ(fitting(Unit::raw, "OT"), std::set<std::string>{"cinematic-mr"});
    EXPECT_EQ(scene::kindOf(**scene::findPreset(catalogue, "uct-skull")), "µCT");
    EXPECT_EQ(scene::kindOf(**scene::findPreset(catalogue, "dti-fa-brain")), "DTI");
    EXPECT_EQ(scene::kindOf(**scene::findPreset(catalogue, "ct-bone")), "CT");
    EXPECT_EQ(scene::kindOf(TransferFunction{}), "");
}

}  // namespace
}  // namespace macula::live
