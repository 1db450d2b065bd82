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
#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/paths.h"
#include "dicom/messages/messages.h"
#include "scene/choice/catalogue.h"
#include "scene/choice/quality_choice.h"
#include "scene/clip/clip_shapes.h"
#include "segment/messages.h"
#include "viewer/keys/keys.h"
#include "viewer/language/language.h"
#include "viewer/language/window_language.h"
#include "viewer/offscreen.h"

namespace macula::viewer {
namespace {

struct Entry {
    QString context;
    QString source;
    QString translation;
    bool isUnfinished = false;
};

std::vector<Entry> textsIn(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) throw std::runtime_error(path.toStdString());
    QXmlStreamReader xml(&file);
    std::vector<Entry> texts;
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

bool isOfAllRooms(const Entry& text) {
    return text.context == QLatin1String("core") || text.context == QLatin1String("titles");
}

// The places of a text of the window: "%1", "%L2", and "%n" of how many; of a text of all rooms: "0",
// "1:.2f", "count".
QStringList placesOf(const QString& text, bool isOfAllRooms) {
    static const QRegularExpression ofTheWindow(QStringLiteral("%L?[1-9n]"));
    static const QRegularExpression ofText(QStringLiteral("\\{(\\w*)(:[^{}]*)?\\}"));
    QSet<QString> places;
    int unnumbered = 0;
    for (auto matches = (isOfAllRooms ? ofText : ofTheWindow).globalMatch(text); matches.hasNext();) {
        const QRegularExpressionMatch place = matches.next();
        if (!isOfAllRooms) {
            places << place.captured();
        } else {
            const QString id =
                place.captured(1).isEmpty() ? QString::number(unnumbered++) : place.captured(1);
            places << id + place.captured(2);
        }
    }
    QStringList sorted(places.begin(), places.end());
    sorted.sort();
    return sorted;
}

TEST(Translation, EveryTextHasOneWithTheSamePlaces) {
    const std::vector<Entry> texts = textsIn(folder() + QStringLiteral("macula_de.ts"));
    EXPECT_GT(texts.size(), 2000u);
    for (const Entry& text : texts) {
        EXPECT_FALSE(text.isUnfinished || text.translation.isEmpty()) << text.source.toStdString();
        EXPECT_EQ(placesOf(text.source, isOfAllRooms(text)), placesOf(text.translation, isOfAllRooms(text)))
            << text.source.toStdString();
    }
}

// Of English there is only what is said of one thing and of several.
TEST(Translation, EnglishHasBothFormsOfEachCount) {
    const std::vector<Entry> english = textsIn(folder() + QStringLiteral("macula_en.ts"));
    EXPECT_GE(english.size(), 17u);
    for (const Entry& text : english) {
        EXPECT_FALSE(text.isUnfinished || text.translation.trimmed().isEmpty()) << text.source.toStdString();
        EXPECT_TRUE(text.source.contains(QLatin1String("%n")) || text.source.contains(QLatin1String("%Ln")));
        EXPECT_EQ(placesOf(text.source, false), placesOf(text.translation, false))
            << text.source.toStdString();
    }
}

bool isHandTool(const QString& source) {
    return std::ranges::any_of(scene::handTools(), [&](const scene::HandTool& shape) {
        return shape.name.format() == source.toStdString();
    });
}

// On a panel of a headset: src/xr/room_words.h says how many letters fit. A sharp s is two.
TEST(Translation, WordsOfTheHeadsetFitItsPanel) {
    std::map<QString, QString> words;
    for (const Entry& text : textsIn(folder() + QStringLiteral("macula_de.ts"))) {
        const bool isShape = text.context == QLatin1String("core") && isHandTool(text.source);
        if (text.context != QLatin1String("HeadsetWords") && !isShape) continue;
        words[text.source] = QString(text.translation).replace(QStringLiteral("ß"), QStringLiteral("SS"));
    }
    ASSERT_EQ(words.size(), 25u + scene::handTools().size());
    constexpr int kButtonLetters = 15;
    constexpr int kPanelLetters = 32;
    constexpr int kSentenceLetters = 52;
    for (const char* button : {"Knife: on", "Knife: off", "Reset clips", "Undo", "Take picture",
                               "Other wrist", "Real size 1:1", "Before me"})
        EXPECT_LE(words.at(button).size(), kButtonLetters) << button;
    std::vector<std::string> held{"nothing"};
    for (const scene::HandTool& shape : scene::handTools()) held.push_back(shape.name.format());
    for (const std::string& what : held)
        EXPECT_LE(words.at("Hold: %1").arg(words.at(QString::fromStdString(what))).size(), kButtonLetters)
            << what;
    for (const char* quality : {"fast", "balanced", "fine"})
        EXPECT_LE(words.at("Quality: %1").arg(words.at(quality)).size(), kPanelLetters) << quality;
    for (const char* size : {"%1 times real size", "1/%1 of real size"})
        EXPECT_LE(words.at(size).arg("100,00").size(), kPanelLetters) << size;
    for (const char* line : {"Not for primary diagnosis", "Size is not calibrated"})
        EXPECT_LE(words.at(line).size(), kPanelLetters) << line;
    words["Picture %1 is written."] = words.at("Picture %1 is written.").arg("macula-headset-100.png");
    for (const auto& [source, translation] : words)
        EXPECT_LE(translation.size(), kSentenceLetters) << source.toStdString();
    for (const Entry& text : textsIn(folder() + QStringLiteral("macula_de.ts"))) {
        if (!isOfAllRooms(text)) continue;
        if (!text.source.startsWith(QLatin1String("The folder for pictures ")) &&
            text.source != QLatin1String("The picture could not be written.") &&
            text.source != QLatin1String("There is not enough memory for the picture."))
            continue;
        EXPECT_LE(QString(text.translation).replace(QStringLiteral("ß"), QStringLiteral("SS")).size(),
                  kSentenceLetters)
            << text.source.toStdString();
    }
}

// What tr() and Text mark in the sources, against the file, which packaging/translations keeps.
TEST(Translation, NoTextIsMissingAndNoneIsOfNoUse) {
    const QString lupdate = QString::fromLatin1(MACULA_LUPDATE);
    if (!QFile::exists(lupdate)) GTEST_SKIP() << "packaging/bootstrap installs lupdate";
    QTemporaryDir scratch;
    const QString project = QString::fromStdString(macula::test::projectFolder().string());
    const QString ofAllRooms = scratch.filePath(QStringLiteral("texts.cpp"));
    QProcess process;
    process.setStandardOutputFile(ofAllRooms);
    process.start(project + "/packaging/translations.py", {});
    ASSERT_TRUE(process.waitForFinished(60'000)) << process.errorString().toStdString();
    ASSERT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
    process.setStandardOutputFile({});
    const QString found = scratch.filePath(QStringLiteral("found_de.ts"));
    process.start(lupdate, {"-silent", project + "/src/viewer", ofAllRooms, "-I", project + "/src",
                            "-locations", "none", "-target-language", "de", "-ts", found});
    ASSERT_TRUE(process.waitForFinished(60'000)) << process.errorString().toStdString();
    ASSERT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
    const auto keysIn = [](const QString& path) {
        std::set<std::pair<QString, QString>> keys;
        for (const Entry& text : textsIn(path)) keys.insert({text.context, text.source});
        return keys;
    };
    const auto known = keysIn(folder() + QStringLiteral("macula_de.ts"));
    const auto wanted = keysIn(found);
    EXPECT_GT(wanted.size(), 2000u);
    for (const auto& key : wanted)
        EXPECT_TRUE(known.contains(key))
            << "run packaging/translations, and translate: " << key.second.toStdString();
    for (const auto& key : known)
        EXPECT_TRUE(wanted.contains(key))
            << "run packaging/translations; nobody says: " << key.second.toStdString();
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
    static std::set<QString> textsOfAllRooms() {
        std::set<QString> known;
        for (const Entry& text : textsIn(folder() + QStringLiteral("macula_de.ts")))
            if (isOfAllRooms(text)) known.insert(text.source);
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
    EXPECT_EQ(inWindowsLanguage(Text("There is only one slice.")),
              QStringLiteral("There is only one slice."));
}

TEST_F(GermanTest, OneThingIsNotToldAsSeveral) {
    const auto pictures = [](int count) {
        return QCoreApplication::translate("macula::viewer::MoviePanel", "%Ln pictures", nullptr, count);
    };
    EXPECT_EQ(pictures(1), QStringLiteral("1 Bild"));
    EXPECT_EQ(pictures(2), QStringLiteral("2 Bilder"));
    EXPECT_EQ(inWindowsLanguage(Text("1 part")), QStringLiteral("1 Teil"));
    EXPECT_EQ(inWindowsLanguage(Text("{} parts", 3)), QStringLiteral("3 Teile"));
    useLanguage(Language::english);
    EXPECT_EQ(pictures(1), QStringLiteral("1 picture"));
    EXPECT_EQ(pictures(0), QStringLiteral("0 pictures"));
}

TEST_F(GermanTest, WindowsOfSlicesAndTheErrorOf16BitsArriveInGerman) {
    EXPECT_EQ(titleInWindowsLanguage("Soft tissue"), QStringLiteral("Weichteile"));
    const Text unit(" {}", "SUV bw");
    EXPECT_EQ(
        inWindowsLanguage(
            Text("The 3D picture has values of 16 bits, with an error of at most {:.3g}{}.", 0.25, unit)),
        QStringLiteral("Das 3D-Bild hat Werte von 16 Bit, mit einem Fehler von höchstens 0,25 SUV bw."));
    EXPECT_EQ(inWindowsLanguage(Text("The 3D picture shows values below {:.4g}{} or above {:.4g}{} as these.",
                                     -2800.0, Text(" {}", "Bq/mL"), 6799.0, Text(" {}", "Bq/mL"))),
              QStringLiteral("Das 3D-Bild zeigt Werte unter -2800 Bq/mL oder über 6799 Bq/mL wie diese."));
    EXPECT_EQ(titleInWindowsLanguage("SUV 0 to 15"), QStringLiteral("SUV 0 bis 15"));
}

TEST_F(GermanTest, WhatIsNotCalibratedArrivesInGerman) {
    const auto removed = [](Text parts, Text volume) {
        return inWindowsLanguage(
            segment::message(segment::key::kTableRemoved, {{"partsText", std::move(parts)},
                                                           {"volumeText", std::move(volume)},
                                                           {"confidence", Text("high")}})
                .sentence);
    };
    EXPECT_EQ(removed(Text("{} parts", 3), Text("≈ {:.0f} mL, not calibrated", 120.0)),
              QStringLiteral("Der Tisch und was sonst abseits des Patienten liegt, ist weggelassen: 3 Teile, "
                             "≈ 120 mL, nicht kalibriert (Sicherheit: hoch)."));
    EXPECT_EQ(removed(Text("1 part"), Text("{:.0f} mL", 120.0)),
              QStringLiteral("Der Tisch und was sonst abseits des Patienten liegt, ist weggelassen: 1 Teil, "
                             "120 mL (Sicherheit: hoch)."));
    EXPECT_EQ(inWindowsLanguage(
                  Text::joined({Text("{} × {}", 512, 256), Text("{:.3g} × {:.3g} × {:.3g} mm", 1.0, 1.0, 2.5),
                                Text("not calibrated")},
                               " · ")),
              QStringLiteral("512 × 256 · 1 × 1 × 2,5 mm · nicht kalibriert"));
    EXPECT_EQ(inWindowsLanguage(dicom::message(dicom::key::kMissingModality,
                                               {{"count", std::int64_t(2)},
                                                {"total", std::int64_t(12)},
                                                {"modality", Text("{}, by their kind of object", "CT")}})
                                    .sentence),
              QStringLiteral("Bilder, die nicht sagen, mit was für einem Gerät sie aufgenommen wurden "
                             "(Modality): 2 von 12; sie gelten als CT, nach der Art ihrer Objekte."));
}

TEST_F(GermanTest, KeysAndTitlesOfWhatIsBuiltInHaveOne) {
    const std::set<QString> known = textsOfAllRooms();
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

TEST_F(GermanTest, MessagesWithKeysHaveOne) {
    const std::set<QString> known = textsOfAllRooms();
    const auto expectKnown = [&](std::string_view text) {
        EXPECT_TRUE(text.empty() || known.contains(QString::fromUtf8(text.data(), qsizetype(text.size()))))
            << text;
    };
    EXPECT_GT(dicom::catalogue().size(), 80u);
    for (const auto& entry : dicom::catalogue()) {
        expectKnown(entry.sentence);
        expectKnown(entry.action);
    }
    EXPECT_GE(segment::catalogue().size(), 6u);
    for (const auto& entry : segment::catalogue()) {
        expectKnown(entry.sentence);
        expectKnown(entry.action);
    }
}

TEST_F(GermanTest, WhatStandsInASentenceArrivesInTheOther) {
    EXPECT_EQ(inWindowsLanguage(dicom::message(dicom::key::kMissingSlices, {{"missing", std::int64_t(3)},
                                                                            {"total", std::int64_t(40)},
                                                                            {"spacingMm", 1.25}})
                                    .sentence),
              QStringLiteral("Fehlende Schichten: 3 von 40, die 1,250 mm auseinander liegen."));
    EXPECT_EQ(inWindowsLanguage(
                  dicom::message(dicom::key::kNotReconstructable, {{"reason", Text("their sizes differ")}})
                      .sentence),
              QStringLiteral("Die Bilder ergeben kein Volumen: ihre Größen unterscheiden sich."));
    EXPECT_EQ(
        inWindowsLanguage(Text::joined({Text("Nothing is left to remove on the {} side.", Text("left")),
                                        Text("Move the cross-hair into what is shown.")},
                                       " ")),
        QStringLiteral("Auf der Seite links ist nichts mehr zu entfernen. Bewegen Sie das Fadenkreuz in das "
                       "Gezeigte."));
    EXPECT_EQ(
        inWindowsLanguage(Text("Of {} volumes{} the {}one {}with the most voxels ({} x {} x {}).", 3,
                               Text(" in this series"), Text("original axial "), Text(), 512, 512, 90)),
        QStringLiteral("Von 3 Volumen in dieser Serie das originale axiale mit den meisten Voxeln (512 x "
                       "512 x 90)."));
    EXPECT_EQ(inWindowsLanguage(
                  Error{ErrorCode::usage, Text("The folder does not exist."), {}, Text("Check the path.")}),
              QStringLiteral("Den Ordner gibt es nicht. Prüfen Sie den Pfad."));
}

// Text of a file, or of a later version, is shown as it is.
TEST_F(GermanTest, WhatNobodyTranslatedStaysAsItIs) {
    for (const char* text :
         {"", " ", "Nobody knows this.", "%1", "Left", "High", "100 %", "\\d+ (", "Ünïcödé"})
        EXPECT_EQ(inWindowsLanguage(Text(text)), QString::fromUtf8(text));
    for (const char* text : {"left", "There is only one slice.", "1.5", "{} parts", "{"})
        EXPECT_EQ(inWindowsLanguage(Text::verbatim(text)), QString::fromUtf8(text)) << "words of others";
    const Text facts = Text::joined({Text::verbatim("CT"), Text("series {}: {}", 3, "High"),
                                     Text("no description"), Text::verbatim("axial, 1.5")},
                                    ", ");
    EXPECT_EQ(inWindowsLanguage(facts), QStringLiteral("CT, Serie 3: High, keine Beschreibung, axial, 1.5"));
    EXPECT_EQ(inWindowsLanguage(Text("Series {}: {}", 5, "Segmentation")),
              QStringLiteral("Serie 5: Segmentation"));
    const std::string huge(10'000, 'a');
    EXPECT_EQ(inWindowsLanguage(Text::verbatim(huge)), QString::fromStdString(huge));
    EXPECT_EQ(inWindowsLanguage(Text::of(huge, {})), QString::fromStdString(huge));
}

TEST_F(GermanTest, TitlesAndTheirCopies) {
    EXPECT_EQ(titleInWindowsLanguage("Cinematic bone"), QStringLiteral("Cinematic Knochen"));
    EXPECT_EQ(titleInWindowsLanguage("Cinematic bone (edited 2)"),
              QStringLiteral("Cinematic Knochen (bearbeitet 2)"));
    EXPECT_EQ(titleInWindowsLanguage("Cinematic bone (edited)"),
              QStringLiteral("Cinematic Knochen (bearbeitet)"));
    EXPECT_EQ(titleInWindowsLanguage("CT-Bone"), QStringLiteral("CT-Bone"));
    for (const char* typed :
         {"", "CT-Bone (edited x)", "CT-Bone (edited 2) b", " (edited)", "(edited", "left over"})
        EXPECT_EQ(titleInWindowsLanguage(typed), QString::fromUtf8(typed));
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
