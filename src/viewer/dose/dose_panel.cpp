#include "viewer/dose/dose_panel.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QVBoxLayout>
#include <algorithm>

#include "viewer/clip/wheel_guard.h"
#include "viewer/dose/isodose_table.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/slices/dose_over.h"

namespace macula::viewer {

DosePanel::DosePanel(StudyEditor& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      edits_(session),
      choice_(new QComboBox(this)),
      facts_(new QLabel(this)),
      show_(new QPushButton(tr("Show Dose"), this)),
      histogram_(new QPushButton(tr("Dose-Volume Histogram…"), this)),
      lines_(new QWidget(this)) {
    setObjectName(QStringLiteral("dose"));
    describe(*choice_, "dose-choice", tr("Dose"), tr("The doses that lie on the open images"));
    makePlain(*facts_, "dose-facts");
    describe(*show_, "dose-show", show_->text(),
             tr("Lays the dose over the open images, with isodose lines"));
    describe(*histogram_, "dose-histogram", histogram_->text(),
             tr("How much dose each region of the structure set receives, as curves and figures"));
    (new WheelGuard(this))->watch(*choice_);
    makeIsodoses();
    auto* column = new QVBoxLayout(this);
    column->addWidget(choice_);
    column->addWidget(facts_);
    column->addWidget(show_);
    column->addWidget(histogram_);
    column->addWidget(lines_, 1);
    column->addStretch();
    connect(choice_, &QComboBox::activated, this, &DosePanel::tell);
    connect(show_, &QPushButton::clicked, this, [this] { Q_EMIT showAsked(chosen()); });
    connect(histogram_, &QPushButton::clicked, this, [this] { Q_EMIT histogramAsked(chosen()); });
    setDoses({});
    setShown({});
}

void DosePanel::makeIsodoses() {
    constexpr double kMost = 1e6;
    areShown_ = new QCheckBox(tr("Isodose lines"), lines_);
    describe(*areShown_, "isodoses-shown", areShown_->text(), tr("Lines of equal dose over the slices"));
    unit_ = new QComboBox(lines_);
    describe(*unit_, "isodoses-unit", tr("Unit of the levels"),
             tr("Whether levels are percentages or doses"));
    unit_->addItems({tr("Percent"), tr("Dose")});
    whole_ = new QLabel(lines_);
    makePlain(*whole_, "isodoses-whole");
    hundred_ = new QDoubleSpinBox(lines_);
    describe(*hundred_, "isodoses-reference", tr("Dose that is 100 percent"),
             tr("Another dose as 100 percent; 0: the prescription of the plan, else the highest dose"));
    hundred_->setRange(0.0, kMost);
    hundred_->setDecimals(2);
    hundred_->setKeyboardTracking(false);
    hundred_->setSpecialValueText(tr("by itself"));
    for (QWidget* each : {static_cast<QWidget*>(unit_), static_cast<QWidget*>(hundred_)})
        (new WheelGuard(this))->watch(*each);
    table_ = new IsodoseTable(lines_);
    add_ = new QPushButton(tr("Add"), lines_);
    describe(*add_, "isodoses-add", add_->text(), tr("One more line"));
    remove_ = new QPushButton(tr("Remove"), lines_);
    describe(*remove_, "isodoses-remove", remove_->text(), tr("Removes the chosen line"));
    auto* usual = new QPushButton(tr("Usual"), lines_);
    describe(*usual, "isodoses-usual", usual->text(), tr("The usual levels and colours"));
    auto* form = new QFormLayout;
    form->addRow(tr("Levels in"), unit_);
    form->addRow(tr("100 % ="), hundred_);
    auto* row = new QHBoxLayout;
    for (QPushButton* each : {add_, remove_, usual}) row->addWidget(each);
    auto* column = new QVBoxLayout(lines_);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(areShown_);
    column->addLayout(form);
    column->addWidget(whole_);
    column->addWidget(table_, 1);
    column->addLayout(row);
    connect(areShown_, &QCheckBox::clicked, this, [this](bool on) { edits_.show(on); });
    connect(unit_, &QComboBox::activated, this, [this](int index) {
        if (reference_) edits_.setInPercent(index == 0, reference_->value);
    });
    connect(hundred_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        if (!isShowing_) edits_.setReference(value > 0.0 ? std::optional(value) : std::nullopt);
    });
    connect(table_, &IsodoseTable::levelEntered, this,
            [this](std::size_t at, double level) { edits_.setLevel(at, level); });
    connect(table_, &IsodoseTable::colourAsked, this, &DosePanel::askForColour);
    connect(add_, &QPushButton::clicked, this, [this] { edits_.add(); });
    connect(remove_, &QPushButton::clicked, this, [this] {
        if (const auto at = table_->current()) edits_.remove(*at);
    });
    connect(usual, &QPushButton::clicked, this, [this] { edits_.setUsual(); });
}

void DosePanel::setDoses(const std::vector<study::FoundDose>& doses) {
    choice_->setVisible(doses.size() > 1);
    if (doses == doses_ && choice_->count() == int(doses.size())) return tell();
    doses_ = doses;
    choice_->clear();
    for (std::size_t i = 0; i < doses.size(); ++i)
        choice_->addItem(
            tr("Dose %1: %2").arg(i + 1).arg(inWindowsLanguage(study::doseText(doses[i].facts))));
    tell();
}

std::size_t DosePanel::chosen() const {
    return std::size_t(std::max(choice_->currentIndex(), 0));
}

void DosePanel::tell() {
    const bool isAny = chosen() < doses_.size();
    show_->setEnabled(isAny);
    histogram_->setEnabled(isAny);
    if (!isAny) {
        facts_->setText(tr("No dose of this folder lies in the coordinate system of the open images."));
        return;
    }
    const dicom::DoseFacts& facts = doses_[chosen()].facts;
    QStringList lines{tr("%1.").arg(inWindowsLanguage(study::doseText(facts)))};
    lines += inWindowsLanguage(study::doseNotes(facts));
    lines += tr("It lies in the frame of reference of these images; nothing is registered.");
    facts_->setText(lines.join(QLatin1Char('\n')));
}

void DosePanel::setShown(const Shown& shown) {
    const QScopedValueRollback shows(isShowing_, true);
    lines_->setVisible(shown.isodoses != nullptr);
    reference_ = shown.reference;
    if (shown.isodoses == nullptr) return;
    const scene::Isodoses& isodoses = *shown.isodoses;
    areShown_->setChecked(isodoses.areShown);
    unit_->setItemText(1, shown.unit.isEmpty() ? tr("Dose") : shown.unit);
    unit_->setCurrentIndex(isodoses.areInPercent ? 0 : 1);
    unit_->setEnabled(reference_.has_value());
    hundred_->setSuffix(shown.unit.isEmpty() ? QString() : QLatin1Char(' ') + shown.unit);
    hundred_->setValue(isodoses.reference.value_or(0.0));
    whole_->setText(reference_ ? tr("100 % is %1.").arg(referenceText(*reference_, shown.unit)) : QString());
    table_->show(isodoses, reference_, shown.unit);
    add_->setEnabled(isodoses.levels.size() < scene::kMostIsodoses);
    remove_->setEnabled(!isodoses.levels.empty());
}

void DosePanel::askForColour(std::size_t row) {
    const std::vector<scene::Isodose>& levels = table_->isodoses().levels;
    if (row >= levels.size()) return;
    const auto& rgb = levels[row].rgb;
    auto* dialog = new QColorDialog(QColor(rgb[0], rgb[1], rgb[2]), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QColorDialog::colorSelected, this, [this, row](const QColor& ink) {
        edits_.setColour(row, {std::uint8_t(ink.red()), std::uint8_t(ink.green()), std::uint8_t(ink.blue())});
    });
    dialog->open();  // exec() would run a second event loop
}

}  // namespace macula::viewer
