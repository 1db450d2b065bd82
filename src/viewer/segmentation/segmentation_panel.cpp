#include "viewer/segmentation/segmentation_panel.h"

#include <QColorDialog>
#include <QFont>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLocale>
#include <QPixmap>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QStringList>
#include <QTreeWidgetItemIterator>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "viewer/clip/wheel_guard.h"
#include "viewer/language/harmless_text.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/overlay/slice_texts.h"

namespace macula::viewer {

namespace {

constexpr int kDigestRole = Qt::UserRole;
constexpr int kNumberRole = Qt::UserRole + 1;
constexpr int kName = 0;
constexpr int kMl = 1;
constexpr int kIn3d = 2;
constexpr int kChipPx = 14;

QString shown(const std::string& text) {
    return harmless(QString::fromStdString(text));
}

QIcon chip(const QColor& colour) {
    QPixmap pixmap(kChipPx, kChipPx);
    pixmap.fill(colour);
    return QIcon(pixmap);
}

// The note below the list explains the sign.
QString mlText(double ml, bool isCalibrated) {
    const QString text = QLocale().toString(ml, 'f', ml < 1.0 ? 3 : ml < 100.0 ? 2 : 1);
    return isCalibrated ? text : QStringLiteral("≈ ") + text;
}

QString madeBy(const Segment& segment) {
    QString how;
    if (segment.algorithm == "MANUAL") how = SegmentationPanel::tr("Drawn by hand");
    if (segment.algorithm == "SEMIAUTOMATIC") how = SegmentationPanel::tr("Made by a person with a program");
    if (segment.algorithm == "AUTOMATIC") how = SegmentationPanel::tr("Made by a program");
    const QString name = shown(segment.algorithmName);
    if (name.isEmpty()) return how;
    return how.isEmpty() ? name : QStringLiteral("%1: %2").arg(how, name);
}

QString toolTipOf(const Segment& segment) {
    QStringList lines{SegmentationPanel::tr("Segment %1").arg(segment.number)};
    for (const QString& line : {shown(segment.description), madeBy(segment)})
        if (!line.isEmpty()) lines << line;
    return lines.join(QLatin1Char('\n')).toHtmlEscaped().replace(QLatin1Char('\n'), QStringLiteral("<br>"));
}

QString in3dText(scene::In3d in3d) {
    switch (in3d) {
        case scene::In3d::asIs:
            return {};
        case scene::In3d::alone:
            return SegmentationPanel::tr("alone");
        case scene::In3d::hidden:
            return SegmentationPanel::tr("hidden");
    }
    return {};
}

QString in3dText(const scene::SegmentSettings& choice) {
    QStringList words;
    if (const QString word = in3dText(choice.in3d); !word.isEmpty()) words << word;
    if (choice.isColouredIn3d) words << SegmentationPanel::tr("in colour");
    return words.join(QStringLiteral(", "));
}

}  // namespace

SegmentationPanel::SegmentationPanel(StudyEditor& session, SegmentationKeeper& keeper, QWidget* parent)
    : QWidget(parent), session_(session), keeper_(keeper), edits_(session, keeper) {
    makeTree();
    notes_ = new QLabel(this);
    makePlain(*notes_, "segments-notes");
    auto* column = new QVBoxLayout(this);
    column->addWidget(tree_, 1);
    column->addWidget(makeControls());
    column->addWidget(notes_);
    connect(&keeper_, &SegmentationKeeper::listChanged, this, &SegmentationPanel::fill);
    connect(&session_, &StudyEditor::changed, this, [this](const scene::StudyState& before) {
        if (session_.state().segmentations != before.segmentations) showChoices();
    });
    fill();
}

void SegmentationPanel::makeTree() {
    tree_ = new QTreeWidget(this);
    describe(*tree_, "segments", tr("Segmentations"),
             tr("Segmentations of the folder; a check mark shows them on slices"));
    tree_->setHeaderLabels({tr("Segment"), tr("ml"), tr("3D")});
    tree_->header()->setSectionResizeMode(kName, QHeaderView::Stretch);
    tree_->header()->setSectionResizeMode(kMl, QHeaderView::ResizeToContents);
    tree_->header()->setSectionResizeMode(kIn3d, QHeaderView::ResizeToContents);
    tree_->header()->setStretchLastSection(false);
    connect(tree_, &QTreeWidget::itemChanged, this, &SegmentationPanel::onItemChanged);
    connect(tree_, &QTreeWidget::currentItemChanged, this, [this] {
        if (isFilling_) return;
        showControls();
        Q_EMIT selectionChanged();
    });
}

QWidget* SegmentationPanel::makeControls() {
    auto* controls = new QWidget(this);
    const auto button = [controls](const QString& text, const char* name, const QString& what) {
        auto* made = new QPushButton(text, controls);
        describe(*made, name, what, what);
        return made;
    };
    colour_ = button(tr("Colour…"), "segment-colour",
                     tr("Colour of the segment on slices, and in 3D where it is in colour there"));
    connect(colour_, &QPushButton::clicked, this, &SegmentationPanel::askForColour);
    centre_ = button(tr("Centre"), "segment-centre", tr("Cross-hair to the middle of the segment"));
    connect(centre_, &QPushButton::clicked, this, &SegmentationPanel::centre);
    alone_ = button(tr("Alone"), "segment-alone",
                    tr("In 3D, this segment and others that are alone, and nothing else"));
    hide_ = button(tr("Hide"), "segment-hide", tr("In 3D, all but this segment"));
    coloured_ = button(tr("In colour"), "segment-coloured",
                       tr("In 3D, the matter in this segment has the colour of the segment"));
    for (QPushButton* each : {alone_, hide_, coloured_}) each->setCheckable(true);
    connect(coloured_, &QPushButton::clicked, this, &SegmentationPanel::setColoured);
    connect(alone_, &QPushButton::clicked, this, [this](bool on) { setIn3d(scene::In3d::alone, on); });
    connect(hide_, &QPushButton::clicked, this, [this](bool on) { setIn3d(scene::In3d::hidden, on); });
    opacity_ = makeOpacity("segment-opacity", tr("How opaque the segment is filled on slices, in %"),
                           &scene::SegmentSettings::opacity, controls);
    opacity_->setAccessibleName(tr("Opacity"));
    opacityIn3d_ = makeOpacity("segment-opacity-3d",
                               tr("In 3D, how much of the matter in a segment in colour is left, in %"),
                               &scene::SegmentSettings::opacityIn3d, controls);
    opacityIn3d_->setAccessibleName(tr("Opacity in 3D"));

    auto* form = new QFormLayout(controls);
    form->setContentsMargins(0, 0, 0, 0);
    const auto row = [](QWidget* a, QWidget* b) {
        auto* both = new QHBoxLayout;
        both->addWidget(a);
        both->addWidget(b);
        return both;
    };
    form->addRow(row(colour_, centre_));
    form->addRow(tr("Opacity"), opacity_);
    form->addRow(tr("In 3D"), row(alone_, hide_));
    form->addRow(QString(), coloured_);
    form->addRow(tr("Opacity in 3D"), opacityIn3d_);
    return controls;
}

QSlider* SegmentationPanel::makeOpacity(const char* name, const QString& text,
                                        double scene::SegmentSettings::*opacity, QWidget* parent) {
    auto* slider = new QSlider(Qt::Horizontal, parent);
    slider->setObjectName(QString::fromLatin1(name));
    slider->setToolTip(text);
    slider->setRange(0, 100);
    slider->setPageStep(10);
    (new WheelGuard(this))->watch(*slider);
    connect(slider, &QSlider::valueChanged, this, [this, slider, opacity](int percent) {
        if (const auto row = selected()) edits_.dragOpacity(*row, opacity, percent / 100.0);
        if (!slider->isSliderDown()) session_.endDrag();
    });
    connect(slider, &QSlider::sliderReleased, &session_, &StudyEditor::endDrag);
    return slider;
}

void SegmentationPanel::showNames(bool shown) {
    if (shown == namesShown_) return;
    namesShown_ = shown;
    fill();
}

SegmentId SegmentationPanel::idOf(const QTreeWidgetItem& item) {
    const QVariant number = item.data(kName, kNumberRole);
    return {item.data(kName, kDigestRole).toString().toStdString(),
            number.isValid() ? std::optional(std::uint16_t(number.toInt())) : std::nullopt};
}

void SegmentationPanel::fill() {
    {
        const QScopedValueRollback fills(isFilling_, true);
        const QSignalBlocker blocker(tree_);
        const auto was = tree_->currentItem() ? std::optional(idOf(*tree_->currentItem())) : std::nullopt;
        tree_->clear();
        std::size_t place = 0;
        for (const study::FoundSegmentation& found : keeper_.found()) addSegmentation(found, ++place);
        tree_->expandAll();
        for (QTreeWidgetItemIterator at(tree_); was && *at != nullptr; ++at) {
            if (isSame(idOf(**at), *was)) tree_->setCurrentItem(*at);
        }
    }
    showChoices();
    Q_EMIT selectionChanged();
}

bool SegmentationPanel::isSame(const SegmentId& a, const SegmentId& b) const {
    return a.number == b.number &&
           (a.digest == b.digest || (keeper_.isOwn(a.digest) && keeper_.isOwn(b.digest)));
}

void SegmentationPanel::select(const SegmentId& id) {
    for (QTreeWidgetItemIterator at(tree_); *at != nullptr; ++at)
        if (isSame(idOf(**at), id)) tree_->setCurrentItem(*at);
}

void SegmentationPanel::addSegmentation(const study::FoundSegmentation& found, std::size_t place) {
    auto* item = new QTreeWidgetItem(tree_);
    item->setData(kName, kDigestRole, QString::fromStdString(found.digest));
    const QString title = namesShown_ ? shown(found.title) : tr("Segmentation %1").arg(place);
    item->setText(kName, title);
    item->setToolTip(kName, title.toHtmlEscaped());
    if (found.isOwn) {
        item->setText(kName, QString::fromStdString(found.title));  // names nobody
        item->setToolTip(kName, tr("Made here, by you: they are in no file of the folder"));
        QFont own = item->font(kName);
        own.setItalic(true);
        item->setFont(kName, own);
    }
    if (!found.canBeShown()) {
        // The reason is a row below, so that nobody has to look for it.
        auto* why = new QTreeWidgetItem(item);
        const QString reason = harmless(inWindowsLanguage(found.whyNot));
        why->setText(kName, reason);
        why->setToolTip(kName, reason.toHtmlEscaped());
        why->setFirstColumnSpanned(true);
        for (QTreeWidgetItem* each : {item, why})
            each->setFlags(each->flags() & ~(Qt::ItemIsUserCheckable | Qt::ItemIsEnabled));
        return;
    }
    item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
    if (const study::LoadedSegmentation* there = keeper_.loaded(found.digest)) {
        for (const study::LoadedSegment& each : there->segments)
            addSegment(*item, found.digest, each.segment);
    } else {
        for (const Segment& each : found.header.segments) addSegment(*item, found.digest, each);
    }
}

void SegmentationPanel::addSegment(QTreeWidgetItem& above, const std::string& digest,
                                   const Segment& segment) {
    auto* item = new QTreeWidgetItem(&above);
    item->setData(kName, kDigestRole, QString::fromStdString(digest));
    item->setData(kName, kNumberRole, segment.number);
    const QString label = shown(segment.label);
    item->setText(kName, label.isEmpty() ? tr("Segment %1").arg(segment.number) : label);
    item->setToolTip(kName, toolTipOf(segment));
    item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
    const study::LoadedSegment* there = edits_.loaded({digest, segment.number});
    QString ml = QStringLiteral("–");
    if (there != nullptr && there->volumeMl) ml = mlText(*there->volumeMl, isCalibrated());
    item->setText(kMl, ml);
    item->setTextAlignment(kMl, Qt::AlignRight | Qt::AlignVCenter);
    const QString what = there == nullptr ? tr("Volume in ml, once the segmentation is shown")
                                          : tr("Volume in ml: its voxels, times that of one");
    item->setToolTip(kMl, isCalibrated() ? what : notCalibrated(what));
}

bool SegmentationPanel::isCalibrated() const {
    return !session_.hasStudy() || session_.study().volume->provenance().isCalibrated;
}

void SegmentationPanel::showChoices() {
    {
        const QSignalBlocker blocker(tree_);
        for (QTreeWidgetItemIterator at(tree_); *at != nullptr; ++at) showChoice(**at);
    }
    showControls();
}

void SegmentationPanel::showChoice(QTreeWidgetItem& item) {
    if (!item.flags().testFlag(Qt::ItemIsUserCheckable)) return;
    const SegmentId id = idOf(item);
    item.setCheckState(kName, edits_.isShown(id) ? Qt::Checked : Qt::Unchecked);
    if (!id.number) return;
    item.setIcon(kName, chip(edits_.colour(id)));
    item.setText(kIn3d, in3dText(edits_.settings(id)));
}

void SegmentationPanel::onItemChanged(QTreeWidgetItem* item, int column) {
    if (column == kName && session_.hasStudy())
        edits_.show(idOf(*item), item->checkState(kName) == Qt::Checked);
}

std::optional<SegmentId> SegmentationPanel::selected() const {
    const QTreeWidgetItem* item = tree_->currentItem();
    if (item == nullptr || !item->flags().testFlag(Qt::ItemIsUserCheckable) || !session_.hasStudy())
        return std::nullopt;
    const SegmentId row = idOf(*item);
    return row.number ? std::optional(row) : std::nullopt;
}

void SegmentationPanel::showControls() {
    const auto row = selected();
    for (QWidget* each : {static_cast<QWidget*>(colour_), static_cast<QWidget*>(opacity_)})
        each->setEnabled(row.has_value());
    const study::LoadedSegment* there = row ? edits_.loaded(*row) : nullptr;
    const bool isEmpty = there != nullptr && !there->isInVolume();
    centre_->setEnabled(there != nullptr && there->centroidMm.has_value());
    const scene::SegmentSettings now = row ? edits_.settings(*row) : scene::SegmentSettings{};
    for (QPushButton* each : {alone_, hide_, coloured_}) each->setEnabled(row && !isEmpty);
    coloured_->setChecked(now.isColouredIn3d);
    opacityIn3d_->setEnabled(row && !isEmpty && now.isColouredIn3d);
    alone_->setChecked(now.in3d == scene::In3d::alone);
    hide_->setChecked(now.in3d == scene::In3d::hidden);
    colour_->setIcon(row ? chip(edits_.colour(*row)) : QIcon());
    {
        const QSignalBlocker blocker(opacity_);
        const QSignalBlocker blockerIn3d(opacityIn3d_);
        if (!opacity_->isSliderDown()) opacity_->setValue(int(std::lround(100.0 * now.opacity)));
        if (!opacityIn3d_->isSliderDown()) opacityIn3d_->setValue(int(std::lround(100.0 * now.opacityIn3d)));
    }
    QStringList notes;
    if (!session_.hasStudy()) {
        notes << tr("Open a study first.");
    } else if (keeper_.found().empty()) {
        notes << (keeper_.isFinding() ? tr("Looking for segmentations.")
                                      : tr("There are no segmentations in this folder."));
    }
    if (const QTreeWidgetItem* item = tree_->currentItem()) {
        const std::string digest = idOf(*item).digest;
        if (const QString trouble = keeper_.trouble(digest); !trouble.isEmpty())
            notes << shown(trouble.toStdString());
        if (const study::LoadedSegmentation* whole = keeper_.loaded(digest))
            notes += inWindowsLanguage(whole->notes);
    }
    if (!isCalibrated() && !keeper_.found().empty())
        notes << tr("Volumes are estimates: the size of a pixel is not calibrated.");
    if (isEmpty) notes << tr("This segment has no voxel in the volume.");
    notes_->setText(notes.join(QLatin1Char(' ')));
    notes_->setVisible(!notes.isEmpty());
}

void SegmentationPanel::setIn3d(scene::In3d in3d, bool on) {
    const auto row = selected();
    if (!row) return;
    edits_.setIn3d(*row, in3d, on);
    showControls();
}

void SegmentationPanel::setColoured(bool on) {
    const auto row = selected();
    if (!row) return;
    edits_.setColoured(*row, on);
    showControls();
}

void SegmentationPanel::askForColour() {
    const auto row = selected();
    if (!row) return;
    auto* dialog = new QColorDialog(edits_.colour(*row), this);
    dialog->setObjectName(QStringLiteral("segment-colour-dialog"));
    dialog->setWindowTitle(tr("Colour of the segment"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QColorDialog::colorSelected, this, &SegmentationPanel::setColour);
    dialog->open();
}

void SegmentationPanel::setColour(const QColor& rgb) {
    const auto row = selected();
    if (row && rgb.isValid()) edits_.setColour(*row, rgb);
}

void SegmentationPanel::centre() {
    if (const auto row = selected()) edits_.centreOn(*row);
}

}  // namespace macula::viewer
