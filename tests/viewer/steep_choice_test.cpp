// Both pairs of curves of a preset in the window: what is edited is the pair that is chosen, and no other.
#include "viewer/transfer/matter_fields.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QMouseEvent>
#include <QPushButton>
#include <QTest>
#include <memory>
#include <optional>

#include "base/phantom.h"
#include "scene/choice/catalogue.h"
#include "scene/state/study_state.h"
#include "viewer/offscreen.h"
#include "viewer/transfer/transfer_function_editor.h"

namespace macula::viewer {
namespace {

using Curve = PointId::Curve;

class SteepChoiceTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
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
        OffscreenTest::TearDown();
    }

    void showPhantom(const char* name) {
        scene::StudyState state;
        state.preset = *scene::findPreset(session_->catalogue(), name);
        session_->show({.volume = std::make_shared<const Volume>(phantom::make({.size = {24, 20, 16}}))},
                       state);
        ASSERT_TRUE(waitUntil([&] { return !editor_->isCounting(); }));
    }
    QComboBox& side() { return *editor_->findChild<QComboBox*>(QStringLiteral("transfer-side")); }
    QPushButton& button(const char* name) {
        return *editor_->findChild<QPushButton*>(QString::fromLatin1(name));
    }
    QDoubleSpinBox& halfGradient() {
        return *editor_->findChild<QDoubleSpinBox*>(QStringLiteral("matter-steepGradientPerMm"));
    }
    TransferCurve& curve() { return editor_->curve(); }
    const TransferFunction& now() const { return *session_->state().preset; }
    void addSteep() { QTest::mouseClick(&button("transfer-steep"), Qt::LeftButton); }
    void dragPointUp(std::size_t index) {
        const QPoint from = curve().placeOf({Curve::opacity, index}).toPoint();
        QTest::mousePress(&curve(), Qt::LeftButton, {}, from);
        QMouseEvent move(QEvent::MouseMove, from + QPoint(0, -20), curve().mapToGlobal(from + QPoint(0, -20)),
                         Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&curve(), &move);
        QTest::mouseRelease(&curve(), Qt::LeftButton, {}, from + QPoint(0, -20));
    }

    std::optional<StudyEditor> session_;
    std::optional<TransferFunctionEditor> editor_;
};

TEST_F(SteepChoiceTest, WaitsForAStudyAndForCurves) {
    EXPECT_FALSE(button("transfer-steep").isEnabled());
    EXPECT_FALSE(side().isEnabled());
    showPhantom("ct-bone");
    EXPECT_TRUE(button("transfer-steep").isEnabled());
    EXPECT_FALSE(side().isEnabled()) << "there is one pair";
    EXPECT_FALSE(halfGradient().isEnabled()) << "nothing is steep";
    EXPECT_EQ(button("transfer-steep").text(), "Add steep");
}

TEST_F(SteepChoiceTest, AddedCurvesAreTheSameAndOneStep) {
    showPhantom("ct-bone");
    const auto before = session_->state().preset;
    addSteep();
    EXPECT_EQ(now().steep.opacity, before->opacity);
    EXPECT_EQ(now().steep.colour, before->colour);
    EXPECT_EQ(now().opacity, before->opacity);
    EXPECT_EQ(side().currentText(), "Steep") << "they are what is edited now";
    EXPECT_TRUE(side().isEnabled());
    EXPECT_TRUE(halfGradient().isEnabled());
    EXPECT_TRUE(editor_->line().contains("steep")) << editor_->line().toStdString();
    session_->undo();
    EXPECT_EQ(session_->state().preset, before);
    EXPECT_FALSE(session_->canUndo());
    EXPECT_EQ(side().currentText(), "Flat");
    EXPECT_FALSE(side().isEnabled());
    session_->redo();
    EXPECT_TRUE(usesSteepCurves(now()));
    EXPECT_EQ(side().currentText(), "Flat") << "nobody has chosen since";
}

TEST_F(SteepChoiceTest, APointThatIsDraggedIsOfThePairThatIsChosen) {
    showPhantom("ct-bone");
    addSteep();
    const TransferFunction split = now();
    dragPointUp(2);
    EXPECT_GT(now().steep.opacity[2].opacity, split.steep.opacity[2].opacity);
    EXPECT_EQ(now().opacity, split.opacity);
    EXPECT_EQ(now().steep.colour, split.steep.colour);
    const TransferFunction steepMoved = now();
    side().setCurrentIndex(0);
    EXPECT_FALSE(curve().selected());
    dragPointUp(2);
    EXPECT_GT(now().opacity[2].opacity, split.opacity[2].opacity);
    EXPECT_EQ(now().steep, steepMoved.steep);
    session_->undo();
    EXPECT_EQ(now(), steepMoved);
    session_->undo();
    EXPECT_EQ(now(), split);
}

// The curve that is shown is that of the pair, and so are the numbers of a point.
TEST_F(SteepChoiceTest, ShowsThePointsOfThePair) {
    showPhantom("ct-bone");
    addSteep();
    dragPointUp(2);
    curve().select(PointId{Curve::opacity, 2});
    auto& opacity = *editor_->findChild<QDoubleSpinBox*>(QStringLiteral("transfer-opacity"));
    EXPECT_NEAR(opacity.value(), now().steep.opacity[2].opacity, 1e-3);
    opacity.setValue(0.25);
    EXPECT_EQ(now().steep.opacity[2].opacity, 0.25);
    EXPECT_NE(now().opacity[2].opacity, 0.25);
    side().setCurrentIndex(0);
    curve().select(PointId{Curve::opacity, 2});
    EXPECT_NEAR(opacity.value(), now().opacity[2].opacity, 1e-3);
}

TEST_F(SteepChoiceTest, RemovedCurvesAreGoneAndComeBack) {
    showPhantom("ct-bone");
    const auto chosen = session_->state().preset;
    addSteep();
    dragPointUp(2);
    const TransferFunction split = now();
    EXPECT_EQ(button("transfer-steep").text(), "Remove steep");
    QTest::mouseClick(&button("transfer-steep"), Qt::LeftButton);
    EXPECT_FALSE(usesSteepCurves(now()));
    EXPECT_EQ(now().opacity, chosen->opacity);
    EXPECT_EQ(side().currentText(), "Flat");
    session_->undo();
    EXPECT_EQ(now(), split);
    QTest::mouseClick(&button("transfer-reset"), Qt::LeftButton);
    EXPECT_EQ(session_->state().preset, chosen);
}

TEST_F(SteepChoiceTest, TheHalfGradientIsTypedUnderMatter) {
    showPhantom("ct-bone");
    addSteep();
    EXPECT_EQ(halfGradient().suffix(), " HU/mm");
    EXPECT_EQ(halfGradient().value(), SteepMatter{}.gradientPerMm);
    halfGradient().setValue(320.0);
    EXPECT_EQ(now().steep.gradientPerMm, 320.0);
    EXPECT_TRUE(validate(now()).ok());
}

// A saved view has both pairs.
TEST_F(SteepChoiceTest, AreKeptWithTheState) {
    showPhantom("ct-bone");
    addSteep();
    dragPointUp(2);
    const Result<scene::StudyState> again = scene::studyStateFromJson(toJson(session_->state()), "state");
    ASSERT_TRUE(again.ok()) << again.error().message;
    EXPECT_EQ(again->preset->steep, now().steep);
}

}  // namespace
}  // namespace macula::viewer
