// What a person has set: kept, read again whatever the file has become, and less than what the line says.
#include "viewer/settings/settings.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QTemporaryDir>
#include <fstream>

#include "base/atomic_file.h"
#include "viewer/offscreen.h"
#include "viewer/program/command_line.h"
#include "viewer/settings/settings_dialog.h"

namespace macula::viewer {
namespace {

namespace fs = std::filesystem;

Settings someSettings() {
    Settings settings;
    settings.language = Language::german;
    settings.highContrast = true;
    settings.fontScale = 1.5;
    settings.storeFolder = QStringLiteral("/some/folder");
    settings.keepDays = 90;
    settings.modelCapMb = 500;
    settings.quality = QStringLiteral("draft");
    settings.deidentifies = true;
    settings.showsNames = false;
    settings.keys = {{QStringLiteral("F3"), QStringLiteral("Ctrl+K")}, {QStringLiteral("F4"), QString()}};
    settings.folders = {{QStringLiteral("studies"), QStringLiteral("/archive")}};
    settings.watchedFolders = {QStringLiteral("/incoming"), QStringLiteral("/media/discs")};
    settings.windowPlace = QStringLiteral("AAEC");
    settings.priors = PriorSearch::fetch;
    settings.archiveColumns = QStringLiteral("AAED");
    settings.mouse = QStringLiteral("scroll");
    settings.layouts = {{QStringLiteral("0123"), QStringLiteral("axial")}};
    settings.receiving = {.atStart = true,
                          .title = QStringLiteral("INBOX"),
                          .port = 104,
                          .address = QString(),
                          .callers = {QStringLiteral("CT1@10.1.2.3"), QStringLiteral("*@10.1.0.0/16")},
                          .admitsAnyone = true,
                          .certificate = QStringLiteral("/own.pem"),
                          .key = QStringLiteral("/key.pem"),
                          .authorities = QStringLiteral("/all.pem"),
                          .limitGb = 7};
    return settings;
}

class SettingsFileTest : public testing::Test {
  protected:
    fs::path file() const { return fs::path(folder_.path().toStdString()) / "macula" / "settings.json"; }
    void write(const std::string& text) const {
        fs::create_directories(file().parent_path());
        std::ofstream(file()) << text;
    }

    QTemporaryDir folder_;
};

TEST_F(SettingsFileTest, ComeBackAsTheyWere) {
    EXPECT_EQ(*readSettings(file()), Settings{}) << "no file yet";
    ASSERT_TRUE(writeSettings(someSettings(), file()).ok());
    const auto read = readSettings(file());
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(*read, someSettings());
    using enum fs::perms;
    EXPECT_EQ(fs::status(file()).permissions() & (group_all | others_all), none) << "it names folders";
}

TEST_F(SettingsFileTest, WhatALaterVersionWroteStays) {
    write(R"({"version": 7, "theme": {"colour": 3}, "fontScale": 1.2})");
    auto read = readSettings(file());
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(read->fontScale, 1.2);
    ASSERT_TRUE(writeSettings(*read, file()).ok());
    EXPECT_NE(readText(file())->find("\"colour\": 3"), std::string::npos);
}

TEST_F(SettingsFileTest, ADamagedFileIsToldAndKept) {
    for (const char* text : {"", "{", "[]", "null", "\xff\xfe"}) {
        write(text);
        const auto read = readSettings(file());
        ASSERT_FALSE(read.ok()) << text;
        EXPECT_EQ(read.error().code, ErrorCode::inputNotUsable);
        EXPECT_FALSE(read.error().hint.empty());
        ASSERT_TRUE(writeSettings(someSettings(), file()).ok());
        EXPECT_EQ(*readSettings(file()), someSettings());
        EXPECT_EQ(*readText(fs::path(file()).concat(".damaged")), text);
    }
}

TEST_F(SettingsFileTest, AValueThatIsNoneCountsAsNotThere) {
    for (
        const char* text :
        {R"({"fontScale": 1e300, "keepDays": 0, "modelCapMb": -1, "language": "xx"})",
         R"({"fontScale": "large", "keepDays": 1.5, "modelCapMb": null, "language": 3, "keys": [1]})",
         R"({"highContrast": "yes", "showsNames": 1, "deidentifies": {}, "quality": 5, "keys": {"F3": 4}})"}) {
        const auto read = settingsFromJson(text);
        ASSERT_TRUE(read.ok()) << text;
        EXPECT_EQ(*read, Settings{}) << text;
    }
}

TEST_F(SettingsFileTest, WhereNothingCanBeWrittenIsTold) {
    std::ofstream(folder_.filePath(QStringLiteral("macula")).toStdString()) << "a file, and no folder";
    const auto written = writeSettings(someSettings(), file());
    ASSERT_FALSE(written.ok());
    EXPECT_EQ(written.error().code, ErrorCode::outputNotWritable);
}

CommandLine parsed(QStringList arguments) {
    arguments.prepend(QStringLiteral("macula-viewer"));
    return *parseCommandLine(arguments);
}

// Two windows write one file: what one has not touched is as the other has set it.
TEST(SettingsOfTwoWindows, OnlyWhatIsChangedIsWritten) {
    Settings before = someSettings();
    before.keys = {{QStringLiteral("F2"), QStringLiteral("Ctrl+J")},
                   {QStringLiteral("F3"), QStringLiteral("Ctrl+K")}};
    Settings stored = before;
    stored.keepDays = std::nullopt;
    stored.fontScale = 1.25;
    stored.keys[QStringLiteral("F4")] = QStringLiteral("Ctrl+L");
    stored.others[QStringLiteral("colour")] = 3;
    EXPECT_EQ(withChanges(stored, before, before), stored);

    Settings after = before;
    after.language = std::nullopt;
    after.showsNames = !before.showsNames;
    after.keys.remove(QStringLiteral("F2"));
    after.keys[QStringLiteral("F3")] = QStringLiteral("Ctrl+M");
    after.folders[QStringLiteral("pictures")] = QStringLiteral("/pictures");
    stored.folders[QStringLiteral("studies")] = QStringLiteral("/other");
    Settings wanted = stored;
    wanted.language = std::nullopt;
    wanted.folders = {{QStringLiteral("studies"), QStringLiteral("/other")},
                      {QStringLiteral("pictures"), QStringLiteral("/pictures")}};
    wanted.showsNames = after.showsNames;
    wanted.keys = {{QStringLiteral("F3"), QStringLiteral("Ctrl+M")},
                   {QStringLiteral("F4"), QStringLiteral("Ctrl+L")}};
    EXPECT_EQ(withChanges(stored, before, after), wanted);
    EXPECT_EQ(withChanges(before, Settings{}, Settings{}), before);
}

TEST(SettingsOnTheLine, TheLineCountsMore) {
    const CommandLine set = withSettings(parsed({}), someSettings());
    EXPECT_EQ(set.language, Language::german);
    EXPECT_TRUE(set.highContrast);
    EXPECT_EQ(set.fontScale, 1.5);
    EXPECT_EQ(set.sessions, QStringLiteral("/some/folder"));
    EXPECT_EQ(set.keepDays, 90);
    const CommandLine told =
        withSettings(parsed({"--language", "en", "--font-scale", "1", "--sessions", "x", "--keep-days", "9"}),
                     someSettings());
    EXPECT_EQ(told.language, Language::english);
    EXPECT_EQ(told.fontScale, 1.0);
    EXPECT_EQ(told.sessions, QStringLiteral("x"));
    EXPECT_EQ(told.keepDays, 9);
    EXPECT_EQ(withSettings(parsed({"--calibrate"}), someSettings()).sessions, QStringLiteral("/some/folder"));
    const CommandLine none = withSettings(parsed({"--no-session"}), someSettings());
    EXPECT_EQ(none.sessions, std::nullopt);
    EXPECT_EQ(none.keepDays, std::nullopt);
    qputenv("MACULA_SESSIONS", "/elsewhere");
    EXPECT_EQ(withSettings(parsed({}), someSettings()).sessions, std::nullopt)
        << "the environment says where";
    qunsetenv("MACULA_SESSIONS");
}

TEST(SettingsOnTheLine, AnUnknownLanguageIsAnError) {
    const auto line = parseCommandLine({"macula-viewer", "--language", "xx"});
    ASSERT_FALSE(line.ok());
    EXPECT_NE(line.error().hint.english().find("en and de"), std::string::npos);
}

class SettingsDialogTest : public test::OffscreenTest {};

TEST_F(SettingsDialogTest, ShowsWhatIsSetAndGivesItBack) {
    Settings settings = someSettings();
    settings.keys = {{QStringLiteral("F3"), QStringLiteral("Ctrl+K")}};
    const KeyEntry entry{
        .id = QStringLiteral("F3"), .title = QStringLiteral("A"), .usual = QKeySequence(Qt::Key_F3)};
    EXPECT_EQ(SettingsDialog(settings, {entry}, true).settings(), settings);
    EXPECT_EQ(SettingsDialog({}, {entry}, false).settings(), Settings{});
}

TEST_F(SettingsDialogTest, TakesWhatAPersonChooses) {
    SettingsDialog dialog({}, {}, true);
    dialog.findChild<QComboBox*>(QStringLiteral("settings-language"))->setCurrentIndex(2);
    dialog.findChild<QCheckBox*>(QStringLiteral("settings-deidentify"))->setChecked(true);
    dialog.findChild<QSpinBox*>(QStringLiteral("settings-keep-days"))->setValue(30);
    dialog.findChild<QLineEdit*>(QStringLiteral("settings-folder"))->setText(QStringLiteral("  relative  "));
    const Settings now = dialog.settings();
    EXPECT_EQ(now.language, Language::german);
    EXPECT_TRUE(now.deidentifies);
    EXPECT_EQ(now.keepDays, 30);
    EXPECT_TRUE(now.storeFolder.startsWith(QLatin1Char('/')));
    EXPECT_TRUE(now.storeFolder.endsWith(QLatin1String("/relative")));
}

TEST_F(SettingsDialogTest, TakesHowToReceiveAndSaysWhatCannotWork) {
    SettingsDialog dialog({}, {}, true);
    const auto* trouble = dialog.findChild<QLabel*>(QStringLiteral("receive-trouble"));
    const auto line = [&](const char* name) {
        return dialog.findChild<QLineEdit*>(QString::fromLatin1(name));
    };
    EXPECT_TRUE(trouble->text().contains(QStringLiteral("opens nothing by itself")));
    auto* places = dialog.findChild<QComboBox*>(QStringLiteral("receive-place"));
    EXPECT_FALSE(line("receive-address")->isEnabled());
    places->setCurrentIndex(2);
    EXPECT_TRUE(line("receive-address")->isEnabled());
    EXPECT_EQ(dialog.settings().receiving.address, QStringLiteral("127.0.0.1")) << "none was entered";
    line("receive-address")->setText(QStringLiteral(" 10.1.2.3 "));
    EXPECT_TRUE(trouble->text().contains(QStringLiteral("nobody said which may")))
        << trouble->text().toStdString();
    line("receive-callers")->setText(QStringLiteral("CT 1@10.1.2.3, ,pacs@host"));
    EXPECT_TRUE(trouble->text().contains(QStringLiteral("host is no address")))
        << trouble->text().toStdString();
    line("receive-callers")->setText(QStringLiteral("CT 1@10.1.2.3, *@10.2.0.0/16"));
    EXPECT_TRUE(trouble->text().contains(QStringLiteral("opens nothing by itself")));
    line("receive-authorities")->setText(QStringLiteral("/all.pem"));
    EXPECT_TRUE(trouble->text().contains(QStringLiteral("needs a certificate")))
        << trouble->text().toStdString();
    dialog.findChild<QSpinBox*>(QStringLiteral("receive-port"))->setValue(104);
    const ReceiveSettings now = dialog.settings().receiving;
    EXPECT_EQ(now.address, QStringLiteral("10.1.2.3"));
    EXPECT_EQ(now.callers, (QStringList{QStringLiteral("CT 1@10.1.2.3"), QStringLiteral("*@10.2.0.0/16")}));
    EXPECT_EQ(now.port, 104);
    EXPECT_FALSE(now.atStart);
    places->setCurrentIndex(1);
    EXPECT_EQ(dialog.settings().receiving.address, QString());
}

}  // namespace
}  // namespace macula::viewer
