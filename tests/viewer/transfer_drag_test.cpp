// A hand in the picture that shifts and widens the transfer function.
#include "viewer/transfer/transfer_drag.h"

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QStringList>
#include <limits>
#include <memory>
#include <optional>

#include "base/phantom.h"
#include "viewer/offscreen.h"

namespace macula::viewer {
namespace {

class TransferDragTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        auto catalogue = scene::builtInCatalogue();
        ASSERT_TRUE(catalogue.ok());
        session_.emplace(*std::move(catalogue));
        editor_.emplace(*session_);
        drag_.emplace(*session_, *editor_);
        QObject::connect(&*drag_, &TransferDrag::told, &*drag_,
                         [this](const QString& what) { told_ << what; });
    }
    void TearDown() override {
        drag_.reset();
        editor_.reset();
        session_.reset();
        OffscreenTest::TearDown();
    }
    void showPhantom() {
        scene::StudyState state;
        state.preset = *scene::findPreset(session_->catalogue(), "ct-bone");
        session_->show({.volume = std::make_shared<const Volume>(phantom::make({.size = {32, 28, 20}}))},
                       state);
        ASSERT_TRUE(waitUntil([&] { return !editor_->isCounting(); }));
    }
    const TransferFunction& now() const { return *session_->state().preset; }
    // From where the opacity begins to change to where it ends.
    static double widthOf(const TransferFunction& function) {
        double first = 0.0;
        double last = 0.0;
        bool any = false;
        for (std::size_t i = 1; i < function.opacity.size(); ++i) {
            if (function.opacity[i].opacity == function.opacity[i - 1].opacity) continue;
            if (!any) first = function.opacity[i - 1].value;
            any = true;
            last = function.opacity[i].value;
        }
        return last - first;
    }

    std::optional<StudyEditor> session_;
    std::optional<TransferFunctionEditor> editor_;
    std::optional<TransferDrag> drag_;
    QStringList told_;
};

TEST_F(TransferDragTest, ToTheRightShiftsAndUpWidensAsOneStep) {
    showPhantom();
    const auto before = session_->state().preset;
    const double width = widthOf(*before);
    ASSERT_GT(width, 0.0);
    for (int i = 0; i < 5; ++i) drag_->drag({0.02, 0.0});
    EXPECT_NEAR(now().opacity[2].value, before->opacity[2].value + 0.1 * width, 1e-6 * width);
    EXPECT_NEAR(now().colour.back().value, before->colour.back().value + 0.1 * width, 1e-6 * width);
    EXPECT_TRUE(told_.last().contains(QStringLiteral("HU"))) << told_.last().toStdString();
    EXPECT_TRUE(told_.last().contains(QLatin1Char('+')));
    drag_->drag({-0.1, -0.5});  // back, and half a height up
    EXPECT_NEAR(widthOf(now()), 2.0 * width, 1e-6 * width);
    EXPECT_TRUE(told_.last().contains(QStringLiteral("2.00"))) << told_.last().toStdString();
    drag_->end();
    EXPECT_TRUE(told_.last().isEmpty());
    EXPECT_NE(now().name, before->name) << "a preset is never changed: a copy is";

    // The next one is another step, and edits the same copy.
    const auto first = session_->state().preset;
    drag_->drag({0.1, 0.0});
    drag_->end();
    EXPECT_EQ(now().name, first->name);
    session_->undo();
    EXPECT_EQ(session_->state().preset, first);
    session_->undo();
    EXPECT_EQ(session_->state().preset, before);
    EXPECT_FALSE(session_->canUndo());
}

TEST_F(TransferDragTest, WithoutAStudyNothingHappens) {
    drag_->drag({0.1, 0.1});
    drag_->end();
    EXPECT_FALSE(session_->canUndo());
    EXPECT_TRUE(told_.isEmpty());
}

TEST_F(TransferDragTest, NoHandMakesAPresetThatIsNotValid) {
    showPhantom();
    for (const QPointF& by : {QPointF(1e9, 0), QPointF(-3e9, -1e6), QPointF(0, 1e9),
                              QPointF(std::numeric_limits<double>::quiet_NaN(), 0.0)}) {
        drag_->drag(by);
        EXPECT_TRUE(validate(now()).ok());
    }
    drag_->end();
    session_->undo();
    EXPECT_FALSE(session_->canUndo());
}

}  // namespace
}  // namespace macula::viewer
