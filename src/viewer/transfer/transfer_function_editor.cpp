#include "viewer/transfer/transfer_function_editor.h"

#include <QFontMetrics>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <initializer_list>
#include <utility>

#include "scene/transfer/edited_transfer.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/status/status_texts.h"

namespace macula::viewer {

TransferFunctionEditor::TransferFunctionEditor(StudyEditor& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      copies_(session),
      line_(new QLabel(this)),
      curve_(new TransferCurve(this)),
      fields_(new PointFields(this)),
      matter_(new MatterFields(this)),
      steep_(new SteepChoice(this)),
      showsMatter_(new QPushButton(tr("Matter"), this)),
      reset_(new QPushButton(tr("Reset"), this)),
      save_(new QPushButton(tr("Save as…"), this)) {
    makePlain(*line_, "transfer-line");
    line_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    // Room for two lines, so that the curve does not move during the first drag, which makes the text longer.
    line_->setMinimumHeight(2 * line_->fontMetrics().lineSpacing());
    line_->setAccessibleName(tr("Which preset is edited"));
    makeButtons();

    // Below the fields: beside them they would take half of a window from the pictures.
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(showsMatter_);
    buttons->addWidget(steep_);
    buttons->addStretch(1);
    buttons->addWidget(reset_);
    buttons->addWidget(save_);
    // Below the curve, which gives the room for the matter's numbers, so the button that shows them does not
    // move.
    auto* column = new QVBoxLayout(this);
    column->addWidget(line_);
    column->addWidget(curve_, 1);
    column->addWidget(fields_);
    column->addWidget(matter_);
    column->addLayout(buttons);

    listen();
    onStudyShown();
}

void TransferFunctionEditor::makeButtons() {
    matter_->hide();
    showsMatter_->setObjectName(QStringLiteral("transfer-matter"));
    showsMatter_->setCheckable(true);
    showsMatter_->setAccessibleName(tr("Show how matter scatters light"));
    showsMatter_->setToolTip(tr("How matter scatters light: its surface, and anisotropy"));
    describe(*reset_, "transfer-reset", tr("Reset the transfer function"),
             tr("Back to the preset as it was chosen; can be undone"));
    describe(*save_, "transfer-save", tr("Save the transfer function as a preset"),
             tr("Keep this transfer function as a preset of your own"));
}

void TransferFunctionEditor::listen() {
    connect(curve_, &TransferCurve::edited, this,
            [this](const TransferFunction& f) { propose(edits(f), false); });
    connect(curve_, &TransferCurve::dragged, this,
            [this](const TransferFunction& f) { propose(edits(f), true); });
    connect(curve_, &TransferCurve::dragEnded, this, [this] { session_.endDrag(); });
    connect(curve_, &TransferCurve::selectionChanged, this, [this] {
        fields_->dropDialog();
        showFields();
    });
    connect(curve_, &TransferCurve::colourAsked, fields_, &PointFields::askColour);
    connect(fields_, &PointFields::valueChanged, this, [this](double v) { changeSelected(v, {}, {}); });
    connect(fields_, &PointFields::opacityChanged, this, [this](double o) { changeSelected({}, o, {}); });
    connect(fields_, &PointFields::colourChanged, this,
            [this](const glm::dvec3& colour) { changeSelected({}, {}, colour); });
    connect(fields_, &PointFields::ended, this, [this] { session_.endDrag(); });
    connect(matter_, &MatterFields::changed, this, &TransferFunctionEditor::changeMatter);
    connect(matter_, &MatterFields::ended, this, [this] { session_.endDrag(); });
    connect(steep_, &SteepChoice::chosen, this, &TransferFunctionEditor::changeSide);
    connect(steep_, &SteepChoice::steepWanted, this, &TransferFunctionEditor::changeSteep);
    connect(showsMatter_, &QPushButton::toggled, matter_, &QWidget::setVisible);
    connect(reset_, &QPushButton::clicked, this, &TransferFunctionEditor::reset);
    connect(save_, &QPushButton::clicked, this, &TransferFunctionEditor::saveAsked);
    connect(&values_, &CountedValues::counted, this, &TransferFunctionEditor::onCounted);
    connect(&values_, &CountedValues::failed, this, [this](const Error& error) {
        trouble_ = inWindowsLanguage(error);
        showState();
    });
    connect(&session_, &StudyEditor::studyShown, this, &TransferFunctionEditor::onStudyShown);
    connect(&session_, &StudyEditor::changed, this, &TransferFunctionEditor::onChanged);
}

// A field that is destroyed while it has the focus still emits signals.
TransferFunctionEditor::~TransferFunctionEditor() {
    fields_->disconnect(this);
    matter_->disconnect(this);
    curve_->disconnect(this);
}

void TransferFunctionEditor::onStudyShown() {
    values_.begin(session_.study().volume);
    fields_->dropDialog();
    curve_->clear();
    trouble_.clear();
    copies_.forget();
    chosen_.reset();
    if (!session_.hasStudy()) return showNothing();
    showState();
    if (!values_.isCounting()) values_.count(false);
    curve_->fitAxis();
}

void TransferFunctionEditor::onChanged(const scene::StudyState& before) {
    if (!session_.hasStudy() || session_.state().preset == before.preset) return;
    if (isProposing_) return showState();
    // The change came from elsewhere: a running drag or dialog here ends.
    curve_->cancelDrag();
    fields_->dropDialog();
    const PresetCopies::Preset chosenBefore = chosen_ ? chosen_->function : nullptr;
    const bool wasFitted = curve_->isAxisFitted();
    showState();
    if (wasFitted && chosen_->function != chosenBefore) curve_->fitAxis();
}

void TransferFunctionEditor::showNothing() {
    for (QWidget* part : std::initializer_list<QWidget*>{curve_, fields_, matter_, steep_, reset_, save_})
        part->setEnabled(false);
    own_ = {};
    steep_->showCurves(false);
    isCopy_ = false;
    fields_->showPoint(std::nullopt);
    showLine();
}

void TransferFunctionEditor::showState() {
    const PresetCopies::Edited edited = copies_.edited();
    chosen_ = edited.chosen;
    own_ = edited.function;
    isCopy_ = edited.isInState;

    const std::optional<scene::ValueMap> map = values_.mapFor(own_);
    const Volume& volume = *session_.study().volume;
    const QString unit = QString::fromStdString(volume.unitName());
    const int decimals = volume.unit() == Unit::hounsfield ? 2 : 4;
    fields_->setUnit(unit, decimals);
    matter_->setUnit(unit, decimals, map.value_or(scene::ValueMap{}));
    matter_->showMatter(own_);
    steep_->showCurves(usesSteepCurves(own_));
    fields_->setUnitDistance(own_.unitDistanceMm);
    for (QWidget* part : std::initializer_list<QWidget*>{curve_, fields_, matter_, steep_})
        part->setEnabled(map.has_value());
    reset_->setEnabled(isCopy_);
    save_->setEnabled(true);
    if (map) {
        curve_->setFunction(edits(own_), *map, unit);
    } else {
        curve_->setFunction({}, {}, unit);
        if (trouble_.isEmpty()) values_.count(true);
    }
    showFields();
    showLine();
}

void TransferFunctionEditor::onCounted() {
    curve_->setHistogram(values_.histogram());
    const bool isFirst = !curve_->isEnabled();
    showState();
    if (isFirst || curve_->isAxisFitted()) curve_->fitAxis();
}

std::optional<TransferFunctionEditor::Edited> TransferFunctionEditor::edited() const {
    const auto map = session_.hasStudy() && chosen_ ? values_.mapFor(own_) : std::nullopt;
    return map ? std::optional(Edited{own_, *map}) : std::nullopt;
}

void TransferFunctionEditor::propose(const TransferFunction& function, bool isDrag) {
    const auto preset = std::make_shared<const TransferFunction>(function);
    const auto edit = [&preset](scene::StudyState& next) { next.preset = preset; };
    isProposing_ = true;
    if (isDrag) {
        session_.drag(tr("Transfer function"), edit);
    } else {
        session_.change(tr("Transfer function"), edit);
    }
    isProposing_ = false;
}

void TransferFunctionEditor::changeSelected(std::optional<double> value, std::optional<double> opacity,
                                            const std::optional<glm::dvec3>& colour) {
    const std::optional<PointId> selected = curve_->selected();
    if (!selected) return;
    const std::size_t index = selected->index;
    const scene::ValueMap map = curve_->valueMap();
    const TransferFunction before = edits(own_);
    TransferFunction edited = before;
    if (selected->curve == PointId::Curve::opacity) {
        const OpacityPoint from = before.opacity.at(index);
        edited =
            scene::movedOpacityPoint(std::move(edited), index, value ? map.presetFrom(*value) : from.value,
                                     opacity.value_or(from.opacity));
    } else if (colour) {
        edited = scene::recoloured(std::move(edited), index, *colour);
    } else if (value) {
        edited = scene::movedColourPoint(std::move(edited), index, map.presetFrom(*value));
    }
    if (!(edited == before)) propose(edits(edited), true);
    showFields();  // the typed value may lie beyond the next point
}

TransferFunction TransferFunctionEditor::edits(const TransferFunction& function) const {
    return steep_->isSteep() ? withCurvesSwapped(function) : function;
}

void TransferFunctionEditor::changeSide() {
    curve_->cancelDrag();
    session_.endDrag();
    fields_->dropDialog();
    curve_->select(std::nullopt);
    showState();
    if (curve_->isAxisFitted()) curve_->fitAxis();
}

void TransferFunctionEditor::changeSteep(bool isThere) {
    curve_->cancelDrag();
    session_.endDrag();
    fields_->dropDialog();
    curve_->select(std::nullopt);
    propose(isThere ? scene::withSteepCurves(own_) : scene::withoutSteepCurves(own_), false);
    if (isThere && usesSteepCurves(own_)) steep_->chooseSteep();
}

void TransferFunctionEditor::changeMatter(const scene::MatterParameter& parameter, double value) {
    TransferFunction edited = own_;
    parameter.set(edited, value);
    if (!(edited == own_)) propose(edited, true);
}

void TransferFunctionEditor::reset() {
    if (!chosen_ || !isCopy_) return;
    session_.endDrag();
    session_.change(tr("Reset transfer function"),
                    [this](scene::StudyState& next) { next.preset = chosen_->inState; });
}

void TransferFunctionEditor::showFields() {
    const std::optional<PointId> selected = curve_->selected();
    if (!selected || own_.opacity.empty()) return fields_->showPoint(std::nullopt);
    const scene::ValueMap map = curve_->valueMap();
    const TransferFunction of = edits(own_);
    PointFields::Point shown;
    if (selected->curve == PointId::Curve::opacity) {
        const OpacityPoint& point = of.opacity.at(selected->index);
        shown.value = map.shownFrom(point.value);
        shown.opacity = point.opacity;
    } else {
        const ColourPoint& point = of.colour.at(selected->index);
        shown.value = map.shownFrom(point.value);
        shown.colour = point.colour;
    }
    fields_->setStep(curve_->keyStep());
    fields_->showPoint(shown);
}

void TransferFunctionEditor::showLine() {
    if (!chosen_) return line_->setText(tr("Open a study to edit its transfer function."));
    const QString chosen = titleOr(chosen_->function->title, chosen_->function->name);
    QStringList sentences;
    sentences << (isCopy_ ? tr("%1: your copy of %2.").arg(titleOr(own_.title, own_.name), chosen)
                          : tr("%1, as it was chosen. The first change makes a copy.").arg(chosen));
    if (!trouble_.isEmpty()) {
        sentences << trouble_;
    } else if (!values_.mapFor(own_)) {
        sentences << tr("It is being fitted to the values of the volume.");
    } else if (own_.fitToVolume) {
        sentences << tr("It is stretched to this volume; values are those of the volume.");
    }
    if (!suits(own_, session_.study().volume->unit()))
        sentences << tr("It is made for other units than those of the series.");
    if (usesSteepCurves(own_))
        sentences << (steep_->isSteep() ? tr("These are its curves of steep matter.")
                                        : tr("These are its curves of flat matter."));
    if (usesGradientOpacity(own_)) sentences << tr("Its gradient opacity is kept.");
    line_->setText(sentences.join(QStringLiteral(" ")));
}

}  // namespace macula::viewer
