#include "viewer/program/command_line.h"

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
    EXPECT_TRUE(line->usesModel);
}

TEST(CommandLine, MeasuresTheMachineAlone) {
    EXPECT_FALSE(parse({})->calibrates);
    EXPECT_TRUE(parse({"--calibrate", "--device", "0"})->calibrates);
    EXPECT_FALSE(parse({"--calibrate", "/some/folder"}).ok());
    EXPECT_FALSE(parse({"--calibrate", "--script", "orbit"}).ok());
}

TEST(CommandLine, ReadsAllOptions) {
    const auto line = parse({"/some/folder", "--preset", "ct-bone", "--lights", "rim", "--view", "superior",
                             "--size", "800x600", "--spp", "7", "--no-model", "--device", "llvmpipe",
                             "--layout", "coronal", "--high-contrast", "--font-scale", "1.5"});
    ASSERT_TRUE(line.ok()) << line.error().message;
    EXPECT_EQ(line->folder, QStringLiteral("/some/folder"));
    EXPECT_EQ(line->view, ViewDirection::superior);
    EXPECT_EQ(line->size, QSize(800, 600));
    EXPECT_EQ(line->samples, 7u);
    EXPECT_FALSE(line->usesModel);
    EXPECT_EQ(line->layout, scene::Layout::coronal);
    EXPECT_TRUE(line->highContrast);
    EXPECT_EQ(line->fontScale, 1.5);
    EXPECT_EQ(line->device, QStringLiteral("llvmpipe"));
}

TEST(CommandLine, TellsLinksFromPaths) {
    const auto link = parse({"macula://open?study=1.2"});
    ASSERT_TRUE(link.ok());
    EXPECT_EQ(link->link, QStringLiteral("macula://open?study=1.2"));
    EXPECT_FALSE(link->folder);
    EXPECT_TRUE(link->isAlone);
    EXPECT_FALSE(parse({"--view", "left", "macula://open?study=1.2"})->isAlone);
    EXPECT_EQ(parse({"macula:--preset=x"})->link, QStringLiteral("macula:--preset=x")) << "the window tells";
    EXPECT_EQ(parse({"file:///some/f%C3%B6lder%20x"})->folder, QStringLiteral("/some/f\u00f6lder x"));
    EXPECT_EQ(parse({"file://localhost/a"})->folder, QStringLiteral("/a"));
    for (const char* elsewhere : {"file://host/a", "file:a", "file:///a?b", "file:///a#b"})
        EXPECT_FALSE(parse({QString::fromLatin1(elsewhere)}).ok()) << elsewhere;
    EXPECT_FALSE(parse({"macula://open?study=1.2", "/a"}).ok());
    EXPECT_FALSE(parse({"--calibrate", "macula://open?study=1.2"}).ok());
}

TEST(CommandLine, APersonSeesFourPanes) {
    EXPECT_EQ(parse({})->layout, scene::Layout::fourPanes);
    EXPECT_FALSE(parse({})->choosesLayout);
}

TEST(CommandLine, SessionsAreKeptUnlessAPersonSaysNo) {
    EXPECT_TRUE(parse({})->keepsStudies);
    EXPECT_EQ(parse({})->sessions, std::nullopt);
    EXPECT_FALSE(parse({"--no-session"})->keepsStudies);
    const auto told = parse({"--sessions", "x"});
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
    qputenv("MACULA_KEEP_DAYS", "a month");
    const auto wrong = parse({});
    ASSERT_FALSE(wrong.ok());
    EXPECT_NE(wrong.error().message.english().find("MACULA_KEEP_DAYS is 'a month'"), std::string::npos);
    EXPECT_TRUE(parse({"--no-session"}).ok()) << "nobody asks for it there";
    qunsetenv("MACULA_KEEP_DAYS");
    for (const char* days : {"0", "-1", "36501", "1.5", "nan", "", "99999999999"})
        EXPECT_FALSE(parse({"--keep-days", days}).ok()) << days;
    EXPECT_FALSE(parse({"--keep-days", "9", "--no-session"}).ok());
}

TEST(CommandLine, RefusesWhatDoesNotExist) {
    for (const QStringList& wrong :
         {QStringList{"--view", "sideways"}, QStringList{"--size", "800"}, QStringList{"--size", "8x6"},
          QStringList{"--size", "99999x600"}, QStringList{"--spp", "0"}, QStringList{"--spp", "many"},
          QStringList{"--layout", "five"}, QStringList{"--font-scale", "3"}, QStringList{"--language", "xx"},
          QStringList{"--screenshots", "x"}, QStringList{"--until", "open"}, QStringList{"--unknown"},
          QStringList{"a", "b"}}) {
        const auto line = parse(wrong);
        ASSERT_FALSE(line.ok()) << wrong.join(' ').toStdString();
        EXPECT_EQ(line.error().code, ErrorCode::usage);
        EXPECT_FALSE(line.error().message.empty());
        EXPECT_FALSE(line.error().hint.empty());
    }
}

TEST(CommandLine, ScriptsAreOfAnotherProgram) {
    const auto line = parse({"--script", "orbit", "--seconds", "2"});
    ASSERT_FALSE(line.ok());
    EXPECT_EQ(line.error().code, ErrorCode::usage);
    EXPECT_NE(line.error().message.english().find("script"), std::string::npos);
    EXPECT_NE(line.error().hint.english().find("macula-viewer-bench"), std::string::npos);
    EXPECT_EQ(parse({"--unknown"}).error().hint.english(), "Run macula-viewer --help.");
}

TEST(CommandLine, HelpNeedsNoDisplay) {
    const auto line = parse({"--help"});
    ASSERT_TRUE(line.ok());
    const QString text = line->print.value_or(QString());
    EXPECT_TRUE(text.contains(QStringLiteral("--preset")));
    EXPECT_TRUE(text.contains(QStringLiteral(" [options] [FOLDER]\n")));
    EXPECT_FALSE(text.contains(QStringLiteral("--script")));
}

}  // namespace
}  // namespace macula::viewer
