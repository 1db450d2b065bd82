// A dose over the slices of a study: its place, lines, legend, and what the pointer reads.
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include "viewer/dose/dose_panel.h"
#include "viewer/dose/isodose_table.h"
#include "viewer/second_fixture.h"
#include "viewer/slices/dose_over.h"

namespace macula::viewer {
namespace {

constexpr const char* kFrame = "2.25.1";

// 2 Gy for each mm from the left edge, on points of 4 mm: at x it is 2 * (x + 40), at most 160.
study::OpenedStudy doseStudy(std::string frame = kFrame, const glm::ivec3& size = {21, 21, 15}) {
    std::vector<float> values;
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) values.push_back(8.0f * float(i));
    study::OpenedStudy study = studyOf(nullptr, "dose", "20240301");
    const auto volume = std::make_shared<const Volume>(
        *Volume::createFloat({.size = size,
                              .worldFromVoxel = affine({4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {-40, -40, -28}),
                              .unit = Unit::other,
                              .modality = "RTDOSE",
                              .unitName = "Gy"},
                             values));
    study.volume = in16Bits(volume);
    study.inFloats = volume;
    study.frameOfReferenceUid = std::move(frame);
    study.dose = dicom::DoseFacts{.units = "GY",
                                  .type = "PHYSICAL",
                                  .summation = "PLAN",
                                  .plansNamed = 1,
                                  .isPlanHere = true,
                                  .prescriptionsGy = {100.0},
                                  .fractions = 50};
    return study;
}

class DoseOverTest : public SecondVolumeTest {
  protected:
    void SetUp() override {
        SecondVolumeTest::SetUp();
        current_.frameOfReferenceUid = kFrame;
        session_->show(current_, {});
        ASSERT_TRUE(settled());
    }
    void openDose(std::string frame = kFrame) {
        secondVolume_->offer(doseStudy(std::move(frame)));
        ASSERT_TRUE(settled());
    }
    static int redLinesIn(const QImage& picture) {
        int count = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x) {
                const QRgb at = picture.pixel(x, y);
                count += qRed(at) > 200 && qGreen(at) < 110 && qBlue(at) < 110 ? 1 : 0;
            }
        return count;
    }
};

TEST_F(DoseOverTest, ADoseOfTheSameFrameLiesOverTheStudyAtOnce) {
    openDose();
    ASSERT_NE(secondVolume_->state(), nullptr);
    EXPECT_EQ(secondVolume_->state()->view, scene::SecondVolumePlace::over);
    EXPECT_EQ(secondVolume_->state()->link, scene::SecondVolumeLink::sameFrame);
    EXPECT_FALSE(secondVolume_->isRegistering());
    ASSERT_TRUE(secondVolume_->state()->isodoses);
    EXPECT_EQ(*secondVolume_->state()->isodoses, scene::usualIsodoses());
    const QString notes = study().notes().join(QLatin1Char('|'));
    EXPECT_TRUE(notes.contains("nothing is registered")) << notes.toStdString();
    EXPECT_TRUE(notes.contains("Dose of a whole plan, 100 Gy prescribed in 50 fractions"))
        << notes.toStdString();
    session_->undo();
    EXPECT_FALSE(state().secondVolume) << "one step";
}

TEST_F(DoseOverTest, ADoseOfAnotherFrameIsNeitherLaidOverNorRegistered) {
    openDose("2.25.2");
    ASSERT_NE(secondVolume_->state(), nullptr);
    EXPECT_EQ(secondVolume_->state()->view, scene::SecondVolumePlace::beside);
    EXPECT_FALSE(secondVolume_->state()->isLinked());
    EXPECT_FALSE(secondVolume_->isRegistering());
    secondVolume_->registerNow();
    EXPECT_FALSE(secondVolume_->isRegistering()) << "a dose has no anatomy";
}

TEST_F(DoseOverTest, ThePointerReadsTheDoseAndItsPercentage) {
    openDose();
    const glm::dvec3 mm(-10.0, 3.0, 0.0);
    moveTo(study(), placeOf(study(), mm));
    EXPECT_TRUE(study().probedText().contains("HU"));
    const QString read = study().overProbedText();
    const double at = read.section(QLatin1Char(' '), 1, 1).toDouble();
    EXPECT_NEAR(at, 60.0, 2.0) << read.toStdString();
    EXPECT_TRUE(read.contains("Gy, ")) << read.toStdString();
    EXPECT_TRUE(read.endsWith("% of 100 Gy prescribed")) << read.toStdString();
    DoseOver over{.reference = study::DoseReference{.value = 160.0, .of = study::DoseReference::Of::maximum}};
    const auto dose = doseStudy().inFloats;
    EXPECT_EQ(doseText(over, dose, {-9.0, 3.0, 0.5}), "Dose: 62 Gy, 38.8 % of 160 Gy, the highest dose")
        << "between the points of the grid";
    EXPECT_EQ(doseText(over, dose, {-90.0, 3.0, 0.5}), "Dose: none was computed here");
    EXPECT_EQ(doseText({}, dose, {-9.0, 3.0, 0.5}), "Dose: 62 Gy");
}

TEST_F(DoseOverTest, AnIsodoseIsALineAtItsDose) {
    openDose();
    session_->change("One", [](scene::StudyState& next) {
        next.secondVolume->opacity = 0.0;
        next.secondVolume->isodoses->levels = {{.level = 60.0, .rgb = {255, 0, 0}}};
    });
    ASSERT_TRUE(settled());
    // 60 Gy lie at x = -10, away from the line of the cross-hair.
    const QImage picture = pictureOf(study());
    const QPoint place = placeOf(study(), {-10.0, -5.0, 0.0});
    bool isRed = false;
    for (int x = place.x() - 2; x <= place.x() + 2; ++x)
        isRed = isRed || qRed(picture.pixel(x, place.y())) > 180;
    EXPECT_TRUE(isRed);
    session_->change("At 15 mm", [](scene::StudyState& next) {
        next.secondVolume->isodoses->levels = {{.level = 110.0, .rgb = {255, 0, 0}}};
    });
    ASSERT_TRUE(settled());
    const QImage moved = pictureOf(study());
    const QPoint at = placeOf(study(), {15.0, -10.0, 0.0});
    int reddest = at.x() - 6;
    for (int x = at.x() - 6; x <= at.x() + 6; ++x)
        if (qRed(moved.pixel(x, at.y())) - qGreen(moved.pixel(x, at.y())) >
            qRed(moved.pixel(reddest, at.y())) - qGreen(moved.pixel(reddest, at.y())))
            reddest = x;
    EXPECT_NEAR(reddest, at.x(), 1) << "110 Gy lie at 15 mm";
    const int lines = redLinesIn(moved);
    EXPECT_GT(lines, 50);
    session_->change("None", [](scene::StudyState& next) { next.secondVolume->isodoses->areShown = false; });
    ASSERT_TRUE(settled());
    EXPECT_LT(redLinesIn(pictureOf(study())), lines / 2) << "the cross-hair may be red, too";
}

// The grid of points ends at x = 0. Half a voxel farther nobody computed a dose: the pointer reads none, and
// so there is no colour and no line.
TEST_F(DoseOverTest, WhereNoDoseWasComputedThereIsNoColour) {
    secondVolume_->offer(doseStudy(kFrame, {11, 21, 15}));
    ASSERT_TRUE(settled());
    session_->change("Opaque", [](scene::StudyState& next) {
        next.secondVolume->opacity = 1.0;
        next.secondVolume->isodoses->areShown = false;
    });
    ASSERT_TRUE(settled());
    const auto brightness = [&](double x) {
        const QColor colour = QColor::fromRgb(colourAt(study(), {x, -6.0, 0.0}));
        return colour.red() + colour.green() + colour.blue();
    };
    EXPECT_GT(brightness(-3.0), 60);
    EXPECT_LT(brightness(1.5), 10);
    moveTo(study(), placeOf(study(), {1.5, -6.0, 0.0}));
    EXPECT_TRUE(study().overProbedText().contains("none was computed here"));
}

TEST_F(DoseOverTest, TheLegendNamesEachLine) {
    DoseOver over{.reference =
                      study::DoseReference{.value = 60.0, .of = study::DoseReference::Of::prescription}};
    over.lines = scene::doseLines(scene::usualIsodoses(), over.reference);
    const std::vector<LegendLine> legend = legendOf(over, QStringLiteral("Gy"));
    ASSERT_EQ(legend.size(), 8u);
    EXPECT_EQ(legend[0].text, "100 % = 60 Gy prescribed");
    EXPECT_EQ(legend[1].text, "107 % · 64.2 Gy");
    EXPECT_EQ(legend[3].text, "95 % · 57 Gy");
    EXPECT_EQ(legend[3].ink, QColor(255, 150, 0));
    EXPECT_TRUE(legendOf({}, QStringLiteral("Gy")).empty());
}

TEST_F(DoseOverTest, ThePanelEditsTheLines) {
    openDose();
    DosePanel panel(*session_);
    const auto show = [&] {
        panel.setShown({.isodoses = &*state().secondVolume->isodoses,
                        .reference = scene::doseReference(secondVolume_->second()->study,
                                                          state().secondVolume->isodoses),
                        .unit = QStringLiteral("Gy")});
    };
    show();
    auto* table = panel.findChild<IsodoseTable*>();
    ASSERT_NE(table, nullptr);
    ASSERT_EQ(table->rowCount(), 7);
    EXPECT_EQ(table->item(2, 1)->text(), "95");
    EXPECT_EQ(table->item(2, 2)->text(), "95") << "of 100 Gy";
    table->item(2, 1)->setText(QStringLiteral("90"));
    EXPECT_EQ(state().secondVolume->isodoses->levels[2].level, 90.0);
    show();
    for (const char* bad : {"-3", "nan", "lots", "1e99", ""}) {
        table->item(2, 1)->setText(QString::fromLatin1(bad));
        EXPECT_EQ(state().secondVolume->isodoses->levels[2].level, 90.0) << bad;
        EXPECT_EQ(table->item(2, 1)->text(), "90") << bad;
    }
    panel.findChild<QPushButton*>(QStringLiteral("isodoses-add"))->click();
    EXPECT_EQ(state().secondVolume->isodoses->levels.size(), 8u);
    show();
    table->setCurrentCell(0, 1);
    panel.findChild<QPushButton*>(QStringLiteral("isodoses-remove"))->click();
    EXPECT_EQ(state().secondVolume->isodoses->levels.front().level, 100.0);
    IsodoseEdits edits(*session_);
    edits.setInPercent(false, 50.0);
    EXPECT_EQ(state().secondVolume->isodoses->levels.front().level, 50.0) << "the same dose, in Gy";
    session_->undo();
    EXPECT_EQ(state().secondVolume->isodoses->levels.front().level, 100.0);
    edits.setReference(80.0);
    EXPECT_EQ(scene::doseReference(secondVolume_->second()->study, state().secondVolume->isodoses)->value,
              80.0);
}

}  // namespace
}  // namespace macula::viewer
