#include "viewer/clip/clip_panel.h"

#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QStringList>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "viewer/language/window_language.h"
#include "viewer/status/say.h"
#include "viewer/status/status_texts.h"

namespace macula::viewer {

namespace {

constexpr int kLettersAtLeast = 16;
constexpr double kFirstThicknessMm = 10.0;
constexpr std::array kOrientations{slices::Orientation::axial, slices::Orientation::coronal,
                                   slices::Orientation::sagittal};

QString capital(QString text) {
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return text;
}

// The sides of a corner by its number, 0 to 7.
std::array<scene::Face, 3> sidesOfCorner(int number) {
    return {scene::faceOf(0, (number & 1) == 0), scene::faceOf(1, (number & 2) != 0),
            scene::faceOf(2, (number & 4) == 0)};
}

// Whether `clip` is the listed one. Writing to a file may have changed the last bits of a box.
bool isSameClip(const ClipPreset& listed, const ClipPreset& clip) {
    return listed.name == clip.name && (listed == clip || toJson(listed) == toJson(clip));
}

// What the clip does besides its faces. Oblique planes have no remark of their own: they are counted.
QStringList remarksOn(const Clip& inMm) {
    const std::vector<scene::ShownShapePtr> shapes = scene::shownShapes(inMm);
    const auto isOblique = [](const scene::ShownShapePtr& shape) {
        return !shape->isFace() && shape->remark().empty();
    };
    const auto oblique = std::ranges::count_if(shapes, isOblique);
    QStringList remarks;
    bool isCounted = false;
    for (const scene::ShownShapePtr& shape : shapes) {
        if (const Text remark = shape->remark(); !remark.empty()) remarks << inWindowsLanguage(remark);
        if (!isOblique(shape) || std::exchange(isCounted, true)) continue;
        remarks << ClipPanel::tr("Oblique planes that cut: %1.").arg(oblique);
    }
    return remarks;
}

QString latin(std::string_view key) {
    return QString::fromLatin1(key.data(), qsizetype(key.size()));
}

QString reason(const Error& error) {
    return inWindowsLanguage(error);
}

}  // namespace

ClipPanel::ClipPanel(StudyEditor& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      guard_(new WheelGuard(this)),
      clips_(new QComboBox(this)),
      besides_(new QLabel(this)),
      crosshair_(new QLabel(this)),
      trouble_(new QLabel(this)) {
    makeClips();
    auto* column = new QVBoxLayout(this);
    column->addWidget(clips_);
    column->addWidget(makeFaces());
    besides_->setObjectName(QStringLiteral("clip-besides"));
    trouble_->setObjectName(QStringLiteral("clip-trouble"));
    for (QLabel* text : {besides_, crosshair_, trouble_}) {
        text->setTextFormat(Qt::PlainText);
        text->setWordWrap(true);
    }
    column->addWidget(besides_);
    auto* whole = new QHBoxLayout;
    whole->addWidget(addTool(tr("Turn inside out"), QStringLiteral("clip-inside-out"),
                             tr("Shows what the clip removes, and removes what it shows"),
                             [this] { return scene::turnedInsideOut(clip(), volume()); }));
    whole->addWidget(addTool(tr("Undo all: no clip"), QStringLiteral("clip-none"),
                             tr("Shows all of the volume again"), [this] { return withoutClip(); }));
    tools_.back().showsAll = true;
    column->addLayout(whole);
    column->addWidget(makeCuts());
    column->addWidget(makeSizes());
    column->addWidget(trouble_);
    say(*trouble_, {});
    column->addStretch(1);

    connect(&session_, &StudyEditor::studyShown, this, &ClipPanel::showStudy);
    connect(&session_, &StudyEditor::changed, this, [this](const scene::StudyState& before) {
        const scene::StudyState& now = session_.state();
        if (now.clip != before.clip || now.cuts != before.cuts) return showClip();
        if (isVisible() && now.slices.crosshairMm != before.slices.crosshairMm) showTools();
    });
    showStudy();
}

void ClipPanel::makeClips() {
    clips_->setObjectName(QStringLiteral("clip-list"));
    clips_->setAccessibleName(tr("Clip"));
    clips_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    clips_->setMinimumContentsLength(kLettersAtLeast);
    guard_->watch(*clips_);
    clips_->addItem(tr("No clip"));
    for (const auto& listed : session_.catalogue().clips) {
        clips_->addItem(titleOr(listed->title, listed->name));
        clips_->setItemData(clips_->count() - 1, clips_->itemText(clips_->count() - 1), Qt::ToolTipRole);
    }
    clips_->addItem(tr("Own"));
    connect(clips_, &QComboBox::activated, this, &ClipPanel::chooseFromList);
}

QWidget* ClipPanel::makeFaces() {
    auto* group = new QGroupBox(tr("Faces"), this);
    auto* column = new QVBoxLayout(group);
    for (const scene::Face face : scene::kFaces) {
        auto* row = new FaceRow(face, group);
        column->addWidget(row);
        faces_.push_back(row);
        connect(row, &FaceRow::moveBegan, &session_, &StudyEditor::endDrag);
        connect(row, &FaceRow::moved, this, [this, face](double mm) {
            if (session_.hasStudy()) propose(scene::withFace(clip(), face, mm, volume()), true);
        });
        connect(row, &FaceRow::moveEnded, &session_, &StudyEditor::endDrag);
        connect(row, &FaceRow::openAsked, this, [this, face] {
            if (session_.hasStudy()) propose(scene::withFaceOpen(clip(), face, volume()), false);
        });
    }
    return group;
}

QWidget* ClipPanel::makeCuts() {
    auto* group = new QGroupBox(tr("Remove from the cross-hair on"), this);
    auto* grid = new QGridLayout(group);
    crosshair_->setParent(group);
    crosshair_->setObjectName(QStringLiteral("clip-crosshair"));
    crosshair_->setToolTip(tr("Where the cross-hair is, in mm of the patient (LPS)"));
    grid->addWidget(crosshair_, 0, 0, 1, 2);
    for (const scene::Face side : scene::kFaces) {
        QPushButton* button = addTool(capital(tr("remove %1 side").arg(sideText(side))),
                                      QStringLiteral("clip-cut-") + latin(nameOf(side)),
                                      tr("Removes all that lies %1 of the cross-hair").arg(sideText(side)),
                                      [this, side] { return removedSide(side); });
        grid->addWidget(button, 1 + scene::axisOf(side), scene::isHigh(side) ? 1 : 0);
    }
    return group;
}

QWidget* ClipPanel::makeSizes() {
    auto* group = new QGroupBox(tr("At the cross-hair"), this);
    auto* form = new QFormLayout(group);
    thickness_ =
        makeMmBox(tr("Thickness of the slab"), tr("How thick the slab is, in mm"), kFirstThicknessMm);
    thickness_->setObjectName(QStringLiteral("clip-thickness"));
    orientations_ = new QComboBox(group);
    orientations_->addItems({tr("Axial"), tr("Coronal"), tr("Sagittal")});
    orientations_->setObjectName(QStringLiteral("clip-orientation"));
    orientations_->setAccessibleName(tr("Direction of the slab"));
    orientations_->setToolTip(tr("Along which slices the slab lies"));
    corners_ = new QComboBox(group);
    corners_->setObjectName(QStringLiteral("clip-corners"));
    corners_->setAccessibleName(tr("Corner"));
    corners_->setToolTip(tr("Which of the eight parts around the cross-hair is meant"));
    for (int number = 0; number < 8; ++number) {
        QStringList sides;
        for (const scene::Face side : sidesOfCorner(number)) sides << sideText(side);
        corners_->addItem(capital(sides.join(QLatin1Char(' '))));
    }
    for (QComboBox* box : {orientations_, corners_}) {
        guard_->watch(*box);
        connect(box, &QComboBox::currentIndexChanged, this, &ClipPanel::showTools);
    }

    QPushButton* slab = addTool(tr("Keep only a slab"), QStringLiteral("clip-slab"),
                                tr("Removes all but a slab with the cross-hair in its middle"), [this] {
                                    const auto along = std::size_t(orientations_->currentIndex());
                                    return scene::withSlabKept(clip(), kOrientations.at(along), crosshairMm(),
                                                               thickness_->value(), volume());
                                });
    QPushButton* corner = addTool(tr("Remove corner"), QStringLiteral("clip-corner"),
                                  tr("Removes that corner; it takes the place of another corner"),
                                  [this] { return removedCorner(); });
    form->addRow(tr("Slab"), orientations_);
    form->addRow(thickness_, slab);
    std::vector<QWidget*> order{orientations_, thickness_, slab};
    for (const scene::PanelTool& tool : scene::panelTools()) {
        QDoubleSpinBox* size =
            makeMmBox(inWindowsLanguage(tool.size), inWindowsLanguage(tool.whatSizeIs), tool.firstMm);
        size->setObjectName(QStringLiteral("clip-") + latin(tool.sizeKey));
        QPushButton* button = addShapeTool(tool, *size);
        form->addRow(size, button);
        order.insert(order.end(), {size, button});
        shapes_.push_back({.tool = tool, .size = size});
    }
    form->addRow(corners_, corner);
    order.insert(order.end(), {corners_, corner});
    for (std::size_t i = 1; i < order.size(); ++i) setTabOrder(order[i - 1], order[i]);
    return group;
}

QPushButton* ClipPanel::addShapeTool(const scene::PanelTool& shape, QDoubleSpinBox& size) {
    return addTool(inWindowsLanguage(shape.button), QStringLiteral("clip-") + latin(shape.key),
                   inWindowsLanguage(shape.whatItDoes),
                   [this, removed = shape.removed, sizesMm = shape.sizesMm, &size] {
                       const ValueRange usable = sizesMm(volume());
                       const double mm = std::clamp(size.value(), usable.low, usable.high);
                       return removed(clip(), crosshairMm(), mm, volume());
                   });
}

QPushButton* ClipPanel::addTool(const QString& text, const QString& name, const QString& what,
                                std::function<Edited()> edit) {
    auto* button = new QPushButton(text, this);
    button->setObjectName(name);
    button->setAccessibleName(what);
    tools_.push_back({.button = button, .what = what, .edit = std::move(edit)});
    const std::size_t number = tools_.size() - 1;
    connect(button, &QPushButton::clicked, this, [this, number] {
        if (session_.hasStudy()) propose(tools_.at(number).edit(), false, tools_.at(number).showsAll);
    });
    return button;
}

QDoubleSpinBox* ClipPanel::makeMmBox(const QString& name, const QString& what, double mm) {
    auto* box = new QDoubleSpinBox(this);
    box->setSuffix(tr(" mm"));
    box->setAccessibleName(name);
    box->setToolTip(what);
    box->setDecimals(1);
    box->setRange(0.1, 1000.0);
    box->setValue(mm);
    guard_->watch(*box);
    connect(box, &QDoubleSpinBox::valueChanged, this, &ClipPanel::showTools);
    return box;
}

void ClipPanel::chooseFromList(int index) {
    if (!session_.hasStudy()) return;
    const auto& listed = session_.catalogue().clips;
    if (index == 0) return propose(scene::OptionalClip{}, false, true);
    if (index == clips_->count() - 1) return propose(lastOwn_ ? lastOwn_ : clip(), false);
    propose(scene::OptionalClip(*listed.at(std::size_t(index) - 1)), false);
}

// A refused edit changes nothing, and the controls return to the session's clip.
void ClipPanel::propose(const Edited& edited, bool isDrag, bool showsAll) {
    say(*trouble_, edited ? QString() : reason(edited.error()));
    if (edited) {
        const auto edit = [&](scene::StudyState& next) {
            next.clip = *edited;
            if (showsAll) next.cuts = {};
        };
        isDrag ? session_.drag(tr("Clip"), edit) : session_.change(tr("Clip"), edit);
    }
    showClip();
}

void ClipPanel::showStudy() {
    lastOwn_.reset();
    say(*trouble_, {});
    if (session_.hasStudy()) {
        const Box all = volume().worldBox();
        const glm::dvec3 voxel = scene::voxelExtentMm(volume());
        for (FaceRow* row : faces_) {
            const int axis = scene::axisOf(row->face());
            row->setRangeMm(all.low[axis], all.high[axis], voxel[axis]);
        }
        const glm::dvec3 size = all.high - all.low;
        const double least = std::min({voxel.x, voxel.y, voxel.z});
        const auto setRange = [&](QDoubleSpinBox& box, double low, double high) {
            const QSignalBlocker blocker(box);
            box.setDecimals(decimalsForMm(least));
            box.setSingleStep(least);
            box.setRange(low, std::max(low, high));
        };
        setRange(*thickness_, least, std::max({size.x, size.y, size.z}));
        for (const SizedShape& shape : shapes_) {
            const ValueRange usable = shape.tool.sizesMm(volume());
            setRange(*shape.size, usable.low, usable.high);
        }
    }
    showClip();
}

void ClipPanel::showClip() {
    showInList();
    showFaces();
    showTools();
}

void ClipPanel::showInList() {
    const int own = clips_->count() - 1;
    int shown = 0;
    if (const scene::OptionalClip& now = clip(); now && session_.hasStudy()) {
        const auto& listed = session_.catalogue().clips;
        const auto found = std::find_if(listed.begin(), listed.end(),
                                        [&](const auto& item) { return isSameClip(*item, *now); });
        shown = found == listed.end() ? own : 1 + int(found - listed.begin());
        if (shown == own) lastOwn_ = now;
    }
    if (auto* items = qobject_cast<QStandardItemModel*>(clips_->model()))
        items->item(own)->setEnabled(lastOwn_.has_value());
    const QSignalBlocker blocker(clips_);
    clips_->setCurrentIndex(shown);
    clips_->setEnabled(session_.hasStudy());
    clips_->setToolTip(session_.hasStudy() ? tr("Which part of the volume is shown")
                                           : tr("Open a study first."));
}

void ClipPanel::showFaces() {
    QStringList besides;
    if (!session_.hasStudy()) {
        for (FaceRow* row : faces_) row->setUsable(false, tr("Open a study first."));
    } else {
        const Result<Box> kept = scene::keptBox(clip(), volume());
        for (FaceRow* row : faces_) {
            row->setUsable(kept.ok(), kept ? QString() : reason(kept.error()));
            if (kept) row->showMm(scene::faceMm(*kept, row->face()));
        }
        if (!kept) besides << reason(kept.error());
        if (clip()) besides << remarksOn(clipFor(*clip(), volume()));
    }
    say(*besides_, besides.join(QLatin1Char(' ')));
}

// A hidden panel does not follow the cross-hair.
void ClipPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    showTools();
}

void ClipPanel::showTools() {
    const bool hasStudy = session_.hasStudy();
    for (QWidget* size : {static_cast<QWidget*>(thickness_), static_cast<QWidget*>(orientations_),
                          static_cast<QWidget*>(corners_)})
        size->setEnabled(hasStudy);
    for (const SizedShape& shape : shapes_) shape.size->setEnabled(hasStudy);
    for (const Tool& tool : tools_) {
        QString whyNot = tr("Open a study first.");
        bool usable = false;
        if (hasStudy) {
            const Edited edited = tool.edit();
            usable = edited.ok();
            if (!usable) whyNot = reason(edited.error());
        }
        tool.button->setEnabled(usable);
        tool.button->setToolTip(usable ? tool.what : whyNot);
    }
    QString at;
    if (hasStudy) {
        const glm::dvec3 mm = crosshairMm();
        const auto text = [&](int axis) { return patientText(axis, mm[axis], 1, locale()); };
        at = tr("%1, %2, %3 mm").arg(text(0), text(1), text(2));
    }
    crosshair_->setText(at);
}

glm::dvec3 ClipPanel::crosshairMm() const {
    return session_.state().slices.crosshairMm.value_or(volume().worldBox().centre());
}

ClipPanel::Edited ClipPanel::removedSide(scene::Face side) const {
    return scene::withSideRemoved(clip(), side, crosshairMm(), volume());
}

ClipPanel::Edited ClipPanel::removedCorner() const {
    return scene::withCornerRemoved(clip(), sidesOfCorner(corners_->currentIndex()), crosshairMm(), volume());
}

ClipPanel::Edited ClipPanel::withoutClip() const {
    if (clip() || !session_.state().cuts.isNothing()) return scene::OptionalClip{};
    return Error{ErrorCode::usage,
                 Text::verbatim(tr("All of the volume is shown.").toStdString()),
                 {},
                 Text::verbatim(tr("There is nothing to undo.").toStdString())};
}

}  // namespace macula::viewer
