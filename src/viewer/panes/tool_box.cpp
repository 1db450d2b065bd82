#include "viewer/panes/tool_box.h"

#include <QAction>
#include <QActionGroup>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "viewer/editor/study_editor.h"
#include "viewer/keys/keys.h"
#include "viewer/keys/slice_tool_keys.h"
#include "viewer/menus/controls.h"
#include "viewer/theme/drawn_icon.h"

namespace macula::viewer {

namespace {

constexpr double kThickestSlabMm = 100.0;
constexpr int kDecimals = 1;
constexpr int kSlimPx = 27;  // of a button, so that all fit into a window of 800 pixels

struct ProjectionRow {
    slices::Projection projection;
    Glyph glyph;
    const char* name;
    const char* title;
};
constexpr std::array kProjections{
    ProjectionRow{slices::Projection::mean, Glyph::slabMean, "slab-mean",
                  QT_TRANSLATE_NOOP("macula::viewer::ToolBox", "Mean")},
    ProjectionRow{slices::Projection::maximum, Glyph::slabMaximum, "slab-maximum",
                  QT_TRANSLATE_NOOP("macula::viewer::ToolBox", "Maximum")},
    ProjectionRow{slices::Projection::minimum, Glyph::slabMinimum, "slab-minimum",
                  QT_TRANSLATE_NOOP("macula::viewer::ToolBox", "Minimum")}};

struct LayoutButton {
    scene::Layout layout;
    Glyph glyph;
    const char* name;
    const char* title;
};
constexpr std::array kLayoutButtons{
    LayoutButton{scene::Layout::fourPanes, Glyph::fourPanes, "layout-four-panes",
                 QT_TRANSLATE_NOOP("macula::viewer::ToolBox", "Four Panes")},
    LayoutButton{scene::Layout::volume, Glyph::volume, "layout-volume",
                 QT_TRANSLATE_NOOP("macula::viewer::ToolBox", "3D Only")},
    LayoutButton{scene::Layout::axial, Glyph::axial, "layout-axial",
                 QT_TRANSLATE_NOOP("macula::viewer::ToolBox", "Axial Only")},
    LayoutButton{scene::Layout::coronal, Glyph::coronal, "layout-coronal",
                 QT_TRANSLATE_NOOP("macula::viewer::ToolBox", "Coronal Only")},
    LayoutButton{scene::Layout::sagittal, Glyph::sagittal, "layout-sagittal",
                 QT_TRANSLATE_NOOP("macula::viewer::ToolBox", "Sagittal Only")}};

}  // namespace

ToolBox::ToolBox(StudyEditor& session, QWidget* parent)
    : QToolBar(tr("Slices"), parent),
      session_(session),
      tools_(new QActionGroup(this)),
      projections_(new QActionGroup(this)),
      layouts_(new QActionGroup(this)) {
    setObjectName(QStringLiteral("slice-tools"));
    setMovable(false);
    setOrientation(Qt::Vertical);
    addTools();
    addSeparator();
    addSlab();
    addShownAs();
    addSeparator();
    addLayouts();
    connect(this, &QToolBar::orientationChanged, this, &ToolBox::fitOrientation);
    connect(&session_, &StudyEditor::changed, this, &ToolBox::showState);
    connect(&session_, &StudyEditor::studyShown, this, &ToolBox::showState);
    fitOrientation();
    showState();
}

QAction* ToolBox::add(Glyph glyph, const char* name, const QString& title, const QString& tip) {
    QAction* action = addAction(drawnIcon(glyph), title);
    describe(*action, name, tip);
    action->setCheckable(true);
    // Otherwise Tab would skip the buttons of a tool bar.
    if (QWidget* button = widgetForAction(action)) button->setFocusPolicy(Qt::TabFocus);
    return action;
}

void ToolBox::addTools() {
    for (const SliceToolRow& row : kSliceTools) {
        const QByteArray name = QByteArray("slice-tool-") + row.name;
        const QKeySequence key = keyOf(row);
        QAction* action = add(row.glyph, name.constData(), titleOf(row), whatItDoes(row));
        // The tool tip has the present key: see KeyBook.
        const auto tellKey = [action, &row] {
            const QString pressed = action->shortcut().toString(QKeySequence::NativeText);
            const QString tip = pressed.isEmpty()
                                    ? tr("%1: %2").arg(titleOf(row), whatItDoes(row))
                                    : tr("%1 (%2): %3").arg(titleOf(row), pressed, whatItDoes(row));
            if (action->toolTip() != tip) action->setToolTip(tip);
        };
        connect(action, &QAction::changed, this, tellKey);
        action->setShortcut(key);
        action->setData(int(row.tool));
        action->setChecked(row.tool == tool_);
        tools_->addAction(action);
        connect(action, &QAction::triggered, this, [this, tool = row.tool] {
            tool_ = tool;
            Q_EMIT toolChosen(tool);
        });
    }
}

void ToolBox::addSlab() {
    auto* label = new QLabel(tr("Slab"), this);
    label->setAlignment(Qt::AlignCenter);
    thickness_ = new QDoubleSpinBox(this);
    thickness_->setObjectName(QStringLiteral("slab-thickness"));
    thickness_->setRange(0.0, kThickestSlabMm);
    thickness_->setDecimals(kDecimals);
    thickness_->setSuffix(tr(" mm"));
    thickness_->setAccessibleName(tr("Slab thickness in mm"));
    thickness_->setToolTip(
        tr("Thickness of the slab, 0 to %1 mm; 0 is the plane alone").arg(kThickestSlabMm));
    thickness_->setKeyboardTracking(false);  // "25" is not 2 mm for a moment
    label->setBuddy(thickness_);
    label->setToolTip(thickness_->toolTip());
    connect(thickness_, &QDoubleSpinBox::valueChanged, this, [this](double mm) {
        session_.drag(tr("Slab Thickness"),
                      [&](scene::StudyState& next) { next.slices.slab.thicknessMm = mm; });
    });
    connect(thickness_, &QDoubleSpinBox::editingFinished, &session_, &StudyEditor::endDrag);
    connect(thickness_->findChild<QLineEdit*>(), &QLineEdit::returnPressed, this, &ToolBox::thicknessEntered);
    addWidget(label);
    addWidget(thickness_);

    projection_ = new QToolButton(this);
    projection_->setObjectName(QStringLiteral("slab-projection"));
    projection_->setPopupMode(QToolButton::InstantPopup);
    projection_->setAutoRaise(true);
    projection_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);  // in the middle of the bar
    projection_->setFocusPolicy(Qt::TabFocus);
    auto* menu = new QMenu(projection_);
    for (const ProjectionRow& row : kProjections) {
        QAction* action = menu->addAction(tr(row.title));
        action->setObjectName(QLatin1String(row.name));
        action->setCheckable(true);
        action->setData(int(row.projection));
        projections_->addAction(action);
        connect(action, &QAction::triggered, this, [this, projection = row.projection] {
            session_.change(tr("Slab Kind"),
                            [&](scene::StudyState& next) { next.slices.slab.projection = projection; });
        });
    }
    projection_->setMenu(menu);
    addWidget(projection_);
}

void ToolBox::addShownAs() {
    invert_ = add(Glyph::invert, "slices-invert", tr("Invert"),
                  tr("White and black change places on slices; values stay as they are"));
    connect(invert_, &QAction::triggered, this, [this](bool on) {
        session_.change(tr("Invert"), [&](scene::StudyState& next) { next.slices.isInverted = on; });
    });
    acquired_ = add(Glyph::acquired, "slices-as-acquired", tr("Acquired Planes"),
                    tr("Slices in the planes of the acquisition, or in those of the patient"));
    connect(acquired_, &QAction::triggered, this, [this](bool on) {
        session_.change(tr("Acquired Planes"), [&](scene::StudyState& next) { next.slices.asAcquired = on; });
    });
    straight_ = add(Glyph::straight, "slices-straight", tr("Straight Planes"),
                    tr("Planes that were turned are straight again"));
    straight_->setCheckable(false);
    straight_->setShortcut(keyOf(KeyAction::straightPlanes));
    connect(straight_, &QAction::triggered, this, [this] {
        session_.change(tr("Straight Planes"), [](scene::StudyState& next) { next.slices.turn.reset(); });
    });
    cine_ = add(Glyph::cine, "slices-cine", tr("Cine"), tr("Run through the slices, or stop"));
    connect(cine_, &QAction::triggered, this, &ToolBox::cineToggled);
}

void ToolBox::addLayouts() {
    for (const LayoutButton& row : kLayoutButtons) {
        QAction* action = add(row.glyph, row.name, tr(row.title), tr(row.title));
        action->setData(int(row.layout));
        layouts_->addAction(action);
        connect(action, &QAction::triggered, this, [this, layout = row.layout] {
            session_.change(tr("Layout"), [&](scene::StudyState& next) { next.layout = layout; });
        });
    }
}

// The arrows of a spin box make it too wide for a vertical bar; wheel and arrow keys do the same.
void ToolBox::fitOrientation() {
    const bool isVertical = orientation() == Qt::Vertical;
    thickness_->setButtonSymbols(isVertical ? QAbstractSpinBox::NoButtons : QAbstractSpinBox::UpDownArrows);
    for (QToolButton* button : findChildren<QToolButton*>())
        button->setMaximumHeight(isVertical ? kSlimPx : QWIDGETSIZE_MAX);
}

void ToolBox::setTool(SliceTool tool) {
    tool_ = tool;
    for (QAction* action : tools_->actions()) {
        if (action->data().toInt() == int(tool)) action->setChecked(true);
    }
}

void ToolBox::setCine(bool plays) {
    cine_->setChecked(plays);
}

void ToolBox::showState() {
    const scene::StudyState& state = session_.state();
    const bool hasStudy = session_.hasStudy();
    for (QAction* action : {invert_, acquired_, cine_}) action->setEnabled(hasStudy);
    thickness_->setEnabled(hasStudy);
    projection_->setEnabled(hasStudy);
    layouts_->setEnabled(hasStudy);
    showSlab(state.slices.slab);
    invert_->setChecked(state.slices.isInverted);
    acquired_->setChecked(state.slices.asAcquired);
    straight_->setEnabled(hasStudy && state.slices.turn.has_value());
    for (QAction* action : layouts_->actions())
        action->setChecked(action->data().toInt() == int(state.layout));
}

void ToolBox::showSlab(const slices::Slab& slab) {
    const QSignalBlocker quiet(thickness_);
    const double mm = std::isfinite(slab.thicknessMm) ? slab.thicknessMm : 0.0;
    // A saved view may have a thicker slab, which is shown unchanged.
    thickness_->setMaximum(std::max(kThickestSlabMm, mm));
    const double tenth = std::pow(10.0, -kDecimals);
    // Setting the same value again would overwrite what a person is typing.
    if (std::abs(mm - thickness_->value()) >= 0.5 * tenth) thickness_->setValue(mm);
    for (QAction* action : projections_->actions())
        action->setChecked(action->data().toInt() == int(slab.projection));
    const auto row = std::ranges::find(kProjections, slab.projection, &ProjectionRow::projection);
    if (row == kProjections.end()) return;
    projection_->setIcon(drawnIcon(row->glyph));
    projection_->setText(tr("Slab kind: %1").arg(tr(row->title)));
    projection_->setToolTip(tr("What is shown of the values across the slab: %1").arg(tr(row->title)));
}

}  // namespace macula::viewer
