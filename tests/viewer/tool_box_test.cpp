// The bar of tools: what it proposes, and that it shows what was chosen elsewhere.
#include "viewer/panes/tool_box.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QTest>
#include <QToolButton>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "viewer/editor/study_editor.h"
#include "viewer/keys/keys.h"
#include "viewer/keys/slice_tool_keys.h"
#include "viewer/offscreen.h"

namespace macula::viewer {
namespace {

class ToolBoxTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        session_.emplace(scene::Catalogue{});
        box_.emplace(*session_);
    }
    void TearDown() override {
        box_.reset();
        session_.reset();
        OffscreenTest::TearDown();
    }
    void showStudy(scene::StudyState state = {}) { session_->show(smallStudy(), std::move(state)); }
    QAction& action(const char* name) {
        auto* found = box_->findChild<QAction*>(QLatin1String(name));
        if (found == nullptr) throw std::runtime_error(std::string("no action ") + name);
        return *found;
    }
    QDoubleSpinBox& thickness() {
        return *box_->findChild<QDoubleSpinBox*>(QStringLiteral("slab-thickness"));
    }
    const scene::SliceState& slices() const { return session_->state().slices; }
    int undoAll() {
        int steps = 0;
        for (; session_->canUndo(); ++steps) session_->undo();
        return steps;
    }

    std::optional<StudyEditor> session_;
    std::optional<ToolBox> box_;
};

TEST_F(ToolBoxTest, KeysOfToolsAreLettersThatNothingElseHas) {
    std::set<QString> keys;
    for (const KeyRow& row : kKeys) keys.insert(keyOf(row.action).toString());
    for (const SliceToolRow& row : kSliceTools) {
        const QString key = keyOf(row).toString();
        EXPECT_EQ(key.section(QLatin1Char('+'), -1).size(), 1) << row.name;
        EXPECT_TRUE(keys.insert(key).second) << row.name << ": " << row.key;
        const QAction& tool = action((std::string("slice-tool-") + row.name).c_str());
        EXPECT_EQ(tool.shortcut(), keyOf(row));
        EXPECT_TRUE(tool.toolTip().contains(QStringLiteral("(%1)").arg(key))) << row.name;
    }
    EXPECT_EQ(kSliceTools.size(), std::size_t(SliceTool::curve) + 1);
}

TEST_F(ToolBoxTest, OneToolIsChosen) {
    std::vector<SliceTool> chosen;
    QObject::connect(&*box_, &ToolBox::toolChosen, [&](SliceTool tool) { chosen.push_back(tool); });
    EXPECT_EQ(box_->tool(), SliceTool::crosshair);
    EXPECT_TRUE(action("slice-tool-crosshair").isChecked());
    action("slice-tool-angle").trigger();
    EXPECT_EQ(chosen, std::vector{SliceTool::angle});
    EXPECT_EQ(box_->tool(), SliceTool::angle);
    EXPECT_FALSE(action("slice-tool-crosshair").isChecked());
    box_->setTool(SliceTool::probe);
    EXPECT_TRUE(action("slice-tool-probe").isChecked());
    EXPECT_FALSE(action("slice-tool-angle").isChecked());
    EXPECT_EQ(chosen.size(), 1u) << "who sets it knows";
}

TEST_F(ToolBoxTest, WithoutAStudyNothingOfItCanBeChosen) {
    for (const char* name : {"slices-invert", "slices-as-acquired", "slices-cine", "layout-axial"})
        EXPECT_FALSE(action(name).isEnabled()) << name;
    EXPECT_FALSE(thickness().isEnabled());
    EXPECT_TRUE(action("slice-tool-zoom").isEnabled());
    showStudy();
    for (const char* name : {"slices-invert", "slices-as-acquired", "slices-cine", "layout-axial"})
        EXPECT_TRUE(action(name).isEnabled()) << name;
    EXPECT_TRUE(thickness().isEnabled());
}

TEST_F(ToolBoxTest, ProposesWhatIsChosen) {
    showStudy();
    action("slices-invert").trigger();
    EXPECT_TRUE(slices().isInverted);
    EXPECT_EQ(session_->undoText(), QStringLiteral("Invert"));
    action("slices-as-acquired").trigger();
    EXPECT_TRUE(slices().asAcquired);
    action("slab-maximum").trigger();
    EXPECT_EQ(slices().slab.projection, slices::Projection::maximum);
    action("slab-minimum").trigger();
    EXPECT_EQ(slices().slab.projection, slices::Projection::minimum);
    action("layout-coronal").trigger();
    EXPECT_EQ(session_->state().layout, scene::Layout::coronal);
    action("layout-coronal").trigger();  // it is chosen already
    EXPECT_EQ(undoAll(), 5);
    EXPECT_FALSE(action("slices-invert").isChecked());
    EXPECT_TRUE(action("layout-four-panes").isChecked());
    EXPECT_FALSE(action("layout-coronal").isChecked());
}

TEST_F(ToolBoxTest, StepsOfTheSlabAreOneUntilTheyEnd) {
    showStudy();
    for (int i = 0; i < 3; ++i) thickness().stepUp();
    EXPECT_EQ(slices().slab.thicknessMm, 3.0);
    Q_EMIT thickness().editingFinished();
    thickness().stepUp();
    EXPECT_EQ(slices().slab.thicknessMm, 4.0);
    EXPECT_EQ(undoAll(), 2);
    EXPECT_EQ(thickness().value(), 0.0);
    thickness().setValue(1e9);
    EXPECT_EQ(slices().slab.thicknessMm, 100.0);
    thickness().setValue(-1.0);
    EXPECT_EQ(slices().slab.thicknessMm, 0.0);
    EXPECT_TRUE(thickness().toolTip().contains(QStringLiteral("0 to 100 mm")));
}

TEST_F(ToolBoxTest, EnterEndsTypingAThickness) {
    showStudy();
    int entered = 0;
    QObject::connect(&*box_, &ToolBox::thicknessEntered, &*box_, [&] { ++entered; });
    thickness().selectAll();
    QTest::keyClicks(&thickness(), QStringLiteral("25"));
    EXPECT_EQ(entered, 0);
    QTest::keyClick(&thickness(), Qt::Key_Return);
    EXPECT_EQ(entered, 1);
    EXPECT_EQ(slices().slab.thicknessMm, 25.0);
}

TEST_F(ToolBoxTest, ShowsWhatWasChosenElsewhereAndProposesNothing) {
    scene::StudyState state;
    state.layout = scene::Layout::sagittal;
    state.slices.slab = {.thicknessMm = 12.5, .projection = slices::Projection::maximum};
    state.slices.isInverted = true;
    showStudy(state);
    EXPECT_EQ(thickness().value(), 12.5);
    EXPECT_TRUE(action("slab-maximum").isChecked());
    EXPECT_FALSE(action("slab-mean").isChecked());
    EXPECT_TRUE(action("slices-invert").isChecked());
    EXPECT_TRUE(action("layout-sagittal").isChecked());
    session_->change(QStringLiteral("Planes"),
                     [](scene::StudyState& next) { next.slices.asAcquired = true; });
    EXPECT_TRUE(action("slices-as-acquired").isChecked());
    EXPECT_EQ(undoAll(), 1);
    EXPECT_EQ(session_->state(), state);
    const auto* kind = box_->findChild<QToolButton*>(QStringLiteral("slab-projection"));
    EXPECT_TRUE(kind->toolTip().endsWith(QStringLiteral("Maximum")));
}

TEST_F(ToolBoxTest, ASlabThatIsThickerOrFinerThanItsStepsIsShownAndKept) {
    scene::StudyState state;
    for (const double mm : {250.0, 0.625}) {
        state.slices.slab.thicknessMm = mm;
        showStudy(state);
        EXPECT_NEAR(thickness().value(), mm, 0.05);
        Q_EMIT thickness().editingFinished();
        EXPECT_EQ(slices().slab.thicknessMm, mm);
        EXPECT_FALSE(session_->canUndo());
    }
    state.slices.slab.thicknessMm = std::numeric_limits<double>::quiet_NaN();
    showStudy(state);
    EXPECT_EQ(thickness().value(), 0.0);
}

TEST_F(ToolBoxTest, CineIsAskedForAndStopsWithoutAWord) {
    showStudy();
    std::vector<bool> asked;
    QObject::connect(&*box_, &ToolBox::cineToggled, [&](bool plays) { asked.push_back(plays); });
    action("slices-cine").trigger();
    EXPECT_EQ(asked, std::vector{true});
    box_->setCine(false);
    EXPECT_FALSE(action("slices-cine").isChecked());
    EXPECT_EQ(asked.size(), 1u);
    EXPECT_FALSE(session_->canUndo()) << "it is no part of the state";
}

TEST_F(ToolBoxTest, EveryControlCanBeReachedAndSaysWhatItIs) {
    int buttons = 0;
    for (const auto* button : box_->findChildren<QToolButton*>()) {
        if (button->objectName() == QStringLiteral("qt_toolbar_ext_button")) continue;
        ++buttons;
        EXPECT_TRUE(button->focusPolicy() & Qt::TabFocus) << button->text().toStdString();
        EXPECT_FALSE(button->text().isEmpty());
        EXPECT_FALSE(button->toolTip().isEmpty()) << button->text().toStdString();
        EXPECT_FALSE(button->icon().isNull()) << button->text().toStdString();
    }
    EXPECT_EQ(buttons, int(kSliceTools.size()) + 10);
    EXPECT_FALSE(thickness().accessibleName().isEmpty());
    EXPECT_EQ(thickness().suffix(), QStringLiteral(" mm"));
}

// Each glyph is another one, is not empty, and has as many pixels as the screen asks for.
TEST_F(ToolBoxTest, IconsAreSharpAtAnyScale) {
    std::set<QByteArray> seen;
    for (int glyph = 0; glyph <= int(Glyph::cine); ++glyph) {
        const QIcon icon = drawnIcon(Glyph(glyph));
        const QPixmap at200 = icon.pixmap(QSize(24, 24), 2.0);
        EXPECT_EQ(at200.size(), QSize(48, 48));
        EXPECT_EQ(at200.devicePixelRatio(), 2.0);
        const QImage image = at200.toImage().convertToFormat(QImage::Format_ARGB32);
        int drawn = 0;
        for (int y = 0; y < 48; ++y) {
            for (int x = 0; x < 48; ++x) drawn += qAlpha(image.pixel(x, y)) > 128 ? 1 : 0;
        }
        EXPECT_GT(drawn, 40) << glyph;
        EXPECT_LT(drawn, 48 * 48 * 3 / 4) << glyph;
        const QByteArray bytes(reinterpret_cast<const char*>(image.constBits()), image.sizeInBytes());
        EXPECT_TRUE(seen.insert(bytes).second) << glyph << " looks like another one";
    }
    const QIcon icon = drawnIcon(Glyph::distance);
    const auto middle = [&](QIcon::Mode mode) {
        return icon.pixmap(QSize(24, 24), 1.0, mode).toImage().pixelColor(12, 12).name();
    };
    QPalette palette;
    palette.setColor(QPalette::Active, QPalette::ButtonText, QColor(10, 200, 30));
    palette.setColor(QPalette::Disabled, QPalette::ButtonText, QColor(90, 90, 90));
    QApplication::setPalette(palette);
    EXPECT_EQ(middle(QIcon::Normal), QColor(10, 200, 30).name());
    EXPECT_EQ(middle(QIcon::Disabled), QColor(90, 90, 90).name());
}

}  // namespace
}  // namespace macula::viewer
