// What the window says of the study that is open, and of nobody else.
#include "viewer/status/study_texts.h"

#include <gtest/gtest.h>

#include "viewer/offscreen.h"

namespace macula::viewer {
namespace {

class StudyTextsTest : public test::OffscreenTest {
  protected:
    static study::OpenedStudy ofDoe() {
        study::OpenedStudy study = smallStudy();
        study.identity = {.patientName = "DOE^JOHN",
                          .patientId = "4711",
                          .studyDate = "20200304",
                          .studyDescription = "Chest",
                          .series = Text("CT, series 3: Lung of Doe")};
        study.description = Text("Lung of Doe");
        study.whyThisSeries = Text("The volume that was chosen.");
        study.volumeTitles = {Text("DOE, 1"), Text("DOE, 2")};
        return study;
    }
};

TEST_F(StudyTextsTest, NameTheStudyThatIsOpen) {
    const StudyTexts texts = textsOf(ofDoe(), true);
    EXPECT_TRUE(texts.title.startsWith(QStringLiteral("DOE, JOHN \u00b7 4711 \u00b7 2020-03-04, Chest")));
    EXPECT_TRUE(texts.title.endsWith(QStringLiteral(" \u2013 Macula")));
    EXPECT_EQ(texts.voxels, QStringLiteral("CT 8×8×8, 1.00×1.00×1.00 mm"));
    EXPECT_EQ(texts.description, QStringLiteral("Lung of Doe"));
    EXPECT_EQ(texts.whyThisOne, QStringLiteral("The volume that was chosen."));
    EXPECT_TRUE(texts.listsVolumes);
    EXPECT_EQ(textsOf({}, true), StudyTexts{.title = QStringLiteral("Macula")});
}

TEST_F(StudyTextsTest, WithoutNamesSayNothingThatTheFilesSayOfAPerson) {
    const StudyTexts texts = textsOf(ofDoe(), false);
    EXPECT_EQ(texts.title, QStringLiteral("Macula"));
    EXPECT_EQ(texts.description, QString());
    EXPECT_FALSE(texts.listsVolumes) << "its titles name patients";
    EXPECT_FALSE(texts.voxels.isEmpty());
}

// Qt takes it for a mark of what is not saved.
TEST_F(StudyTextsTest, AStarInAName) {
    study::OpenedStudy study = ofDoe();
    study.identity.patientName = "[*]DOE";
    EXPECT_TRUE(textsOf(study, true).title.startsWith(QStringLiteral("[*][*]DOE")));
}

TEST_F(StudyTextsTest, NotesSayEachSentenceOnce) {
    const QStringList notes{QStringLiteral("A gap. It is filled."),
                            QStringLiteral("Another."),
                            QStringLiteral("A gap."),
                            QStringLiteral("A gap. It is filled."),
                            QStringLiteral("Second volume: Another."),
                            QString()};
    EXPECT_EQ(withoutRepeats(notes),
              (QStringList{QStringLiteral("A gap. It is filled."), QStringLiteral("Another."),
                           QStringLiteral("Second volume: Another.")}));
}

TEST_F(StudyTextsTest, EachLayoutWithout3dSaysWhatIsShownInstead) {
    QStringList told;
    for (const scene::Layout layout : scene::kLayouts) {
        const QString text = withoutVolumeText(layout);
        const bool has3d = layout == scene::Layout::volume || layout == scene::Layout::fourPanes;
        EXPECT_EQ(text.isEmpty(), has3d);
        if (!has3d) told << text;
    }
    EXPECT_EQ(told.removeDuplicates(), 0);
}

}  // namespace
}  // namespace macula::viewer
