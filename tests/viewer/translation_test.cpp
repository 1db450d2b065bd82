// German: nothing that the window says is left in English, and what is put into a sentence arrives there.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/paths.h"
#include "scene/choice/catalogue.h"
#include "scene/choice/quality_choice.h"
#include "viewer/keys/keys.h"
#include "viewer/language/window_language.h"
#include "viewer/language/language.h"
#include "viewer/offscreen.h"

namespace macula::viewer {
namespace {

struct Text {
    QString context;
    QString source;
    QString translation;
    bool isUnfinished = false;
};

std::vector<Text> textsIn(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) throw std::runtime_error(path.toStdString());
    QXmlStreamReader xml(&file);
    std::vector<Text> texts;
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == QLatin1String("name")) context = xml.readElementText();
        if (xml.name() == QLatin1String("source")) texts.push_back({context, xml.readElementText(), {}});
        if (xml.name() == QLatin1String("translation")) {
            texts.back().isUnfinished = xml.attributes().hasAttribute(QLatin1String("type"));
            texts.back().translation = xml.readElementText(QXmlStreamReader::IncludeChildElements);
        }
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    return texts;
}

QString folder() {
    return QString::fromStdString((macula::test::projectFolder() / "src/viewer/translations/").string());
}

// The places of a text: "%1", "%L2", and "%n" of how many.
QStringList placesOf(const QString& text) {
    static const QRegularExpression place(QStringLiteral("%L?[1-9n]"));
    QSet<QString> places;
    for (auto matches = place.globalMatch(text); matches.hasNext();) places << matches.next().captured();
    QStringList sorted(places.begin(), places.end());
    sorted.sort();
    return sorted;
}

TEST(Translation, EveryTextHasOneWithTheSamePlaces) {
    for (const char* name : {"macula_de.ts", "core_de.ts"}) {
        const std::vector<Text> texts = textsIn(folder() + QLatin1String(name));
        EXPECT_GT(texts.size(), 300u) << name;
        for (const Text& text : texts) {
            EXPECT_FALSE(text.isUnfinished || text.translation.isEmpty())
                << name << ": " << text.source.toStdString();
            if (QLatin1String(name) == QLatin1String("macula_de.ts")) {
                EXPECT_EQ(placesOf(text.source), placesOf(text.translation)) << text.source.toStdString();
            }
            for (const QString& place : placesOf(text.translation))
                EXPECT_TRUE(placesOf(text.source).contains(place)) << text.source.toStdString();
        }
    }
}

// Of English there is only what is said of one thing and of several.
TEST(Translation, EnglishHasBothFormsOfEachCount) {
    const std::vector<Text> english = textsIn(folder() + QStringLiteral("macula_en.ts"));
    EXPECT_GE(english.size(), 17u);
    for (const Text& text : english) {
        EXPECT_FALSE(text.isUnfinished || text.translation.trimmed().isEmpty()) << text.source.toStdString();
        EXPECT_TRUE(text.source.contains(QLatin1String("%n")) || text.source.contains(QLatin1String("%Ln")));
        EXPECT_EQ(placesOf(text.source), placesOf(text.translation)) << text.source.toStdString();
    }
}

// On a panel of a headset: src/xr/room_words.h says how many letters fit. A sharp s is two.
TEST(Translation, WordsOfTheHeadsetFitItsPanel) {
    std::map<QString, QString> words;
    for (const Text& text : textsIn(folder() + QStringLiteral("macula_de.ts"))) {
        if (text.context != QLatin1String("HeadsetWords")) continue;
        words[text.source] = QString(text.translation).replace(QStringLiteral("ß"), QStringLiteral("SS"));
    }
    ASSERT_EQ(words.size(), 27u);
    constexpr int kButtonLetters = 15;
    constexpr int kPanelLetters = 32;
    constexpr int kSentenceLetters = 52;
    for (const char* button : {"Knife: on", "Knife: off", "Reset clips", "Undo", "Take picture",
                               "Other wrist", "Real size 1:1", "Before me"})
        EXPECT_LE(words.at(button).size(), kButtonLetters) << button;
    for (const char* held : {"nothing", "ball", "box"})
        EXPECT_LE(words.at("Hold: %1").arg(words.at(held)).size(), kButtonLetters) << held;
    for (const char* quality : {"fast", "balanced", "fine"})
        EXPECT_LE(words.at("Quality: %1").arg(words.at(quality)).size(), kPanelLetters) << quality;
    for (const char* size : {"%1 times real size", "1/%1 of real size"})
        EXPECT_LE(words.at(size).arg("100,00").size(), kPanelLetters) << size;
    for (const char* line : {"Not for primary diagnosis", "Size is not calibrated"})
        EXPECT_LE(words.at(line).size(), kPanelLetters) << line;
    words["Picture %1 is written."] = words.at("Picture %1 is written.").arg("macula-headset-100.png");
    for (const auto& [source, translation] : words)
        EXPECT_LE(translation.size(), kSentenceLetters) << source.toStdString();
    for (const Text& text : textsIn(folder() + QStringLiteral("core_de.ts"))) {
        if (!text.source.startsWith(QLatin1String("The folder for pictures ")) &&
            text.source != QLatin1String("The picture could not be written.") &&
            text.source != QLatin1String("There is not enough memory for the picture."))
            continue;
        EXPECT_LE(QString(text.translation).replace(QStringLiteral("ß"), QStringLiteral("SS")).size(),
                  kSentenceLetters)
            << text.source.toStdString();
    }
}

// What tr() marks in the sources, against the file: packaging/translations adds what is missing there.
TEST(Translation, NoTextOfTheWindowIsMissing) {
    const QString lupdate = QString::fromLatin1(MACULA_LUPDATE);
    if (!QFile::exists(lupdate)) GTEST_SKIP() << "packaging/bootstrap installs lupdate";
    QTemporaryDir scratch;
    const QString found = scratch.filePath(QStringLiteral("found_de.ts"));
    const QString sources = QString::fromStdString((macula::test::projectFolder() / "src").string());
    QProcess process;
    process.start(lupdate, {"-silent", sources + "/viewer", "-I", sources, "-locations", "none",
                            "-target-language", "de", "-ts", found});
    ASSERT_TRUE(process.waitForFinished(30'000)) << process.errorString().toStdString();
    ASSERT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
    std::set<std::pair<QString, QString>> known;
    for (const Text& text : textsIn(folder() + QStringLiteral("macula_de.ts")))
        known.insert({text.context, text.source});
    const std::vector<Text> texts = textsIn(found);
    EXPECT_GT(texts.size(), 300u);
    for (const Text& text : texts)
        EXPECT_TRUE(known.contains({text.context, text.source}))
            << "run packaging/translations, and translate: " << text.source.toStdString();
}

class GermanTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        useLanguage(Language::german);
    }
    void TearDown() override {
        useLanguage(Language::english);
        QLocale::setDefault(QLocale::c());
        OffscreenTest::TearDown();
    }
    static std::set<QString> coreTexts() {
        std::set<QString> known;
        for (const Text& text : textsIn(folder() + QStringLiteral("core_de.ts"))) known.insert(text.source);
        return known;
    }
};

TEST_F(GermanTest, TextsOfTheWindowAreInTheProgram) {
    EXPECT_EQ(QCoreApplication::translate("macula::viewer::OpeningController", "&Open Folder…"),
              QStringLiteral("&Ordner öffnen…"));
    EXPECT_EQ(QLocale().decimalPoint(), QStringLiteral(","));
    useLanguage(Language::english);
    EXPECT_EQ(QCoreApplication::translate("macula::viewer::OpeningController", "&Open Folder…"),
              QStringLiteral("&Open Folder…"));
    EXPECT_EQ(inWindowsLanguage(std::string("There is only one slice.")),
              QStringLiteral("There is only one slice."));
}

TEST_F(GermanTest, OneThingIsNotToldAsSeveral) {
    const auto pictures = [](int count) {
        return QCoreApplication::translate("macula::viewer::MoviePanel", "%Ln pictures", nullptr, count);
    };
    EXPECT_EQ(pictures(1), QStringLiteral("1 Bild"));
    EXPECT_EQ(pictures(2), QStringLiteral("2 Bilder"));
    EXPECT_EQ(inWindowsLanguage(std::string("1 part")), QStringLiteral("1 Teil"));
    EXPECT_EQ(inWindowsLanguage(std::string("3 parts")), QStringLiteral("3 Teile"));
    useLanguage(Language::english);
    EXPECT_EQ(pictures(1), QStringLiteral("1 picture"));
    EXPECT_EQ(pictures(0), QStringLiteral("0 pictures"));
}

TEST_F(GermanTest, WindowsOfSlicesAndTheErrorOf16BitsArriveInGerman) {
    EXPECT_EQ(titleInWindowsLanguage("Soft tissue"), QStringLiteral("Weichteile"));
    EXPECT_EQ(
        inWindowsLanguage(
            std::string("The 3D picture has values of 16 bits, with an error of at most 0.25 SUV bw.")),
        QStringLiteral("Das 3D-Bild hat Werte von 16 Bit, mit einem Fehler von höchstens 0,25 SUV bw."));
    EXPECT_EQ(inWindowsLanguage(
                  std::string("The 3D picture shows values below -2800 Bq/mL or above 6799 Bq/mL as these.")),
              QStringLiteral("Das 3D-Bild zeigt Werte unter -2800 Bq/mL oder über 6799 Bq/mL wie diese."));
    EXPECT_EQ(titleInWindowsLanguage("SUV 0 to 15"), QStringLiteral("SUV 0 bis 15"));
}

TEST_F(GermanTest, WhatIsNotCalibratedArrivesInGerman) {
    EXPECT_EQ(inWindowsLanguage(std::string("The table is left out, and whatever else lies apart from the "
                                            "patient: 3 parts, ≈ 120 mL, not calibrated (confidence high).")),
              QStringLiteral("Der Tisch und was sonst abseits des Patienten liegt, ist weggelassen: 3 Teile, "
                             "≈ 120 mL, nicht kalibriert (Sicherheit: hoch)."));
    EXPECT_EQ(inWindowsLanguage(std::string("The table is left out, and whatever else lies apart from the "
                                            "patient: 1 part, 120 mL (confidence high).")),
              QStringLiteral("Der Tisch und was sonst abseits des Patienten liegt, ist weggelassen: 1 Teil, "
                             "120 mL (Sicherheit: hoch)."));
    EXPECT_EQ(listInWindowsLanguage("512 × 256 · 1 × 1 × 2 mm · not calibrated", QStringLiteral(" · ")),
              QStringLiteral("512 × 256 · 1 × 1 × 2 mm · nicht kalibriert"));
    EXPECT_EQ(inWindowsLanguage(std::string("Images that do not say by what kind of device they were taken "
                                            "(Modality): 2 of 12; they were taken for CT, by their kind of "
                                            "object.")),
              QStringLiteral("Bilder, die nicht sagen, mit was für einem Gerät sie aufgenommen wurden "
                             "(Modality): 2 von 12; sie gelten als CT, nach der Art ihrer Objekte."));
}

TEST_F(GermanTest, KeysAndTitlesOfWhatIsBuiltInHaveOne) {
    const std::set<QString> known = coreTexts();
    const auto has = [&](const std::string& text) { return known.contains(QString::fromStdString(text)); };
    for (const KeyRow& row : kKeys) {
        EXPECT_TRUE(has(row.does)) << row.does;
        EXPECT_TRUE(row.hand[0] == '\0' || has(row.hand)) << row.hand;
    }
    for (const LayoutRow& row : kLayouts) EXPECT_TRUE(has(row.title)) << row.title;
    for (const trace::LookTraits& look : trace::kLooks) EXPECT_TRUE(has(std::string(look.title)));
    const auto catalogue = scene::builtInCatalogue();
    ASSERT_TRUE(catalogue.ok());
    for (const auto& lights : catalogue->lights) EXPECT_TRUE(has(lights->title)) << lights->title;
    for (const auto& clip : catalogue->clips) EXPECT_TRUE(has(clip->title)) << clip->title;
    for (const auto& preset : catalogue->presets) {
        // "CT-Bone": those of others are names.
        if (preset->title.find(' ') != std::string::npos) {
            EXPECT_TRUE(has(preset->title)) << preset->title;
        }
    }
    const auto qualities = scene::builtInQualities();
    ASSERT_TRUE(qualities.ok());
    for (const trace::Quality& quality : *qualities) EXPECT_TRUE(has(quality.title)) << quality.title;
}

// Literals of the tables of messages, as a reader of C++ joins them; "{count}" is a place.
QStringList sentencesOf(const char* source) {
    std::ifstream file(macula::test::projectFolder() / source);
    std::stringstream text;
    text << file.rdbuf();
    static const QRegularExpression literals(
        QStringLiteral("\"(?:[^\"\\\\\\n]|\\\\.)*\"(?:\\s*\"(?:[^\"\\\\\\n]|\\\\.)*\")*"));
    static const QRegularExpression seam(QStringLiteral("\"\\s*\""));
    static const QRegularExpression place(QStringLiteral("\\{[^}]*\\}"));
    QStringList sentences;
    auto matches = literals.globalMatch(QString::fromStdString(text.str()));
    while (matches.hasNext()) {
        QString sentence = matches.next().captured();
        sentence = sentence.mid(1, sentence.size() - 2).remove(seam);
        for (int number = 1; sentence.contains(place); ++number) {
            const QRegularExpressionMatch match = place.match(sentence);
            sentence.replace(match.capturedStart(), match.capturedLength(),
                             QStringLiteral("%%1").arg(number));
        }
        if (sentence.contains(QLatin1Char(' ')) && sentence.endsWith(QLatin1Char('.'))) sentences << sentence;
    }
    return sentences;
}

TEST_F(GermanTest, MessagesWithKeysHaveOne) {
    const std::set<QString> known = coreTexts();
    for (const char* source : {"src/dicom/messages/messages.cpp", "src/segment/messages.cpp"}) {
        const QStringList sentences = sentencesOf(source);
        EXPECT_GT(sentences.size(), 8) << source;
        for (const QString& sentence : sentences)
            EXPECT_TRUE(known.contains(sentence)) << source << ": " << sentence.toStdString();
    }
}

TEST_F(GermanTest, WhatStandsInASentenceArrivesInTheOther) {
    const auto german = [](const char* text) { return inWindowsLanguage(std::string(text)); };
    EXPECT_EQ(german("Slices that are missing: 3 of 40, which are 1.250 mm apart."),
              QStringLiteral("Fehlende Schichten: 3 von 40, die 1,250 mm auseinander liegen."));
    EXPECT_EQ(german("The images do not make a volume: their sizes differ."),
              QStringLiteral("Die Bilder ergeben kein Volumen: ihre Größen unterscheiden sich."));
    EXPECT_EQ(
        german("Nothing is left to remove on the left side. Move the cross-hair into what is shown."),
        QStringLiteral("Auf der Seite links ist nichts mehr zu entfernen. Bewegen Sie das Fadenkreuz in das "
                       "Gezeigte."));
    EXPECT_EQ(german("Of 3 volumes the axial one with the most voxels (512 x 512 x 90)."),
              QStringLiteral("Von 3 Volumen das axiale mit den meisten Voxeln (512 x 512 x 90)."));
    EXPECT_EQ(inWindowsLanguage(
                  Error{ErrorCode::usage, Text("The folder does not exist."), {}, Text("Check the path.")}),
              QStringLiteral("Den Ordner gibt es nicht. Prüfen Sie den Pfad."));
}

// Text of a file, or of a later version, is shown as it is.
TEST_F(GermanTest, WhatNobodyTranslatedStaysAsItIs) {
    for (const char* text :
         {"", " ", "Nobody knows this.", "%1", "left", "High", "100 %", "\\d+ (", "Ünïcödé"}) {
        EXPECT_EQ(inWindowsLanguage(std::string(text)), QString::fromUtf8(text));
    }
    EXPECT_EQ(listInWindowsLanguage("CT, series 3: High, no description"),
              QStringLiteral("CT, Serie 3: High, keine Beschreibung"));
    EXPECT_EQ(listInWindowsLanguage("MR, series 3: axial"), QStringLiteral("MR, Serie 3: axial"));
    EXPECT_EQ(inWindowsLanguage(std::string("Series 5: Segmentation")),
              QStringLiteral("Serie 5: Segmentation"));
    const std::string huge(10'000, 'a');
    EXPECT_EQ(inWindowsLanguage(huge), QString::fromStdString(huge));
}

TEST_F(GermanTest, TitlesAndTheirCopies) {
    EXPECT_EQ(titleInWindowsLanguage("Cinematic bone"), QStringLiteral("Cinematic Knochen"));
    EXPECT_EQ(titleInWindowsLanguage("Cinematic bone (edited 2)"),
              QStringLiteral("Cinematic Knochen (bearbeitet 2)"));
    EXPECT_EQ(titleInWindowsLanguage("CT-Bone"), QStringLiteral("CT-Bone"));
}

TEST_F(GermanTest, NumbersHaveACommaAndIdentifiersKeepTheirPoints) {
    EXPECT_EQ(withLocalNumbers(QStringLiteral("12.5 mm, 3 HU, v. 4")), QStringLiteral("12,5 mm, 3 HU, v. 4"));
    useLanguage(Language::english);
    EXPECT_EQ(withLocalNumbers(QStringLiteral("12.5 mm")), QStringLiteral("12.5 mm"));
}

TEST(Language, IsKnownByItsCode) {
    EXPECT_EQ(languageOf(QStringLiteral("de")), Language::german);
    EXPECT_EQ(languageOf(QStringLiteral("en")), Language::english);
    for (const char* code : {"", "DE", "fr", "deu"}) EXPECT_EQ(languageOf(QLatin1String(code)), std::nullopt);
    for (const LanguageRow& row : kLanguages) EXPECT_EQ(languageOf(codeOf(row.language)), row.language);
}

}  // namespace
}  // namespace macula::viewer
