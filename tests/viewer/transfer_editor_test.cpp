// Mouse and keys on the editor of transfer functions, against a session that draws nothing.
#include <gtest/gtest.h>

#include <QApplication>
#include <QColorDialog>
#include <QDoubleSpinBox>
#include <QImage>
#include <QMouseEvent>
#include <QPushButton>
#include <QTest>
#include <QWheelEvent>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "base/phantom.h"
#include "pipeline/volume/volume_fit.h"
#include "viewer/transfer/transfer_function_editor.h"
#include "viewer/wait_until.h"

namespace macula::viewer {
namespace {

using Curve = PointId::Curve;

constexpr PointId kOpacity2{Curve::opacity, 2};
constexpr PointId kColour2{Curve::colour, 2};

class TransferEditorTest : public testing::Test {
  protected:
    void SetUp() override {
        qputenv("QT_QPA_PLATFORM", "offscreen");
        application_.emplace(argc_, argv_);
        auto catalogue = scene::builtInCatalogue();
        ASSERT_TRUE(catalogue.ok());
        session_.emplace(*std::move(catalogue));
        editor_.emplace(*session_);
        editor_->resize(760, 420);
        editor_->show();
    }
    void TearDown() override {
        editor_.reset();
        session_.reset();
        application_.reset();
        qunsetenv("QT_QPA_PLATFORM");
    }

    std::shared_ptr<const TransferFunction> preset(const char* name) const {
        return *scene::findPreset(session_->catalogue(), name);
    }
    void show(Volume volume, std::shared_ptr<const TransferFunction> preset) {
        scene::StudyState state;
        state.preset = std::move(preset);
        session_->show({.volume = std::make_shared<const Volume>(std::move(volume))}, state);
        waitUntilCounted();
    }
    void showPhantom(const char* name = "ct-bone") {
        show(phantom::make({.size = {32, 28, 20}}), preset(name));
    }
    void waitUntilCounted() {
        ASSERT_TRUE(waitUntil([&] { return !editor_->isCounting(); }));
    }

    TransferCurve& curve() { return editor_->curve(); }
    const TransferFunction& now() const { return *session_->state().preset; }
    QPoint placeOf(const PointId& point) { return curve().placeOf(point).toPoint(); }
    double unitsPerPx() { return curve().axis().unitsPerPx(); }
    // Where no point is: above the curve, between two points of CT-Bone.
    QPoint emptyPlace() {
        const QPointF a = curve().placeOf(kOpacity2);
        const QPointF b = curve().placeOf({Curve::opacity, 3});
        return QPoint(int(0.5 * (a.x() + b.x())), int(curve().plotRect().top()) + 20);
    }
    double valueAt(QPoint at) { return curve().axis().valueAt(at.x() - curve().plotRect().left()); }
    template <class Child>
    Child& child(const char* name) {
        return *editor_->findChild<Child*>(QString::fromLatin1(name));
    }

    void drag(QPoint from, QPoint by, Qt::MouseButton button = Qt::LeftButton,
              Qt::KeyboardModifiers modifiers = {}) {
        QTest::mousePress(&curve(), button, modifiers, from);
        for (int step = 1; step <= 5; ++step) moveTo(from + by * step / 5, button, modifiers);
        QTest::mouseRelease(&curve(), button, modifiers, from + by);
    }
    // QTest::mouseMove has no modifiers.
    void moveTo(QPoint to, Qt::MouseButton held, Qt::KeyboardModifiers modifiers) {
        QMouseEvent event(QEvent::MouseMove, to, curve().mapToGlobal(to), Qt::NoButton, held, modifiers);
        QCoreApplication::sendEvent(&curve(), &event);
    }
    void doubleClick(QPoint at) {
        QTest::mouseDClick(&curve(), Qt::LeftButton, {}, at);
        QTest::mouseRelease(&curve(), Qt::LeftButton, {}, at);
    }
    void wheel(QPoint at, int angle) {
        QWheelEvent event(at, curve().mapToGlobal(at), {}, QPoint(0, angle), Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&curve(), &event);
    }
    // One undo leads back to what there was, and there was nothing before that.
    void expectOneStepBackTo(const std::shared_ptr<const TransferFunction>& before) {
        ASSERT_TRUE(session_->canUndo());
        session_->undo();
        EXPECT_EQ(session_->state().preset, before);
        EXPECT_FALSE(session_->canUndo());
    }

    int argc_ = 1;
    char name_[5] = "test";
    char* argv_[2] = {name_, nullptr};
    std::optional<QApplication> application_;
    std::optional<StudyEditor> session_;
    std::optional<TransferFunctionEditor> editor_;
};

TEST_F(TransferEditorTest, WithoutAStudyItIsDisabledAndSaysWhy) {
    EXPECT_FALSE(curve().isEnabled());
    EXPECT_FALSE(child<QPushButton>("transfer-reset").isEnabled());
    EXPECT_FALSE(child<QPushButton>("transfer-save").isEnabled());
    EXPECT_TRUE(editor_->line().contains("Open a study")) << editor_->line().toStdString();
    showPhantom();
    EXPECT_TRUE(curve().isEnabled());
    EXPECT_TRUE(editor_->line().contains("CT-Bone, as it was chosen")) << editor_->line().toStdString();
}

TEST_F(TransferEditorTest, LargerValuesAreToTheRight) {
    showPhantom();
    for (std::size_t i = 0; i + 1 < now().opacity.size(); ++i)
        EXPECT_LT(placeOf({Curve::opacity, i}).x(), placeOf({Curve::opacity, i + 1}).x());
    EXPECT_LT(placeOf(kOpacity2).y(), placeOf({Curve::opacity, 0}).y());
    const QImage image = curve().grab().toImage();
    ASSERT_EQ(image.size(), curve().size());
    for (const double part : {0.3, 0.7, 0.9}) {
        const QRectF strip = curve().stripRect();
        const QPoint at(int(strip.left() + part * strip.width()), int(strip.top()) + 2);
        const glm::dvec3 wanted = colourAt(now(), valueAt(at));
        const QColor is = image.pixelColor(at);
        EXPECT_NEAR(is.redF(), wanted.r, 0.02);
        EXPECT_NEAR(is.greenF(), wanted.g, 0.02);
        EXPECT_NEAR(is.blueF(), wanted.b, 0.02);
    }
}

TEST_F(TransferEditorTest, ADragOfAPointIsOneStepAndMakesACopy) {
    showPhantom();
    const auto before = session_->state().preset;
    const OpacityPoint from = before->opacity[2];
    drag(placeOf(kOpacity2), QPoint(20, 15));
    EXPECT_EQ(now().name, "ct-bone-edited");
    EXPECT_EQ(now().title, "CT-Bone (edited)");
    EXPECT_NEAR(now().opacity[2].value, from.value + 20.0 * unitsPerPx(), 1e-6);
    EXPECT_NEAR(now().opacity[2].opacity, from.opacity - 15.0 / curve().plotRect().height(), 1e-9);
    EXPECT_EQ(now().opacity[1], before->opacity[1]);
    EXPECT_EQ(now().colour, before->colour);
    EXPECT_EQ(curve().selected(), kOpacity2);
    EXPECT_TRUE(editor_->line().contains("CT-Bone (edited): your copy of CT-Bone"));
    EXPECT_EQ(preset("ct-bone"), before) << "what is built in is as it was";
    EXPECT_EQ(before->opacity[2], from);
    EXPECT_EQ(session_->undoText(), "Transfer function");

    drag(placeOf(kOpacity2), QPoint(-5, 0));
    EXPECT_EQ(now().name, "ct-bone-edited") << "the copy is edited further";
    session_->undo();
    expectOneStepBackTo(before);
    EXPECT_TRUE(editor_->line().contains("as it was chosen"));
    session_->redo();
    EXPECT_EQ(now().name, "ct-bone-edited");
}

TEST_F(TransferEditorTest, AClickThatDoesNotMoveChangesNothing) {
    showPhantom();
    QTest::mouseClick(&curve(), Qt::LeftButton, {}, placeOf(kOpacity2) + QPoint(4, 4));
    EXPECT_EQ(curve().selected(), kOpacity2);
    QTest::mouseClick(&curve(), Qt::LeftButton, {}, placeOf(kOpacity2) + QPoint(-9, 9));
    EXPECT_FALSE(curve().selected()) << "farther than 8 pixels";
    EXPECT_FALSE(session_->canUndo());
}

TEST_F(TransferEditorTest, DoubleClickAddsAndDeleteRemoves) {
    showPhantom();
    const auto before = session_->state().preset;
    const QPoint at = emptyPlace();
    doubleClick(at);
    ASSERT_EQ(now().opacity.size(), before->opacity.size() + 1);
    EXPECT_EQ(curve().selected(), (PointId{Curve::opacity, 3}));
    EXPECT_NEAR(now().opacity[3].value, valueAt(at), 1e-6);
    EXPECT_NEAR(now().opacity[3].opacity,
                (curve().plotRect().bottom() - at.y()) / curve().plotRect().height(), 1e-9);
    QTest::keyClick(&curve(), Qt::Key_Delete);
    EXPECT_EQ(now().opacity, before->opacity);
    session_->undo();
    expectOneStepBackTo(before);

    // On the colours it adds one of them, which changes no picture.
    const QPoint below(at.x(), int(curve().stripRect().center().y()));
    const double value = valueAt(below);
    doubleClick(below);
    ASSERT_EQ(now().colour.size(), before->colour.size() + 1);
    EXPECT_EQ(now().colour[3].colour, colourAt(*before, value));
    EXPECT_EQ(now().opacity, before->opacity);
}

TEST_F(TransferEditorTest, TabGoesThroughAllPointsAndThenOn) {
    showPhantom();
    curve().setFocus();
    const std::size_t opacities = now().opacity.size();
    const std::size_t points = opacities + now().colour.size();
    for (std::size_t i = 0; i < points; ++i) {
        QTest::keyClick(&curve(), Qt::Key_Tab);
        const PointId wanted =
            i < opacities ? PointId{Curve::opacity, i} : PointId{Curve::colour, i - opacities};
        EXPECT_EQ(curve().selected(), wanted) << i;
        EXPECT_FALSE(curve().accessibleDescription().isEmpty());
    }
    QTest::keyClick(&curve(), Qt::Key_Backtab);
    EXPECT_EQ(curve().selected(), (PointId{Curve::colour, now().colour.size() - 2}));
    QTest::keyClick(&curve(), Qt::Key_Tab);
    QTest::keyClick(&curve(), Qt::Key_Tab);
    EXPECT_FALSE(curve().selected());
    EXPECT_FALSE(session_->canUndo());
}

TEST_F(TransferEditorTest, ArrowsMoveTheSelectedPoint) {
    showPhantom();
    const auto before = session_->state().preset;
    const OpacityPoint from = before->opacity[2];
    curve().select(kOpacity2);
    const double step = curve().keyStep();
    ASSERT_GT(step, 0.0);
    QTest::keyClick(&curve(), Qt::Key_Right);
    EXPECT_NEAR(now().opacity[2].value, from.value + step, 1e-9);
    EXPECT_EQ(now().opacity[2].opacity, from.opacity);
    QTest::keyClick(&curve(), Qt::Key_Left, Qt::ShiftModifier);
    EXPECT_NEAR(now().opacity[2].value, from.value + 0.9 * step, 1e-9);
    const double value = now().opacity[2].value;
    QTest::keyClick(&curve(), Qt::Key_Up);
    EXPECT_NEAR(now().opacity[2].opacity, from.opacity + 0.01, 1e-12);
    EXPECT_EQ(now().opacity[2].value, value);
    for (int i = 0; i < 2; ++i) session_->undo();
    expectOneStepBackTo(before);
}

TEST_F(TransferEditorTest, ArrowsMoveAllWhereNoPointIsSelected) {
    showPhantom();
    const auto before = session_->state().preset;
    const double step = curve().keyStep();
    QTest::keyClick(&curve(), Qt::Key_Left);
    for (std::size_t i = 0; i < before->opacity.size(); ++i)
        EXPECT_NEAR(now().opacity[i].value, before->opacity[i].value - step, 1e-9);
    expectOneStepBackTo(before);
    QTest::keyClick(&curve(), Qt::Key_Up);
    EXPECT_LT(now().opacity.front().value, before->opacity.front().value);
    EXPECT_GT(now().opacity.back().value, before->opacity.back().value);
    expectOneStepBackTo(before);
    QTest::keyClick(&curve(), Qt::Key_Down, Qt::ControlModifier);
    EXPECT_NEAR(now().opacity[2].opacity, before->opacity[2].opacity / 1.02, 1e-9);
    expectOneStepBackTo(before);
    QTest::keyClick(&curve(), Qt::Key_Insert);
    EXPECT_EQ(now().opacity.size(), before->opacity.size() + 1);
    expectOneStepBackTo(before);
}

TEST_F(TransferEditorTest, NumbersCanBeTyped) {
    showPhantom();
    auto& value = child<QDoubleSpinBox>("transfer-value");
    auto& opacity = child<QDoubleSpinBox>("transfer-opacity");
    EXPECT_FALSE(value.isEnabled());
    curve().select(kOpacity2);
    EXPECT_TRUE(value.isEnabled());
    EXPECT_EQ(value.suffix(), " HU");
    EXPECT_NEAR(value.value(), 641.385, 0.01);
    EXPECT_NEAR(opacity.value(), 0.715686, 0.001);
    EXPECT_FALSE(session_->canUndo()) << "what is shown is rounded, what is kept is not";
    value.selectAll();
    QTest::keyClicks(&value, "700");
    EXPECT_FALSE(session_->canUndo()) << "half a number is none";
    QTest::keyClick(&value, Qt::Key_Enter);
    EXPECT_EQ(now().opacity[2].value, 700.0);
    value.selectAll();
    QTest::keyClicks(&value, "99999");
    QTest::keyClick(&value, Qt::Key_Enter);
    EXPECT_EQ(now().opacity[2].value, 3071.0) << "not beyond the next point";
    EXPECT_EQ(value.value(), 3071.0);
    opacity.setValue(0.25);
    EXPECT_EQ(now().opacity[2].opacity, 0.25);
    curve().select(kColour2);
    EXPECT_FALSE(opacity.isEnabled());
    value.setValue(500.0);
    EXPECT_EQ(now().colour[2].value, 500.0);
    EXPECT_EQ(now().opacity[2].value, 3071.0);
}

TEST_F(TransferEditorTest, ARightDragShiftsAndWidensInOneStep) {
    showPhantom();
    const auto before = session_->state().preset;
    const QPoint from = emptyPlace();
    const auto expect = [&](double factor, double by) {
        const double about = valueAt(from);
        const auto wanted = [&](double value) { return about + factor * (value - about) + by; };
        for (std::size_t i = 0; i < before->opacity.size(); ++i) {
            EXPECT_NEAR(now().opacity[i].value, wanted(before->opacity[i].value), 1e-6);
            EXPECT_EQ(now().opacity[i].opacity, before->opacity[i].opacity);
        }
        for (std::size_t i = 0; i < before->colour.size(); ++i)
            EXPECT_NEAR(now().colour[i].value, wanted(before->colour[i].value), 1e-6);
        expectOneStepBackTo(before);
    };
    drag(from, QPoint(40, 0), Qt::RightButton);
    expect(1.0, 40.0 * unitsPerPx());
    drag(from, QPoint(-10, 50), Qt::RightButton);
    expect(std::exp2(-0.5), -10.0 * unitsPerPx());
    drag(from, QPoint(15, 5), Qt::LeftButton, Qt::AltModifier);
    expect(std::exp2(-0.05), 15.0 * unitsPerPx());

    drag(from, QPoint(15, 100), Qt::RightButton, Qt::ControlModifier);
    EXPECT_NEAR(now().opacity[2].opacity, 0.5 * before->opacity[2].opacity, 1e-9);
    EXPECT_EQ(now().opacity[2].value, before->opacity[2].value);
    expectOneStepBackTo(before);
    drag(from, QPoint(40, 40));
    EXPECT_EQ(session_->state().preset, before) << "a left drag there is for nothing";
}

TEST_F(TransferEditorTest, TheWheelZoomsTheAxisAboutThePointer) {
    showPhantom();
    const ValueRange all = curve().axis().shown;
    const QPoint at = emptyPlace();
    const double value = valueAt(at);
    wheel(at, 240);
    EXPECT_NEAR(valueAt(at), value, 1e-6);
    EXPECT_NEAR(curve().axis().shown.high - curve().axis().shown.low, 0.5 * (all.high - all.low), 1e-6);
    const QPoint axis(at.x(), int(curve().axisRect().center().y()));
    drag(axis, QPoint(30, 0));
    EXPECT_NEAR(valueAt(at + QPoint(30, 0)), value, 1e-6);
    doubleClick(axis);
    EXPECT_EQ(curve().axis().shown, all);
    EXPECT_FALSE(session_->canUndo());
}

TEST_F(TransferEditorTest, ResetCanBeUndone) {
    showPhantom();
    const auto before = session_->state().preset;
    auto& reset = child<QPushButton>("transfer-reset");
    EXPECT_FALSE(reset.isEnabled());
    drag(placeOf(kOpacity2), QPoint(20, 15));
    const auto edited = session_->state().preset;
    ASSERT_TRUE(reset.isEnabled());
    QTest::mouseClick(&reset, Qt::LeftButton);
    EXPECT_EQ(session_->state().preset, before);
    EXPECT_FALSE(reset.isEnabled());
    session_->undo();
    EXPECT_EQ(session_->state().preset, edited);
    EXPECT_TRUE(reset.isEnabled());
}

TEST_F(TransferEditorTest, WhatNobodyChoseIsEditedToo) {
    show(phantom::make({.size = {32, 28, 20}}), nullptr);
    EXPECT_TRUE(editor_->line().contains("as it was chosen"));
    drag(placeOf(kOpacity2), QPoint(0, 9));
    ASSERT_TRUE(session_->state().preset);
    EXPECT_TRUE(now().name.ends_with("-edited")) << now().name;
    QTest::mouseClick(&child<QPushButton>("transfer-reset"), Qt::LeftButton);
    EXPECT_FALSE(session_->state().preset);
}

// Of a study that is opened again: the copy is as it was left.
TEST_F(TransferEditorTest, ACopyOfAnotherSessionIsEditedFurther) {
    showPhantom();
    drag(placeOf(kOpacity2), QPoint(20, 15));
    const auto copy = session_->state().preset;
    show(phantom::make({.size = {32, 28, 20}}), copy);
    EXPECT_TRUE(editor_->line().contains("your copy of CT-Bone"));
    drag(placeOf(kOpacity2), QPoint(5, 5));
    EXPECT_EQ(now().name, copy->name);
    QTest::mouseClick(&child<QPushButton>("transfer-reset"), Qt::LeftButton);
    EXPECT_EQ(session_->state().preset, preset("ct-bone"));
}

TEST_F(TransferEditorTest, SomebodyElseMayChangeThePreset) {
    showPhantom();
    curve().select(kOpacity2);
    QTest::mousePress(&curve(), Qt::LeftButton, {}, placeOf(kOpacity2));
    QTest::mouseMove(&curve(), placeOf(kOpacity2) + QPoint(10, 10));
    ASSERT_TRUE(session_->canUndo());
    session_->undo();
    QTest::mouseMove(&curve(), placeOf(kOpacity2) + QPoint(30, 10));
    EXPECT_EQ(session_->state().preset, preset("ct-bone")) << "the hand holds nothing any more";
    QTest::mouseRelease(&curve(), Qt::LeftButton, {}, placeOf(kOpacity2));

    session_->change("Preset", [&](scene::StudyState& next) { next.preset = preset("ct-fat"); });
    EXPECT_TRUE(editor_->line().contains("CT-Fat")) << editor_->line().toStdString();
    curve().select(PointId{Curve::opacity, 1});
    QTest::keyClick(&curve(), Qt::Key_Right);
    EXPECT_EQ(now().name, "ct-fat-edited");
}

TEST_F(TransferEditorTest, SavingIsForTheWindow) {
    showPhantom();
    int asked = 0;
    QObject::connect(&*editor_, &TransferFunctionEditor::saveAsked, &*editor_, [&] { ++asked; });
    QTest::mouseClick(&child<QPushButton>("transfer-save"), Qt::LeftButton);
    EXPECT_EQ(asked, 1);
    EXPECT_FALSE(session_->canUndo());
}

TEST_F(TransferEditorTest, AColourIsSeenWhileItIsChosen) {
    showPhantom();
    const auto before = session_->state().preset;
    auto& button = child<QPushButton>("transfer-colour");
    curve().select(kOpacity2);
    EXPECT_FALSE(button.isEnabled());
    curve().select(kColour2);
    ASSERT_TRUE(button.isEnabled());

    const auto openDialog = [&] {
        QTest::mouseClick(&button, Qt::LeftButton);
        const auto dialogs = editor_->findChildren<QColorDialog*>();
        return dialogs.empty() ? nullptr : dialogs.back();
    };
    QColorDialog* dialog = openDialog();
    ASSERT_NE(dialog, nullptr);
    dialog->setCurrentColor(Qt::red);
    EXPECT_EQ(now().colour[2].colour, glm::dvec3(1.0, 0.0, 0.0));
    dialog->setCurrentColor(Qt::blue);
    dialog->accept();
    EXPECT_EQ(now().colour[2].colour, glm::dvec3(0.0, 0.0, 1.0));
    EXPECT_EQ(now().colour[1], before->colour[1]);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    expectOneStepBackTo(before);

    curve().select(kColour2);
    dialog = openDialog();
    ASSERT_NE(dialog, nullptr);
    dialog->setCurrentColor(Qt::green);
    dialog->reject();
    EXPECT_EQ(now().colour, before->colour) << "to the bit";
}

// MR: the curves lie where they are drawn, and the copy goes on being fitted to each volume.
TEST_F(TransferEditorTest, WhatIsFittedIsShownOnTheValuesOfTheVolume) {
    std::vector<std::uint16_t> voxels(20 * 20 * 20);
    for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = std::uint16_t((i * i) % 3001);
    const Volume volume =
        *Volume::create({.size = glm::ivec3(20), .unit = Unit::raw, .modality = "MR"}, voxels);
    const auto before = preset("cinematic-mr");
    show(volume, before);
    ASSERT_TRUE(curve().isEnabled());
    const TransferFunction drawn = fitted(*before, volume);
    const PointId third{Curve::opacity, 3};
    EXPECT_NEAR(valueAt(placeOf(third)), drawn.opacity[3].value, unitsPerPx());
    EXPECT_EQ(child<QDoubleSpinBox>("transfer-value").suffix(), "");

    drag(placeOf(third), QPoint(12, 0));
    EXPECT_EQ(now().fitToVolume, before->fitToVolume);
    EXPECT_NEAR(fitted(now(), volume).opacity[3].value, drawn.opacity[3].value + 12.0 * unitsPerPx(), 1e-6);
    curve().select(third);
    child<QDoubleSpinBox>("transfer-value").setValue(drawn.opacity[3].value + 1.0);
    EXPECT_NEAR(fitted(now(), volume).opacity[3].value, drawn.opacity[3].value + 1.0, 1e-3);
}

TEST_F(TransferEditorTest, NoHandMakesAPresetThatIsNotValid) {
    showPhantom("ct-cardiac3");
    std::mt19937 random(3);
    const auto below = [&](int end) { return int(random() % unsigned(end)); };
    const std::array keys{Qt::Key_Left, Qt::Key_Right,  Qt::Key_Up,     Qt::Key_Down, Qt::Key_Delete,
                          Qt::Key_Tab,  Qt::Key_Insert, Qt::Key_Escape, Qt::Key_Plus, Qt::Key_Minus};
    for (int i = 0; i < 150; ++i) {
        const QPoint at(1 + below(curve().width() - 1), 1 + below(curve().height() - 1));
        switch (below(6)) {
            case 0:
                drag(at, QPoint(below(400) - 200, below(400) - 200), Qt::RightButton);
                break;
            case 1:
                doubleClick(at);
                break;
            case 2:
                drag(at, QPoint(below(1000) - 500, below(1000) - 500));
                break;
            case 3:
                wheel(at, below(2) == 0 ? 120 : -120);
                break;
            case 4:
                if (below(4) == 0) session_->undo();
                break;
            default:
                for (int n = 0; n < 3; ++n)
                    QTest::keyClick(&curve(), keys.at(std::size_t(below(keys.size()))));
        }
        ASSERT_TRUE(validate(now())) << i << ": " << validate(now()).error().message;
        ASSERT_LT(curve().axis().shown.low, curve().axis().shown.high);
        // A colour that was asked for has a dialog, which takes the mouse.
        for (QColorDialog* dialog : editor_->findChildren<QColorDialog*>()) dialog->reject();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    EXPECT_FALSE(curve().grab().isNull());
}

TEST_F(TransferEditorTest, MayGoWhileItCounts) {
    session_->show({.volume = std::make_shared<const Volume>(phantom::make())}, {});
    EXPECT_TRUE(editor_->isCounting());
    editor_.reset();
}

}  // namespace
}  // namespace macula::viewer
