#include "viewer/driven/script_line.h"

#include <gtest/gtest.h>

namespace macula::viewer {
namespace {

using Script = ScriptLine::Script;

Result<ScriptLine> parse(QStringList arguments) {
    arguments.prepend(QStringLiteral("macula-viewer-bench"));
    return parseScriptLine(arguments);
}

TEST(ScriptLine, ReadsTheScriptItsOptionsAndThoseOfTheWindow) {
    const auto line = parse({"orbit",
                             "/some/folder",
                             "--preset",
                             "ct-bone",
                             "--lights",
                             "rim",
                             "--view",
                             "superior",
                             "--size",
                             "800x600",
                             "--spp",
                             "7",
                             "--screenshots",
                             "out",
                             "--seconds",
                             "2.5",
                             "--wait",
                             "3",
                             "--rest",
                             "40",
                             "--no-model",
                             "--device",
                             "llvmpipe",
                             "--turn",
                             "30",
                             "--layout",
                             "coronal",
                             "--high-contrast",
                             "--font-scale",
                             "1.5"});
    ASSERT_TRUE(line.ok()) << line.error().message;
    EXPECT_EQ(line->script, Script::orbit);
    EXPECT_EQ(line->screenshots, QStringLiteral("out"));
    EXPECT_EQ(line->seconds, 2.5);
    EXPECT_EQ(line->waitSeconds, 3.0);
    EXPECT_EQ(line->turnSeconds, 30.0);
    EXPECT_EQ(line->restSeconds, 40.0);
    EXPECT_EQ(line->window.folder, QStringLiteral("/some/folder"));
    EXPECT_EQ(line->window.view, ViewDirection::superior);
    EXPECT_EQ(line->window.size, QSize(800, 600));
    EXPECT_EQ(line->window.samples, 7u);
    EXPECT_FALSE(line->window.usesModel);
    EXPECT_EQ(line->window.layout, scene::Layout::coronal);
    EXPECT_TRUE(line->window.highContrast);
    EXPECT_EQ(line->window.fontScale, 1.5);
    EXPECT_EQ(line->window.device, QStringLiteral("llvmpipe"));
}

TEST(ScriptLine, WithoutAFolderItIsThePhantom) {
    const auto line = parse({"orbit"});
    ASSERT_TRUE(line.ok());
    EXPECT_FALSE(line->window.folder.has_value());
    EXPECT_EQ(line->window.samples, 512u);
    EXPECT_TRUE(line->window.usesModel);
}

// What a script is told of sizes is of the volume's picture.
TEST(ScriptLine, OrbitAndChangesSeeTheVolume) {
    for (const char* name : {"orbit", "changes"})
        EXPECT_EQ(parse({name})->window.layout, scene::Layout::volume) << name;
    EXPECT_EQ(parse({"orbit", "--layout", "fourPanes"})->window.layout, scene::Layout::fourPanes);
    // These are of the window as a person has it.
    for (const char* name : {"session", "opening"})
        EXPECT_EQ(parse({name})->window.layout, scene::Layout::fourPanes) << name;
    const auto stations = parse({"stations", "--screenshots", "x"});
    ASSERT_TRUE(stations.ok());
    EXPECT_EQ(stations->window.layout, scene::Layout::fourPanes);
}

TEST(ScriptLine, StationsNeedAFolderForTheirPictures) {
    const auto stations = parse({"stations", "--screenshots", "x"});
    ASSERT_TRUE(stations.ok());
    EXPECT_EQ(stations->script, Script::stations);
    EXPECT_FALSE(stations->namesPatient);
    EXPECT_FALSE(parse({"stations"}).ok()) << "there is no folder for them";
    EXPECT_FALSE(parse({"session", "--screenshots", "x"}).ok());
    EXPECT_FALSE(parse({"--until", "open"}).ok());
    EXPECT_FALSE(parse({"orbit", "--until", "open"}).ok());
    EXPECT_EQ(parse({"stations", "--screenshots", "x", "--until", "open"})->lastStation,
              QStringLiteral("open"));
}

// A script measures: what was learnt before would be in its figures.
TEST(ScriptLine, KeepsAStudyOnlyWhereItIsTold) {
    EXPECT_FALSE(parse({"orbit"})->window.keepsStudies);
    const auto told = parse({"orbit", "--sessions", "x"});
    EXPECT_TRUE(told->window.keepsStudies);
    EXPECT_EQ(told->window.sessions, QStringLiteral("x"));
    EXPECT_FALSE(parse({"orbit", "--sessions", "x", "--no-session"}).ok());
    EXPECT_FALSE(parse({"orbit", "--sessions", ""}).ok());
}

TEST(ScriptLine, NothingIsDeletedWhereNothingIsKept) {
    qputenv("MACULA_KEEP_DAYS", "30");
    EXPECT_EQ(parse({"orbit"})->window.keepDays, std::nullopt);
    qunsetenv("MACULA_KEEP_DAYS");
    const auto wrong = parse({"orbit", "--keep-days", "9"});
    ASSERT_FALSE(wrong.ok());
    EXPECT_NE(wrong.error().hint.english().find("--sessions"), std::string::npos);
    EXPECT_EQ(parse({"orbit", "--keep-days", "9", "--sessions", "x"})->window.keepDays, 9);
}

TEST(ScriptLine, RefusesWhatDoesNotExist) {
    for (const QStringList& wrong :
         {QStringList{}, QStringList{"dance"}, QStringList{"orbit", "--seconds", "nan"},
          QStringList{"orbit", "--seconds", "-1"}, QStringList{"orbit", "--wait", "-1"},
          QStringList{"orbit", "--rest", "0"}, QStringList{"changes", "--screenshots", "x"},
          QStringList{"--screenshots", "x"}, QStringList{"orbit", "--view", "sideways"},
          QStringList{"orbit", "--script", "orbit"}, QStringList{"orbit", "a", "b"}}) {
        const auto line = parse(wrong);
        ASSERT_FALSE(line.ok()) << wrong.join(' ').toStdString();
        EXPECT_EQ(line.error().code, ErrorCode::usage);
        EXPECT_FALSE(line.error().message.empty());
        EXPECT_FALSE(line.error().hint.empty());
    }
    EXPECT_NE(parse({"dance"}).error().hint.english().find("'stations'"), std::string::npos);
    EXPECT_EQ(parse({"orbit", "a", "b"}).error().hint.english(), "Run macula-viewer-bench --help.");
}

// Nobody is there to wear a headset or to wait for a calibration.
TEST(ScriptLine, HasNoOptionThatIsOfAPersonAlone) {
    EXPECT_FALSE(parse({"orbit", "--calibrate"}).ok());
    EXPECT_FALSE(parse({"orbit", "--xr"}).ok());
}

TEST(ScriptLine, ScreenshotsNameNobodyUnlessThatIsAskedFor) {
    EXPECT_TRUE(parse({"changes"})->namesPatient);
    EXPECT_TRUE(parse({"orbit"})->namesPatient);
    EXPECT_FALSE(parse({"orbit", "--screenshots", "x"})->namesPatient);
    EXPECT_TRUE(parse({"orbit", "--screenshots", "x", "--with-patient"})->namesPatient);
}

TEST(ScriptLine, HelpNeedsNoDisplayAndNoScript) {
    const auto line = parse({"--help"});
    ASSERT_TRUE(line.ok());
    const QString text = line->window.print.value_or(QString());
    EXPECT_TRUE(text.contains(QStringLiteral(" [options] SCRIPT [FOLDER]\n")));
    for (const char* option : {"--preset", "--screenshots", "--until", "'changes'"})
        EXPECT_TRUE(text.contains(QLatin1String(option))) << option;
}

}  // namespace
}  // namespace macula::viewer
