// The clip panel alone, with hands on it, against a session.
#include "viewer/clip/clip_panel.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QLocale>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QTest>
#include <QWheelEvent>
#include <memory>
#include <optional>
#include <stdexcept>

#include "base/phantom.h"

namespace macula::viewer {
namespace {

class ClipPanelTest : public testing::Test {
  protected:
    void SetUp() override {
        qputenv("QT_QPA_PLATFORM", "offscreen");
        QLocale::setDefault(QLocale::c());
        application_.emplace(argc_, argv_);
        auto catalogue = scene::builtInCatalogue();
        ASSERT_TRUE(catalogue.ok()) << catalogue.error().message;
        session_.emplace(*std::move(catalogue));
        panel_.emplace(*session_);
        panel_->resize(420, 900);
        panel_->show();
        QObject::connect(&*session_, &StudyEditor::changed, &*session_, [this] { ++changes_; });
    }
    void TearDown() override {
        panel_.reset();
        session_.reset();
        application_.reset();
    }

    void openPhantom() {
        session_->show({.volume = std::make_shared<const Volume>(
                            phantom::make({.size = {24, 20, 16}, .spacingMm = {12, 12, 18}}))},
                       {});
        QCoreApplication::processEvents();  // the layout has its sizes
    }
    void putCrosshair(const glm::dvec3& mm) {
        session_->change(QStringLiteral("Cross-hair"),
                         [&](scene::StudyState& next) { next.slices.crosshairMm = mm; });
    }

    template <class Widget>
    Widget& find(const char* name) {
        auto* found = panel_->findChild<Widget*>(QLatin1String(name));
        if (found == nullptr) throw std::runtime_error(name);
        return *found;
    }
    QPushButton& button(const char* name) { return find<QPushButton>(name); }
    QSlider& slider(const char* name) { return find<QSlider>(name); }
    QDoubleSpinBox& number(const char* name) { return find<QDoubleSpinBox>(name); }
    void click(const char* name) { QTest::mouseClick(&button(name), Qt::LeftButton); }
    void type(QDoubleSpinBox& box, const QString& text) {
        box.selectAll();
        QTest::keyClicks(&box, text);
        QTest::keyClick(&box, Qt::Key_Return);
    }

    const Volume& volume() const { return *session_->study().volume; }
    Box all() const { return volume().worldBox(); }
    const scene::OptionalClip& clip() const { return session_->state().clip; }
    Box kept() const { return *scene::keptBox(clip(), volume()); }

    static QPoint handleOf(const QSlider& slider) {
        QStyleOptionSlider option;
        option.initFrom(&slider);
        option.orientation = Qt::Horizontal;
        option.state |= QStyle::State_Horizontal;
        option.subControls = QStyle::SC_All;
        option.minimum = slider.minimum();
        option.maximum = slider.maximum();
        option.singleStep = slider.singleStep();
        option.pageStep = slider.pageStep();
        option.sliderPosition = slider.sliderPosition();
        option.sliderValue = slider.value();
        return slider.style()
            ->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, &slider)
            .center();
    }

    int argc_ = 1;
    char name_[5] = "test";
    char* argv_[2] = {name_, nullptr};
    std::optional<QApplication> application_;
    std::optional<StudyEditor> session_;
    std::optional<ClipPanel> panel_;
    int changes_ = 0;
};

TEST_F(ClipPanelTest, WithoutAStudyNothingCanBeClippedAndAllSaysWhy) {
    int buttons = 0;
    for (const QAbstractButton* each : panel_->findChildren<QAbstractButton*>()) {
        EXPECT_FALSE(each->isEnabled()) << each->objectName().toStdString();
        EXPECT_TRUE(each->toolTip().contains(QLatin1String("study"))) << each->objectName().toStdString();
        ++buttons;
    }
    EXPECT_GE(buttons, 17);
    EXPECT_FALSE(find<QComboBox>("clip-list").isEnabled());
    EXPECT_FALSE(slider("clip-slider-left").isEnabled());
}

TEST_F(ClipPanelTest, EveryControlHasANameAndATipAndIsReachedByKeys) {
    openPhantom();
    QList<QWidget*> controls;
    for (QWidget* each : panel_->findChildren<QAbstractButton*>()) controls << each;
    for (QWidget* each : panel_->findChildren<QAbstractSpinBox*>()) controls << each;
    for (QWidget* each : panel_->findChildren<QSlider*>()) controls << each;
    for (QWidget* each : panel_->findChildren<QComboBox*>()) controls << each;
    EXPECT_GE(controls.size(), 34);
    for (const QWidget* each : controls) {
        const std::string name = each->objectName().toStdString();
        EXPECT_FALSE(each->accessibleName().isEmpty()) << name;
        EXPECT_FALSE(each->toolTip().isEmpty()) << name;
        EXPECT_TRUE(each->focusPolicy() & Qt::TabFocus) << name;
    }
}

TEST_F(ClipPanelTest, WithoutAClipTheFacesAreThoseOfTheVolume) {
    openPhantom();
    EXPECT_NEAR(number("clip-mm-right").value(), all().low.x, 0.06);
    EXPECT_NEAR(number("clip-mm-left").value(), all().high.x, 0.06);
    EXPECT_NEAR(number("clip-mm-anterior").value(), all().low.y, 0.06);
    EXPECT_NEAR(number("clip-mm-superior").value(), all().high.z, 0.06);
    EXPECT_EQ(slider("clip-slider-right").value(), 0);
    EXPECT_EQ(slider("clip-slider-left").value(), slider("clip-slider-left").maximum());
    EXPECT_EQ(find<QComboBox>("clip-list").currentIndex(), 0);
    EXPECT_FALSE(button("clip-none").isEnabled());
    EXPECT_EQ(changes_, 0) << "what is shown proposes nothing";
    EXPECT_FALSE(session_->canUndo());
}

// The side is a letter: that of LPS, in which the right is negative.
TEST_F(ClipPanelTest, ATypedFaceIsOnTheSideOfItsLetter) {
    openPhantom();
    type(number("clip-mm-right"), QStringLiteral("R 45"));
    ASSERT_TRUE(clip());
    EXPECT_NEAR(kept().low.x, -45.0, 1e-9);
    EXPECT_EQ(kept().high.x, all().high.x);
    EXPECT_TRUE(number("clip-mm-right").text().startsWith(QLatin1String("R 45")));
    type(number("clip-mm-left"), QStringLiteral("30 l"));
    EXPECT_NEAR(kept().high.x, 30.0, 1e-9);
    type(number("clip-mm-right"), QStringLiteral("L 10"));
    EXPECT_NEAR(kept().low.x, 10.0, 1e-9);
    EXPECT_EQ(session_->undoText(), QLatin1String("Clip"));
    session_->undo();
    EXPECT_NEAR(kept().low.x, -45.0, 1e-9);
    EXPECT_NEAR(number("clip-mm-right").value(), -45.0, 1e-9) << "what is undone is shown";
    session_->undo();
    session_->undo();
    EXPECT_FALSE(clip());
    EXPECT_FALSE(session_->canUndo());
}

TEST_F(ClipPanelTest, WhatIsNoCoordinateChangesNothing) {
    openPhantom();
    const QString before = number("clip-mm-left").text();
    for (const char* text : {"R -45", "nan", "inf", "A 20", "", "twelve"}) {
        type(number("clip-mm-left"), QLatin1String(text));
        EXPECT_FALSE(clip()) << text;
        EXPECT_EQ(number("clip-mm-left").text(), before) << text;
    }
}

TEST_F(ClipPanelTest, ADraggedSliderIsOneStep) {
    openPhantom();
    QSlider& superior = slider("clip-slider-superior");
    const QPoint handle = handleOf(superior);
    QTest::mousePress(&superior, Qt::LeftButton, {}, handle);
    for (int px = 5; px <= 60; px += 5) QTest::mouseMove(&superior, handle - QPoint(px, 0));
    EXPECT_GT(changes_, 1) << "it is seen while the hand moves";
    QTest::mouseRelease(&superior, Qt::LeftButton, {}, handle - QPoint(60, 0));
    ASSERT_TRUE(clip());
    EXPECT_LT(kept().high.z, all().high.z - 1.0);
    EXPECT_EQ(kept().low.z, all().low.z);
    EXPECT_NEAR(number("clip-mm-superior").value(), kept().high.z, 0.06);

    QSlider& left = slider("clip-slider-left");
    const QPoint other = handleOf(left);
    QTest::mousePress(&left, Qt::LeftButton, {}, other);
    for (int px = 5; px <= 60; px += 5) QTest::mouseMove(&left, other - QPoint(px, 0));
    QTest::mouseRelease(&left, Qt::LeftButton, {}, other - QPoint(60, 0));
    EXPECT_LT(kept().high.x, all().high.x - 1.0);
    session_->undo();
    EXPECT_EQ(kept().high.x, all().high.x);
    EXPECT_LT(kept().high.z, all().high.z - 1.0);
    session_->undo();
    EXPECT_FALSE(clip());
    EXPECT_FALSE(session_->canUndo());
    EXPECT_EQ(superior.value(), superior.maximum());
}

TEST_F(ClipPanelTest, AFaceIsPulledNoFurtherThanTheOther) {
    openPhantom();
    type(number("clip-mm-right"), QStringLiteral("0"));
    QSlider& left = slider("clip-slider-left");
    const QPoint handle = handleOf(left);
    QTest::mousePress(&left, Qt::LeftButton, {}, handle);
    QTest::mouseMove(&left, handle - QPoint(1000, 0));
    QTest::mouseRelease(&left, Qt::LeftButton, {}, handle - QPoint(1000, 0));
    EXPECT_NEAR(kept().low.x, 0.0, 1e-9);
    EXPECT_NEAR(kept().high.x, scene::voxelExtentMm(volume()).x, 1e-6);
    EXPECT_GT(left.value(), left.maximum() / 3) << "its slider stands where it is";
}

TEST_F(ClipPanelTest, EachKeyOnASliderIsAStep) {
    openPhantom();
    QSlider& left = slider("clip-slider-left");
    const double stepMm = (all().high.x - all().low.x) / left.maximum();
    QTest::keyClick(&left, Qt::Key_Left);
    EXPECT_NEAR(kept().high.x, all().high.x - stepMm, 1e-6);
    QTest::keyClick(&left, Qt::Key_Left);
    EXPECT_NEAR(kept().high.x, all().high.x - 2.0 * stepMm, 1e-6);
    session_->undo();
    EXPECT_NEAR(kept().high.x, all().high.x - stepMm, 1e-6);
    QTest::keyClick(&left, Qt::Key_Right);
    EXPECT_FALSE(clip()) << "at its end a face is open";
}

TEST_F(ClipPanelTest, TheWheelPassesOverWhatHasNoFocus) {
    openPhantom();
    for (QWidget* each : {static_cast<QWidget*>(&slider("clip-slider-left")),
                          static_cast<QWidget*>(&number("clip-mm-left"))}) {
        each->clearFocus();
        const QPointF at(each->rect().center());
        QWheelEvent wheel(at, each->mapToGlobal(at), {}, QPoint(0, -120), Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(each, &wheel);
        EXPECT_FALSE(clip());
    }
}

TEST_F(ClipPanelTest, AFaceIsOpenedAgain) {
    openPhantom();
    type(number("clip-mm-left"), QStringLiteral("30"));
    type(number("clip-mm-superior"), QStringLiteral("S 20"));
    QTest::mouseClick(&find<QToolButton>("clip-open-left"), Qt::LeftButton);
    EXPECT_EQ(kept().high.x, all().high.x);
    EXPECT_NEAR(kept().high.z, 20.0, 1e-9);
    QTest::mouseClick(&find<QToolButton>("clip-open-superior"), Qt::LeftButton);
    EXPECT_FALSE(clip());
}

TEST_F(ClipPanelTest, CutsAreMadeAtTheCrossHair) {
    openPhantom();
    const glm::dvec3 at = all().centre() + glm::dvec3(20.0, -30.0, 10.0);
    putCrosshair(at);
    // They say what goes.
    EXPECT_EQ(button("clip-cut-left").text(), QStringLiteral("Remove left side"));
    EXPECT_EQ(button("clip-cut-superior").text(), QStringLiteral("Remove superior side"));
    click("clip-cut-anterior");
    EXPECT_NEAR(kept().low.y, at.y, 1e-9);
    EXPECT_EQ(kept().high.y, all().high.y);
    EXPECT_FALSE(button("clip-cut-anterior").isEnabled()) << "nothing is left there";
    EXPECT_FALSE(button("clip-cut-posterior").isEnabled()) << "nothing would be left";
    EXPECT_NE(button("clip-cut-anterior").toolTip(), button("clip-cut-posterior").toolTip());
    click("clip-cut-left");
    EXPECT_NEAR(kept().high.x, at.x, 1e-9);
    click("clip-cut-inferior");
    EXPECT_NEAR(kept().low.z, at.z, 1e-9);
    putCrosshair(all().centre());
    EXPECT_TRUE(button("clip-cut-posterior").isEnabled()) << "the cross-hair is where something is shown";
    EXPECT_NEAR(number("clip-mm-inferior").value(), at.z, 0.06);
    click("clip-none");
    EXPECT_FALSE(clip());
    EXPECT_FALSE(button("clip-none").isEnabled());
    session_->undo();
    EXPECT_NEAR(kept().low.z, at.z, 1e-9);
}

TEST_F(ClipPanelTest, TheCrossHairIsToldByItsSides) {
    openPhantom();
    putCrosshair({-12.0, 3.0, -4.5});
    EXPECT_EQ(find<QLabel>("clip-crosshair").text(), QLatin1String("R 12.0, P 3.0, I 4.5 mm"));
    putCrosshair({12.0, -3.0, 0.0});
    EXPECT_EQ(find<QLabel>("clip-crosshair").text(), QLatin1String("L 12.0, A 3.0, 0.0 mm"));
}

TEST_F(ClipPanelTest, SlabBallAndCornerAreMadeAtTheCrossHair) {
    openPhantom();
    const glm::dvec3 at = all().centre() + glm::dvec3(10.0, 10.0, 10.0);
    putCrosshair(at);
    find<QComboBox>("clip-orientation").setCurrentIndex(1);  // coronal
    type(number("clip-thickness"), QStringLiteral("60"));
    click("clip-slab");
    EXPECT_NEAR(kept().low.y, at.y - 30.0, 1e-9);
    EXPECT_NEAR(kept().high.y, at.y + 30.0, 1e-9);
    type(number("clip-radius"), QStringLiteral("25"));
    click("clip-ball");
    ASSERT_TRUE(clip()->clip.ball);
    const Clip withBall = clip()->clip;
    EXPECT_EQ(withBall.ofBall, Keep::outside);
    EXPECT_FALSE(shows(clipFor(*clip(), volume()), at + glm::dvec3(24.0, 0.0, 0.0)));
    EXPECT_TRUE(shows(clipFor(*clip(), volume()), at + glm::dvec3(26.0, 0.0, 0.0)));
    EXPECT_TRUE(find<QLabel>("clip-besides").text().contains(QLatin1String("ball")));
    EXPECT_FALSE(button("clip-inside-out").isEnabled()) << "it has two parts";
    click("clip-none");
    click("clip-corner");
    ASSERT_TRUE(clip()->clip.cut);
    EXPECT_EQ(clip()->clip.cut->towards, glm::dvec3(1.0, -1.0, 1.0)) << "left, anterior, superior";
    EXPECT_TRUE(find<QComboBox>("clip-corners").currentText().startsWith(QLatin1String("Left anterior")));
    click("clip-inside-out");
    EXPECT_NEAR(kept().low.x, at.x, 1e-9);
    EXPECT_NEAR(kept().high.y, at.y, 1e-9);
    EXPECT_NEAR(kept().low.z, at.z, 1e-9);
}

TEST_F(ClipPanelTest, TheListGoesToAClipAndBackToOnesOwn) {
    openPhantom();
    auto& list = find<QComboBox>("clip-list");
    QTest::keyClick(&list, Qt::Key_Down);
    ASSERT_TRUE(clip());
    EXPECT_EQ(*clip(), *session_->catalogue().clips.front());
    EXPECT_EQ(list.currentIndex(), 1);
    QTest::keyClick(&list, Qt::Key_End);
    EXPECT_EQ(list.currentIndex(), int(session_->catalogue().clips.size())) << "there is no own one yet";
    QTest::keyClick(&list, Qt::Key_Home);
    EXPECT_FALSE(clip());

    type(number("clip-mm-left"), QStringLiteral("30"));
    const scene::OptionalClip own = clip();
    ASSERT_TRUE(own);
    EXPECT_EQ(list.currentIndex(), list.count() - 1);
    QTest::keyClick(&list, Qt::Key_Home);
    EXPECT_FALSE(clip());
    QTest::keyClick(&list, Qt::Key_End);
    EXPECT_EQ(clip(), own);
}

TEST_F(ClipPanelTest, WhatAnotherPanelChoseIsShownAndNotAnswered) {
    openPhantom();
    for (const auto& listed : session_->catalogue().clips) {
        changes_ = 0;
        session_->change(QStringLiteral("Clip"), [&](scene::StudyState& next) { next.clip = *listed; });
        EXPECT_EQ(changes_, 1) << listed->name;
        EXPECT_EQ(*clip(), *listed);
        EXPECT_NEAR(number("clip-mm-left").value(), kept().high.x, 0.06) << listed->name;
        EXPECT_NEAR(number("clip-mm-inferior").value(), kept().low.z, 0.06) << listed->name;
        EXPECT_EQ(find<QComboBox>("clip-list").currentText().toStdString(), listed->title);
    }
}

TEST_F(ClipPanelTest, OfAClipThatLeavesNothingOneCanBeginAgain) {
    openPhantom();
    session_->change(QStringLiteral("Clip"), [](scene::StudyState& next) {
        ClipPreset nothing{.name = "nothing", .title = "Nothing", .clip = {}, .planesAt = {}};
        nothing.clip.planes.push_back({{1.0, 0.0, 0.0}, 0.0});
        nothing.planesAt.emplace_back(5.0, 0.5, 0.5);
        next.clip = nothing;
    });
    EXPECT_FALSE(slider("clip-slider-left").isEnabled());
    EXPECT_TRUE(slider("clip-slider-left").toolTip().contains(QLatin1String("nothing")));
    EXPECT_FALSE(find<QLabel>("clip-besides").text().isEmpty());
    click("clip-none");
    EXPECT_FALSE(clip());
    EXPECT_TRUE(slider("clip-slider-left").isEnabled());
}

TEST_F(ClipPanelTest, AnotherStudyHasItsOwnFaces) {
    openPhantom();
    type(number("clip-mm-left"), QStringLiteral("30"));
    auto small = Volume::create({.size = glm::ivec3(1)}, std::vector<std::uint16_t>(1, 7));
    ASSERT_TRUE(small.ok());
    session_->show({.volume = std::make_shared<const Volume>(*std::move(small))}, {});
    EXPECT_NEAR(number("clip-mm-left").value(), 0.5, 1e-9);
    EXPECT_NEAR(number("clip-mm-right").value(), -0.5, 1e-9);
    EXPECT_EQ(find<QComboBox>("clip-list").currentIndex(), 0);
    for (const scene::Face side : scene::kFaces) {
        const std::string name = "clip-cut-" + std::string(nameOf(side));
        EXPECT_FALSE(button(name.c_str()).isEnabled()) << "one voxel is not cut";
    }
    QTest::keyClick(&slider("clip-slider-left"), Qt::Key_Left);
    EXPECT_FALSE(clip());
    EXPECT_EQ(slider("clip-slider-left").value(), slider("clip-slider-left").maximum());
}

TEST(PatientText, IsReadBack) {
    const QLocale english(QLocale::English);
    for (int axis = 0; axis < 3; ++axis) {
        for (const double mm : {-1234.5, -0.1, 0.0, 0.3, 45.0}) {
            const QString text = patientText(axis, mm, 1, english);
            EXPECT_FALSE(text.contains(QLatin1Char('-'))) << text.toStdString();
            EXPECT_EQ(patientMm(axis, text, english), mm) << text.toStdString();
            EXPECT_EQ(patientMm(axis, text + QStringLiteral(" mm"), english), mm) << text.toStdString();
        }
    }
    EXPECT_EQ(patientText(0, -45.0, 1, english), QLatin1String("R 45.0"));
    EXPECT_EQ(patientText(1, -0.01, 1, english), QLatin1String("0.0"));
    EXPECT_EQ(patientMm(2, QStringLiteral("-7 mm"), english), -7.0);
    for (const char* text : {"", "R", "L 5", "S -5", "S 5 S", "inf", "nan", "1e999"})
        EXPECT_FALSE(patientMm(2, QLatin1String(text), english)) << text;
}

}  // namespace
}  // namespace macula::viewer
