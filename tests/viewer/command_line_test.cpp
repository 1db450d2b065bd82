#include "viewer/command_line.h"

#include <gtest/gtest.h>

namespace macula::viewer {
namespace {

Result<CommandLine> parse(QStringList arguments) {
    arguments.prepend(QStringLiteral("macula-viewer"));
    return parseCommandLine(arguments);
}

TEST(CommandLine, WithoutArgumentsItIsThePhantom) {
    const auto line = parse({});
    ASSERT_TRUE(line.ok());
    EXPECT_FALSE(line->folder.has_value());
    EXPECT_EQ(line->samples, 512u);
    EXPECT_EQ(line->script, CommandLine::Script::none);
    EXPECT_TRUE(line->usesModel);
}

TEST(CommandLine, MeasuresTheMachineAlone) {
    EXPECT_FALSE(parse({})->calibrates);
    EXPECT_TRUE(parse({"--calibrate", "--device", "0"})->calibrates);
    EXPECT_FALSE(parse({"--calibrate", "/some/folder"}).ok());
    EXPECT_FALSE(parse({"--calibrate", "--script", "orbit"}).ok());
}

TEST(CommandLine, ReadsAllOptions) {
    const auto line = parse({"/some/folder",
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
                             "--script",
                             "orbit",
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
    EXPECT_EQ(line->folder, QStringLiteral("/some/folder"));
    EXPECT_EQ(line->view, ViewDirection::superior);
    EXPECT_EQ(line->size, QSize(800, 600));
    EXPECT_EQ(line->samples, 7u);
    EXPECT_EQ(line->script, CommandLine::Script::orbit);
    EXPECT_EQ(line->waitSeconds, 3.0);
    EXPECT_EQ(line->turnSeconds, 30.0);
    EXPECT_EQ(line->restSeconds, 40.0);
    EXPECT_FALSE(line->usesModel);
    EXPECT_EQ(line->layout, scene::Layout::coronal);
    EXPECT_TRUE(line->highContrast);
    EXPECT_EQ(line->fontScale, 1.5);
    EXPECT_EQ(line->seconds, 2.5);
    EXPECT_EQ(line->device, QStringLiteral("llvmpipe"));
}

// What a script is told of sizes is of the volume's picture.
TEST(CommandLine, APersonSeesFourPanesAndAScriptTheVolume) {
    EXPECT_EQ(parse({})->layout, scene::Layout::fourPanes);
    EXPECT_EQ(parse({"--script", "orbit"})->layout, scene::Layout::volume);
    EXPECT_EQ(parse({"--script", "orbit", "--layout", "fourPanes"})->layout, scene::Layout::fourPanes);
    // These are of the window as a person has it.
    for (const char* name : {"session", "opening"})
        EXPECT_EQ(parse({"--script", name})->layout, scene::Layout::fourPanes) << name;
    const auto stations = parse({"--script", "stations", "--screenshots", "x"});
    ASSERT_TRUE(stations.ok());
    EXPECT_EQ(stations->script, CommandLine::Script::stations);
    EXPECT_FALSE(stations->namesPatient);
    EXPECT_FALSE(parse({"--script", "stations"}).ok()) << "there is no folder for them";
    EXPECT_FALSE(parse({"--script", "session", "--screenshots", "x"}).ok());
    EXPECT_FALSE(parse({"--until", "open"}).ok());
    EXPECT_EQ(parse({"--script", "stations", "--screenshots", "x", "--until", "open"})->lastStation,
              QStringLiteral("open"));
}

// A script measures: what was learnt before would be in its figures.
TEST(CommandLine, SessionsAreKeptUnlessAScriptOrAPersonSaysNo) {
    EXPECT_TRUE(parse({})->keepsStudies);
    EXPECT_EQ(parse({})->sessions, std::nullopt);
    EXPECT_FALSE(parse({"--no-session"})->keepsStudies);
    EXPECT_FALSE(parse({"--script", "orbit"})->keepsStudies);
    const auto told = parse({"--script", "orbit", "--sessions", "x"});
    EXPECT_TRUE(told->keepsStudies);
    EXPECT_EQ(told->sessions, QStringLiteral("x"));
    EXPECT_FALSE(parse({})->choosesView);
    EXPECT_TRUE(parse({"--view", "left"})->choosesView);
    EXPECT_FALSE(parse({"--sessions", "x", "--no-session"}).ok());
    EXPECT_FALSE(parse({"--sessions", ""}).ok());
}

TEST(CommandLine, NothingIsDeletedByItselfUnlessDaysAreTold) {
    EXPECT_EQ(parse({})->keepDays, std::nullopt);
    EXPECT_EQ(parse({"--keep-days", "90"})->keepDays, 90);
    qputenv("MACULA_KEEP_DAYS", "30");
    EXPECT_EQ(parse({})->keepDays, 30);
    EXPECT_EQ(parse({"--keep-days", "90"})->keepDays, 90) << "the option counts more";
    EXPECT_EQ(parse({"--no-session"})->keepDays, std::nullopt);
    EXPECT_EQ(parse({"--script", "orbit"})->keepDays, std::nullopt);
    qputenv("MACULA_KEEP_DAYS", "a month");
    const auto wrong = parse({});
    ASSERT_FALSE(wrong.ok());
    EXPECT_NE(wrong.error().message.english().find("MACULA_KEEP_DAYS is 'a month'"), std::string::npos);
    EXPECT_TRUE(parse({"--no-session"}).ok()) << "nobody asks for it there";
    qunsetenv("MACULA_KEEP_DAYS");
    for (const char* days : {"0", "-1", "36501", "1.5", "nan", "", "99999999999"})
        EXPECT_FALSE(parse({"--keep-days", days}).ok()) << days;
    EXPECT_FALSE(parse({"--keep-days", "9", "--no-session"}).ok());
    EXPECT_FALSE(parse({"--keep-days", "9", "--script", "orbit"}).ok());
    EXPECT_EQ(parse({"--keep-days", "9", "--script", "orbit", "--sessions", "x"})->keepDays, 9);
}

TEST(CommandLine, RefusesWhatDoesNotExist) {
    for (const QStringList& wrong :
         {QStringList{"--view", "sideways"}, QStringList{"--size", "800"}, QStringList{"--size", "8x6"},
          QStringList{"--size", "99999x600"}, QStringList{"--spp", "0"}, QStringList{"--spp", "many"},
          QStringList{"--seconds", "nan"}, QStringList{"--wait", "-1"}, QStringList{"--rest", "0"},
          QStringList{"--script", "changes", "--screenshots", "x"}, QStringList{"--seconds", "-1"},
          QStringList{"--layout", "five"}, QStringList{"--font-scale", "3"}, QStringList{"--script", "dance"},
          QStringList{"--screenshots", "x"}, QStringList{"--unknown"}, QStringList{"a", "b"}}) {
        const auto line = parse(wrong);
        ASSERT_FALSE(line.ok()) << wrong.join(' ').toStdString();
        EXPECT_EQ(line.error().code, ErrorCode::usage);
        EXPECT_FALSE(line.error().message.empty());
        EXPECT_FALSE(line.error().hint.empty());
    }
}

TEST(CommandLine, ScreenshotsNameNobodyUnlessThatIsAskedFor) {
    EXPECT_TRUE(parse({})->namesPatient);
    EXPECT_TRUE(parse({"--script", "orbit"})->namesPatient);
    EXPECT_FALSE(parse({"--script", "orbit", "--screenshots", "x"})->namesPatient);
    EXPECT_TRUE(parse({"--script", "orbit", "--screenshots", "x", "--with-patient"})->namesPatient);
}

TEST(CommandLine, HelpNeedsNoDisplay) {
    const auto line = parse({"--help"});
    ASSERT_TRUE(line.ok());
    EXPECT_TRUE(line->print.value_or(QString()).contains(QStringLiteral("--preset")));
}

}  // namespace
}  // namespace macula::viewer
