#include "scene/transfer/own_copy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "pipeline/volume/transfer_function_json.h"
#include "presets/catalogue.h"
#include "scene/state/study_state.h"
#include "scene/transfer/same_transfer.h"

namespace macula::scene {
namespace {

using Json = nlohmann::json;

TransferFunction ctBone() {
    const auto all = presets::builtInPresets();
    return *std::ranges::find_if(*all,
                                 [](const TransferFunction& preset) { return preset.name == "ct-bone"; });
}

TEST(OwnCopy, HasANameOfItsOwnAndTheSameCurves) {
    const TransferFunction original = ctBone();
    TransferFunction copy = ownCopy(original, {});
    EXPECT_EQ(copy.title, "CT-Bone (edited)");
    EXPECT_EQ(copy.name, "ct-bone-edited");
    EXPECT_FALSE(copy.number);
    EXPECT_TRUE(validate(copy));
    copy.title = original.title;
    copy.name = original.name;
    copy.number = original.number;
    EXPECT_TRUE(isSame(copy, original));
}

// What the licence asks for stays; what is true of the original only goes.
TEST(OwnCopy, KeepsWhoWroteItAndSaysThatItWasEdited) {
    Json text = Json::parse(toJson(ctBone()));
    text["macula"]["author"] = "A. Author";
    text["macula"]["license"] = "BSD-3-Clause";
    text["macula"]["sha256"] = "0123";
    text["macula"]["mine"] = {{"deep", 1}};
    const auto original = transferFunctionFromJson(text.dump(), "here");
    ASSERT_TRUE(original);
    const TransferFunction copy = ownCopy(*original, {});
    const Json macula = Json::parse(toJson(copy))["macula"];
    EXPECT_EQ(macula["author"], "A. Author");
    EXPECT_EQ(macula["license"], "BSD-3-Clause");
    EXPECT_EQ(macula["source"], "3D Slicer");
    EXPECT_EQ(macula["mine"]["deep"], 1);
    EXPECT_EQ(macula["derivedFrom"], "ct-bone");
    EXPECT_TRUE(macula["provenance"].get<std::string>().starts_with(
        "Edited copy of CT-Bone, which is: Control points of presets.xml"));
    for (const char* key : {"id", "sha256", "number"}) EXPECT_FALSE(macula.contains(key)) << key;

    const auto again = transferFunctionFromJson(toJson(copy), "there");
    ASSERT_TRUE(again);
    EXPECT_TRUE(isSame(*again, copy));
    EXPECT_EQ(copiedFrom(*again), "ct-bone");
    EXPECT_EQ(copiedFrom(*original), "");
}

TEST(OwnCopy, TakesNoNameThatIsTaken) {
    const TransferFunction first = ownCopy(ctBone(), {});
    const TransferFunction second = ownCopy(ctBone(), {"ct-bone-edited"});
    EXPECT_EQ(second.title, "CT-Bone (edited 2)");
    EXPECT_EQ(second.name, "ct-bone-edited-2");
    EXPECT_EQ(ownCopy(ctBone(), {"ct-bone-edited", "ct-bone-edited-2"}).name, "ct-bone-edited-3");
    const TransferFunction ofCopy = ownCopy(first, {});
    EXPECT_EQ(ofCopy.title, "CT-Bone (edited 2)");
    EXPECT_EQ(copiedFrom(ofCopy), "ct-bone-edited");
    EXPECT_EQ(ownCopy(second, {"ct-bone-edited"}).title, "CT-Bone (edited 3)");
}

TEST(OwnCopy, OnlyOurMarkIsTakenOff) {
    TransferFunction function = ctBone();
    for (const char* title : {"Bone (edited by me)", "(edited)", "Bone (edited 2", "Bone (edited )"}) {
        function.title = title;
        EXPECT_EQ(ownCopy(function, {}).title, std::string(title) + " (edited)");
    }
}

TEST(OwnCopy, CopesWithAnyTitleAndDocument) {
    TransferFunction function = ctBone();
    function.title = std::string(300, 'x');
    std::set<std::string> taken;
    for (int i = 0; i < 12; ++i) {
        const TransferFunction copy = ownCopy(function, taken);
        EXPECT_LE(copy.name.size(), 64u);
        EXPECT_TRUE(taken.insert(copy.name).second) << copy.name;
    }
    for (const char* title : {"", "…", "\xff\xfe", "---"}) {
        function.title = title;
        for (const char* document : {"", "no JSON", "[1]", "{\"macula\": 3}", "{\"macula\": {\"id\": 3}}"}) {
            function.document = document;
            const TransferFunction copy = ownCopy(function, {});
            EXPECT_FALSE(copy.name.empty());
            EXPECT_EQ(copiedFrom(copy), "ct-bone");
        }
    }
    function.document = "\"derivedFrom\"";
    EXPECT_EQ(copiedFrom(function), "");
    function.document = R"({"macula": {"derivedFrom": 3}})";
    EXPECT_EQ(copiedFrom(function), "");
}

}  // namespace
}  // namespace macula::scene
