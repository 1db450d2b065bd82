#include "viewer/clip/cut_tools.h"

#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "scene/clip/eye_cut.h"
#include "viewer/clip/wheel_guard.h"
#include "viewer/language/window_language.h"
#include "viewer/status/say.h"

namespace macula::viewer {

CutTools::CutTools(StudyEditor& session, ClipEditing& editing, QWidget* parent)
    : QWidget(parent),
      session_(session),
      editing_(editing),
      onSlices_(new QCheckBox(tr("Show clip on slices"), this)),
      eye_(new QCheckBox(tr("Cut from the eye"), this)),
      depth_(new QDoubleSpinBox(this)),
      follows_(new QCheckBox(tr("Goes with the camera"), this)),
      scissors_(new QPushButton(tr("Scissors"), this)),
      uncut_(new QPushButton(tr("Undo all cuts"), this)),
      count_(new QLabel(this)),
      trouble_(new QLabel(this)) {
    auto* column = new QVBoxLayout(this);
    onSlices_->setObjectName(QStringLiteral("clip-on-slices"));
    onSlices_->setAccessibleName(tr("Show clip on slices"));
    onSlices_->setChecked(editing_.showsOnSlices());
    connect(onSlices_, &QCheckBox::toggled, &editing_, &ClipEditing::setShowsOnSlices);
    column->addWidget(onSlices_);
    column->addWidget(makeEye());
    column->addWidget(makeScissors());
    for (QLabel* text : {count_, trouble_}) {
        text->setTextFormat(Qt::PlainText);
        text->setWordWrap(true);
    }
    trouble_->setObjectName(QStringLiteral("clip-cuts-trouble"));
    column->addWidget(trouble_);

    connect(&session_, &StudyEditor::studyShown, this, &CutTools::showCuts);
    connect(&session_, &StudyEditor::changed, this, [this](const scene::StudyState& before) {
        const scene::StudyState& now = session_.state();
        if (now.cuts != before.cuts || now.clip != before.clip) showCuts();
    });
    showCuts();
}

QWidget* CutTools::makeEye() {
    auto* group = new QGroupBox(tr("Before the eye"), this);
    auto* form = new QFormLayout(group);
    eye_->setObjectName(QStringLiteral("clip-eye"));
    eye_->setAccessibleName(tr("Cut from the eye"));
    depth_->setObjectName(QStringLiteral("clip-eye-depth"));
    depth_->setAccessibleName(tr("Depth of the cut from the eye, in mm"));
    depth_->setSuffix(tr(" mm"));
    depth_->setDecimals(1);
    (new WheelGuard(this))->watch(*depth_);
    follows_->setObjectName(QStringLiteral("clip-eye-follows"));
    follows_->setAccessibleName(tr("The cut goes with the camera"));
    form->addRow(eye_);
    form->addRow(tr("Depth"), depth_);
    form->addRow(follows_);
    connect(eye_, &QCheckBox::toggled, this, [this](bool cuts) { tell(editing_.setEyeCut(cuts)); });
    connect(depth_, &QDoubleSpinBox::valueChanged, &editing_, &ClipEditing::dragEyeCut);
    connect(depth_, &QDoubleSpinBox::editingFinished, &session_, &StudyEditor::endDrag);
    connect(follows_, &QCheckBox::toggled, &editing_, &ClipEditing::setFollowsCamera);
    return group;
}

QWidget* CutTools::makeScissors() {
    auto* group = new QGroupBox(tr("Scissors over the 3D picture"), this);
    auto* column = new QVBoxLayout(group);
    auto* row = new QHBoxLayout;
    scissors_->setObjectName(QStringLiteral("clip-scissors"));
    scissors_->setAccessibleName(tr("Scissors"));
    scissors_->setCheckable(true);
    uncut_->setObjectName(QStringLiteral("clip-uncut"));
    uncut_->setAccessibleName(tr("Undo all cuts with the scissors"));
    row->addWidget(scissors_);
    row->addWidget(uncut_);
    column->addLayout(row);
    column->addWidget(count_);
    connect(scissors_, &QPushButton::toggled, this, &CutTools::scissorsAsked);
    connect(uncut_, &QPushButton::clicked, &editing_, &ClipEditing::removeScissorCuts);
    return group;
}

void CutTools::setScissorsOut(bool out) {
    const QSignalBlocker blocker(scissors_);
    scissors_->setChecked(out);
}

void CutTools::tell(const Result<void>& done) {
    showCuts();
    if (!done) say(*trouble_, inWindowsLanguage(done.error()));
}

void CutTools::setUsable(QWidget& control, const QString& does) {
    control.setEnabled(session_.hasStudy());
    control.setToolTip(session_.hasStudy() ? does : tr("Open a study first."));
}

void CutTools::showCuts() {
    const scene::Cuts& cuts = session_.state().cuts;
    const QSignalBlocker noEye(eye_);
    const QSignalBlocker noDepth(depth_);
    const QSignalBlocker noFollowing(follows_);
    setUsable(*onSlices_, tr("Slices show dark what the clip removes, and its borders as lines"));
    setUsable(*eye_, tr("Removes all that lies before a plane across the line of sight, at the cross-hair"));
    setUsable(*depth_, tr("From the middle of the volume, in mm; below 0 is nearer to the eye. In the "
                          "picture: Shift + wheel"));
    setUsable(*follows_, tr("The plane stays across the line of sight; else it stays in the patient"));
    setUsable(*scissors_, tr("Draw around something in the 3D picture: it is removed. With Shift, all "
                             "else is"));
    setUsable(*uncut_, tr("Shows again what the scissors removed"));
    const bool isLeftOut = cuts.eye && !scene::hasRoomForEyeCut(session_.state().clip);
    say(*trouble_, isLeftOut ? tr("The clip has six planes: the cut from the eye is not shown.") : QString());
    eye_->setChecked(cuts.eye.has_value());
    if (cuts.eye && session_.hasStudy()) {
        const ValueRange range = scene::eyeCutRangeMm(cuts.eye->plane.normal, *session_.study().volume);
        depth_->setRange(range.low, range.high);
        depth_->setSingleStep(std::max((range.high - range.low) / 100.0, 0.1));
        depth_->setValue(cuts.eye->fromMiddleMm);
        follows_->setChecked(cuts.eye->followsCamera);
    }
    for (QWidget* control : {static_cast<QWidget*>(depth_), static_cast<QWidget*>(follows_)}) {
        if (cuts.eye || !session_.hasStudy()) continue;
        control->setEnabled(false);
        control->setToolTip(tr("There is no cut from the eye."));
    }
    if (session_.hasStudy() && cuts.scissors.empty()) {
        uncut_->setEnabled(false);
        uncut_->setToolTip(tr("Nothing is cut with the scissors."));
    }
    say(*count_, cuts.scissors.empty() ? QString() : tr("Cuts: %1").arg(cuts.scissors.size()));
}

}  // namespace macula::viewer
