#include "viewer/segmenting/segmenting_panel.h"

#include <QHBoxLayout>
#include <QInputDialog>
#include <QLocale>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>

#include "base/volume.h"
#include "pipeline/volume/window.h"
#include "viewer/clip/wheel_guard.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"

namespace macula::viewer {

namespace {

constexpr double kMostValue = 1e9;
constexpr double kUsualToleranceHu = 50.0;
constexpr double kUsualShare = 0.05;  // of the range of values, where there are no HU

bool needsAmount(SegmentFilter filter) {
    return filter != SegmentFilter::largest && filter != SegmentFilter::fillHoles &&
           filter != SegmentFilter::fillBetween;
}

QString shown(double value) {
    return QLocale().toString(value, 'f', std::abs(value) < 100.0 ? 2 : 1);
}

}  // namespace

SegmentingPanel::SegmentingPanel(StudyEditor& session, SegmentWork& work, QWidget* parent)
    : QWidget(parent), session_(session), work_(work) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(makeSegmentRow());
    tools_ = new QWidget(this);
    tools_->setObjectName(QStringLiteral("segment-tools"));
    auto* form = new QFormLayout(tools_);
    form->setContentsMargins(0, 0, 0, 0);
    form->setRowWrapPolicy(QFormLayout::DontWrapRows);
    statistics_ = new QLabel(tools_);
    makePlain(*statistics_, "segment-statistics");
    form->addRow(statistics_);
    makeBrush(*form);
    makeThreshold(*form);
    makePreview(*form);
    makeFilter(*form);
    column->addWidget(tools_);
    connect(&session_, &StudyEditor::studyShown, this, &SegmentingPanel::followStudy);
    for (const auto signal : {&SegmentWork::selectionChanged, &SegmentWork::previewChanged})
        connect(&work_, signal, this, &SegmentingPanel::show);
    connect(&work_, &SegmentWork::statisticsChanged, this, &SegmentingPanel::showStatistics);
    followStudy();
    followFilter();
}

QPushButton* SegmentingPanel::makeButton(const char* name, const QString& text, const QString& what) {
    auto* button = new QPushButton(text, this);
    describe(*button, name, text, what);
    return button;
}

// The tool tip says the unit as well.
void SegmentingPanel::setUnit(QDoubleSpinBox& spin, const QString& unit) {
    spin.setSuffix(unit.isEmpty() ? QString() : QLatin1Char(' ') + unit);
    spin.setToolTip(unit.isEmpty() ? spin.accessibleName()
                                   : QStringLiteral("%1 (%2)").arg(spin.accessibleName(), unit));
}

QDoubleSpinBox* SegmentingPanel::makeSpin(const char* name, const QString& what, double low, double high,
                                          double value) {
    auto* spin = new QDoubleSpinBox(this);
    describe(*spin, name, what, what);
    spin->setRange(low, high);
    spin->setDecimals(1);
    spin->setValue(value);
    spin->setKeyboardTracking(false);
    (new WheelGuard(this))->watch(*spin);
    return spin;
}

QWidget* SegmentingPanel::row(const std::vector<QWidget*>& widgets) {
    auto* all = new QWidget(this);
    auto* line = new QHBoxLayout(all);
    line->setContentsMargins(0, 0, 0, 0);
    for (QWidget* each : widgets) line->addWidget(each);
    return all;
}

QWidget* SegmentingPanel::makeSegmentRow() {
    make_ = makeButton("segment-new", tr("New segment…"),
                       tr("A segment of your own, on the voxels of this volume; it is kept with the study"));
    rename_ = makeButton("segment-rename", tr("Rename…"), tr("Another name for the own segment"));
    remove_ = makeButton("segment-delete", tr("Delete"), tr("Deletes the own segment; Undo brings it back"));
    connect(make_, &QPushButton::clicked, this,
            [this] { askForName(tr("New segment"), {}, &SegmentWork::addSegment); });
    connect(rename_, &QPushButton::clicked, this, [this] {
        if (const study::LoadedSegment* now = work_.segment())
            askForName(tr("Name of the segment"), QString::fromStdString(now->segment.label),
                       &SegmentWork::rename);
    });
    connect(remove_, &QPushButton::clicked, &work_, &SegmentWork::removeSegment);
    return row({make_, rename_, remove_});
}

void SegmentingPanel::askForName(const QString& title, const QString& now,
                                 void (SegmentWork::*then)(const QString&)) {
    auto* dialog = new QInputDialog(this);
    dialog->setObjectName(QStringLiteral("segment-name-dialog"));
    dialog->setWindowTitle(title);
    dialog->setLabelText(tr("Name, without anything of the patient:"));
    dialog->setTextValue(now);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QInputDialog::textValueSelected, &work_, then);
    dialog->open();
}

void SegmentingPanel::makeBrush(QFormLayout& form) {
    mode_ = new QComboBox(this);
    describe(*mode_, "segment-brush", tr("Tool"), tr("What the tool Segment does on slices"));
    mode_->addItem(tr("Paint"));
    mode_->addItem(tr("Erase"));
    mode_->addItem(tr("Grow from a click"));
    auto* use = makeButton("segment-use-tool", tr("On slices"), tr("Takes the tool Segment"));
    connect(use, &QPushButton::clicked, this, &SegmentingPanel::toolAsked);
    radius_ = makeSpin("segment-radius", tr("Radius of the brush, in mm"), 0.1, 100.0, 5.0);
    radius_->setSuffix(tr(" mm"));
    oneSlice_ = new QCheckBox(tr("One slice"), this);
    describe(*oneSlice_, "segment-one-slice", tr("One slice"),
             tr("The brush is a disc in the slice that is shown, and no ball"));
    tolerance_ = makeSpin("segment-tolerance",
                          tr("Growing takes values so far from the mean around the click, in their unit"),
                          0.0, kMostValue, kUsualToleranceHu);
    most_ = makeSpin("segment-most", tr("Growing stops at this volume"), 0.1, 100000.0, 500.0);
    setUnit(*most_, tr("ml"));
    corners_ = new QCheckBox(tr("Over corners"), this);
    describe(*corners_, "segment-corners", tr("Over corners"),
             tr("Growing goes on over edges and corners of voxels, too (26 neighbours instead of 6)"));
    within_ = new QCheckBox(tr("Within the segment"), this);
    describe(*within_, "segment-within", tr("Within the segment"),
             tr("Growing and threshold look in the selected segment alone"));
    for (QDoubleSpinBox* each : {radius_, tolerance_, most_})
        connect(each, &QDoubleSpinBox::valueChanged, this, &SegmentingPanel::takeBrush);
    for (QCheckBox* each : {oneSlice_, corners_, within_})
        connect(each, &QCheckBox::toggled, this, &SegmentingPanel::takeBrush);
    connect(mode_, &QComboBox::currentIndexChanged, this, &SegmentingPanel::takeBrush);
    form.addRow(row({mode_, use}));
    form.addRow(tr("Radius"), row({radius_, oneSlice_}));
    form.addRow(tr("Tolerance ±"), row({tolerance_, corners_}));
    form.addRow(tr("At most"), row({most_, within_}));
    takeBrush();
}

void SegmentingPanel::takeBrush() {
    work_.setBrush({.mode = BrushMode(mode_->currentIndex()),
                    .radiusMm = radius_->value(),
                    .inOneSlice = oneSlice_->isChecked(),
                    .tolerance = tolerance_->value(),
                    .overCorners = corners_->isChecked(),
                    .mostMl = most_->value(),
                    .withinSegment = within_->isChecked()});
    radius_->setEnabled(work_.brush().mode != BrushMode::grow);
    oneSlice_->setEnabled(work_.brush().mode != BrushMode::grow);
}

void SegmentingPanel::makeThreshold(QFormLayout& form) {
    low_ = makeSpin("segment-low", tr("Lowest value of the threshold"), -kMostValue, kMostValue, 0.0);
    high_ = makeSpin("segment-high", tr("Highest value of the threshold"), -kMostValue, kMostValue, 0.0);
    auto* window = makeButton("segment-from-window", tr("From the window"),
                              tr("The threshold goes from the lower to the upper end of the display window"));
    auto* show =
        makeButton("segment-threshold", tr("Threshold"), tr("Shows on slices which voxels have such values"));
    connect(window, &QPushButton::clicked, this, &SegmentingPanel::takeWindow);
    connect(show, &QPushButton::clicked, this, &SegmentingPanel::showThreshold);
    // Live: a preview that is shown follows the values.
    for (QDoubleSpinBox* each : {low_, high_})
        connect(each, &QDoubleSpinBox::valueChanged, this, [this] {
            if (work_.hasPreview() || work_.isWorking()) showThreshold();
        });
    form.addRow(tr("Values"), row({low_, high_}));
    form.addRow(row({window, show}));
}

void SegmentingPanel::takeWindow() {
    if (!session_.hasStudy()) return;
    const auto& set = session_.state().slices.window;
    const DisplayWindow window = set ? *set : seriesWindow(*session_.study().measured());
    {
        const QSignalBlocker blocker(low_);
        const QSignalBlocker blockerHigh(high_);
        low_->setValue(window.center - 0.5 * window.width);
        high_->setValue(window.center + 0.5 * window.width);
    }
    showThreshold();
}

void SegmentingPanel::showThreshold() {
    if (low_->value() <= high_->value()) work_.previewBetween({low_->value(), high_->value()});
}

void SegmentingPanel::makePreview(QFormLayout& form) {
    preview_ = new QLabel(this);
    makePlain(*preview_, "segment-preview");
    const auto join = [this](const char* name, const QString& text, const QString& what, PreviewJoin how) {
        QPushButton* button = makeButton(name, text, what);
        connect(button, &QPushButton::clicked, &work_, [this, how] { work_.joinPreview(how); });
        joins_.push_back(button);
    };
    join("segment-add", tr("Add"), tr("Adds the preview to the segment"), PreviewJoin::add);
    join("segment-take-away", tr("Take away"), tr("Takes the preview away from the segment"),
         PreviewJoin::takeAway);
    join("segment-replace", tr("Replace"), tr("The segment becomes the preview"), PreviewJoin::replace);
    QPushButton* drop = makeButton("segment-drop", tr("Drop"), tr("Forgets the preview"));
    connect(drop, &QPushButton::clicked, &work_, &SegmentWork::dropPreview);
    joins_.push_back(drop);
    form.addRow(preview_);
    form.addRow(row({joins_.begin(), joins_.end()}));
}

void SegmentingPanel::makeFilter(QFormLayout& form) {
    filter_ = new QComboBox(this);
    describe(*filter_, "segment-filter", tr("Change"), tr("What is done to the whole segment"));
    // In the order of SegmentFilter.
    for (const QString& each : {tr("Keep the largest part"), tr("Remove parts below"),
                                tr("Smooth: median of"), tr("Smooth: Gaussian of"), tr("Fill holes"),
                                tr("Fill between slices"), tr("Grow by"), tr("Shrink by")})
        filter_->addItem(each);
    amount_ = makeSpin("segment-amount", tr("How much"), 0.1, 100.0, 1.0);
    apply_ = makeButton("segment-apply", tr("Apply"), tr("Changes the segment; Undo takes it back"));
    connect(filter_, &QComboBox::currentIndexChanged, this, &SegmentingPanel::followFilter);
    connect(apply_, &QPushButton::clicked, this,
            [this] { work_.apply(SegmentFilter(filter_->currentIndex()), amount_->value()); });
    auto* save = makeButton("segment-save", tr("Save…"), tr("NIfTI, STL or glTF; DICOM is in the File menu"));
    connect(save, &QPushButton::clicked, this, &SegmentingPanel::saveAsked);
    auto* program = makeButton("segment-program", tr("By a program…"),
                               tr("Lets a program of your own segment this volume"));
    connect(program, &QPushButton::clicked, this, &SegmentingPanel::programAsked);
    form.addRow(filter_);
    form.addRow(row({amount_, apply_}));
    form.addRow(row({save, program}));
}

void SegmentingPanel::followFilter() {
    const auto filter = SegmentFilter(filter_->currentIndex());
    amount_->setEnabled(needsAmount(filter));
    setUnit(*amount_, filter == SegmentFilter::withoutSmall ? tr("ml") : tr("mm"));
}

void SegmentingPanel::followStudy() {
    tools_->setEnabled(session_.hasStudy());
    make_->setEnabled(session_.hasStudy());
    if (session_.hasStudy()) {
        const Volume& volume = *session_.study().measured();
        const QString unit = inWindowsLanguage(unitText(volume.unitName()));
        const auto range = volume.valueRange();
        const double width = range ? range->high - range->low : 0.0;
        const double tolerance =
            volume.unit() == Unit::hounsfield ? kUsualToleranceHu : std::max(kUsualShare * width, 0.001);
        const int decimals = width > 0.0 && width < 10.0 ? 4 : 1;
        for (QDoubleSpinBox* each : {low_, high_, tolerance_}) {
            each->setDecimals(decimals);
            setUnit(*each, unit);
        }
        const QSignalBlocker blocker(low_);
        const QSignalBlocker blockerHigh(high_);
        tolerance_->setValue(tolerance);
        if (range) {
            low_->setValue(range->low + 0.5 * width);
            high_->setValue(range->high);
        }
    }
    show();
}

void SegmentingPanel::show() {
    const bool isSelected = work_.segment() != nullptr;
    for (QPushButton* each : {rename_, remove_, apply_}) each->setEnabled(isSelected);
    preview_->setText(work_.previewText());
    preview_->setVisible(work_.hasPreview());
    for (QPushButton* each : joins_) each->setEnabled(work_.hasPreview());
    showStatistics();
}

void SegmentingPanel::showStatistics() {
    const study::LoadedSegment* now = work_.segment();
    const auto& counted = work_.statistics();
    if (now == nullptr) {
        statistics_->setText(tr("No own segment is selected: painting and previews make a new one."));
        return;
    }
    const QString label = QString::fromStdString(now->segment.label);
    if (!counted) {
        statistics_->setText(tr("%1: being counted.").arg(label));
        return;
    }
    QString text = tr("%1: %2 ml.").arg(label, shown(counted->ml));
    if (counted->values) {
        const Volume& volume = *session_.study().measured();
        text += QLatin1Char(' ') + tr("Mean %1, SD %2, from %3 to %4 %5.")
                                       .arg(shown(counted->values->mean), shown(counted->values->deviation),
                                            shown(counted->values->least), shown(counted->values->most),
                                            inWindowsLanguage(unitText(volume.unitName())));
    }
    if (counted->unmeasured > 0)
        text += QLatin1Char(' ') +
                tr("%n voxels have no value, and are left out of these.", nullptr, int(counted->unmeasured));
    statistics_->setText(text);
}

}  // namespace macula::viewer
