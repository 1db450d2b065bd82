// macula presets: what it lists, shows and converts.
#include <nlohmann/json.hpp>

#include "base/paths.h"
#include "cli/run_command.h"

namespace macula::cli {
namespace {

using Presets = CommandTest;
using nlohmann::json;

const std::string kXml =
    R"(<MRML><VolumeProperty name="CT-One" scalarOpacity="4 0 0 10 1" colorTransfer="4 0 1 1 1"/>
       <VolumeProperty name="CT-Two" scalarOpacity="4 0 0 20 1" colorTransfer="4 0 1 1 1" effectiveRange="-1.0.0 2"/></MRML>)";

TEST_F(Presets, AreListed) {
    const json list = json::parse(runMacula({"presets", "--json"}).out);
    ASSERT_EQ(list["presets"].size(), test::filesIn("presets/transfer", ".json"));
    EXPECT_EQ(list["presets"][0]["source"], "Macula");
    const auto first =
        std::ranges::find_if(list["presets"], [](const json& one) { return one["number"] == 1; });
    ASSERT_NE(first, list["presets"].end());
    EXPECT_EQ((*first)["name"], "ct-aaa");
    EXPECT_EQ(list["lights"].size(), test::filesIn("presets/lights", ".json"));
    EXPECT_EQ(runMacula({"presets", "list", "--json"}).out, runMacula({"presets", "--json"}).out);
    const std::string text = runMacula({"presets"}).out;
    EXPECT_NE(text.find("  3  ct-bone "), std::string::npos) << text;
}

TEST_F(Presets, AreShown) {
    const std::string text = runMacula({"presets", "show", "CT-Bone"}).out;
    EXPECT_NE(text.find("641.385"), std::string::npos) << text;
    EXPECT_EQ(runMacula({"presets", "show", "3"}).out, text);
    EXPECT_EQ(json::parse(runMacula({"presets", "show", "ct-bone", "--json"}).out)["macula"]["number"], 3);
    EXPECT_NE(runMacula({"presets", "show", "31"}).out.find("gradient opacity (units per voxel)"),
              std::string::npos);
}

TEST_F(Presets, AreExportedAndImportedToTheSameBytes) {
    ASSERT_EQ(runMacula({"presets", "export", "CT-Lung", "-o", at("a.json")}).exitCode, 0);
    ASSERT_EQ(runMacula({"presets", "import", at("a.json"), "-o", at("b.json")}).exitCode, 0);
    EXPECT_EQ(readAll(at("a.json")), readAll(at("b.json")));
    EXPECT_EQ(runMacula({"presets", "show", at("b.json")}).out,
              runMacula({"presets", "show", "CT-Lung"}).out);
}

TEST_F(Presets, AFileOfSeveralGoesToAFolderOrIsChosenFrom) {
    const std::string xml = write("presets.xml", kXml);
    const Ran one = runMacula({"presets", "import", xml, "-o", at("a.json")});
    EXPECT_EQ(one.exitCode, 2);
    EXPECT_EQ(one.errorLines(), 1u) << one.err;
    std::filesystem::create_directory(at("out"));
    const Ran all = runMacula({"presets", "import", xml, "-o", at("out")});
    EXPECT_EQ(all.exitCode, 0) << all.err;
    EXPECT_NE(all.err.find("CT-Two: The effective range"), std::string::npos) << all.err;
    EXPECT_EQ(fileCount("out"), 2u);
    EXPECT_NE(runMacula({"presets", "show", xml + "#ct-two"}).out.find("20"), std::string::npos);
    EXPECT_EQ(runMacula({"presets", "show", xml + "#2"}).out,
              runMacula({"presets", "show", xml + "#CT-Two"}).out);
    EXPECT_EQ(runMacula({"presets", "show", xml}).exitCode, 2);
    const Ran unknown = runMacula({"presets", "show", xml + "#CT-Three"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_NE(unknown.err.find("CT-One, CT-Two"), std::string::npos) << unknown.err;
}

TEST_F(Presets, BadInputIsOneLine) {
    const auto expectRefused = [&](int exitCode, const std::vector<std::string>& arguments) {
        const std::size_t before = fileCount();
        const Ran ran = runMacula(arguments);
        EXPECT_EQ(ran.exitCode, exitCode) << ran.err;
        EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
        EXPECT_EQ(fileCount(), before);
    };
    expectRefused(2, {"presets", "dance"});
    expectRefused(2, {"presets", "show"});
    expectRefused(2, {"presets", "show", "CT-Unicorn"});
    expectRefused(2, {"presets", "export", "CT-Bone"});
    expectRefused(2, {"presets", "export", "CT-Bone", "-o", at("no/such/a.json")});
    expectRefused(3, {"presets", "import", at("missing.xml"), "-o", at("a.json")});
    const std::string cut = write("cut.xml", kXml.substr(0, 100));
    expectRefused(3, {"presets", "import", cut, "-o", at("a.json")});
    const std::string bomb = write("bomb.plist", "<!DOCTYPE a [<!ENTITY x \"y\">]><plist/>");
    expectRefused(3, {"presets", "import", bomb, "-o", at("a.json")});
}

// A preset that could only be drawn as something else is refused before anything is loaded.
TEST_F(Presets, RenderRefusesWhatItCannotDraw) {
    const Ran noRange =
        runMacula({"render", "-o", at("a.png"), "--size", "16x16", "--preset", "CT-X-ray", "--fit"});
    EXPECT_EQ(noRange.exitCode, 3);
    EXPECT_NE(noRange.err.find("fitted"), std::string::npos) << noRange.err;
    EXPECT_EQ(fileCount(), 0u);
}

TEST_F(Presets, RenderTakesNamesNumbersAndFilesAndSaysWhatWasFitted) {
    const auto render = [&](const std::string& name, const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"render", "-o", at(name), "--size", "16x16",
                                           "--spp",  "1",  "--json", "-"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runMacula(arguments);
    };
    const Ran byNumber = render("a.png", {"--preset", "4"});
    ASSERT_EQ(byNumber.exitCode, 0) << byNumber.err;
    EXPECT_EQ(json::parse(byNumber.out)["preset"], "ct-bones");
    const Ran fromXml = render("b.png", {"--preset", write("p.xml", kXml) + "#CT-One"});
    ASSERT_EQ(fromXml.exitCode, 0) << fromXml.err;
    EXPECT_EQ(json::parse(fromXml.out)["preset"], "custom");
    const Ran fitted = render("c.png", {"--preset", "MR-Default", "--fit"});
    ASSERT_EQ(fitted.exitCode, 0) << fitted.err;
    EXPECT_NE(fitted.err.find("0 to 220 are drawn at"), std::string::npos) << fitted.err;
}

}  // namespace
}  // namespace macula::cli
