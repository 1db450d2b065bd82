#include "viewer/output/planes_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLocale>
#include <QSignalBlocker>

#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"

namespace macula::viewer {

namespace {

constexpr double kFarthestMm = 5000.0;

QString slabText(const slices::Slab& slab) {
    if (!(slab.thicknessMm > 0.0)) return PlanesDialog::tr("None: each plane alone");
    const QString mm = QLocale().toString(slab.thicknessMm, 'g', 4);
    switch (slab.projection) {
        case slices::Projection::mean:
            return PlanesDialog::tr("Mean over %1 mm, as in the panes").arg(mm);
        case slices::Projection::maximum:
            return PlanesDialog::tr("Maximum over %1 mm, as in the panes").arg(mm);
        case slices::Projection::minimum:
            return PlanesDialog::tr("Minimum over %1 mm, as in the panes").arg(mm);
    }
    return {};
}

}  // namespace

PlanesDialog::PlanesDialog(const Offer& offer, QWidget* parent)
    : QDialog(parent),
      offer_(offer),
      kind_(new QComboBox(this)),
      from_(makeMm("planes-from",
                   tr("Distance of the first plane from the one in the pane, along its normal"),
                   offer.batch.fromMm)),
      to_(makeMm("planes-to", tr("Distance of the last plane"), offer.batch.toMm)),
      step_(makeMm("planes-step", tr("Distance from plane to plane"), offer.batch.stepMm)),
      count_(new QSpinBox(this)),
      sum_(new QLabel(this)),
      deidentified_(new QCheckBox(tr("&Without patient and study"), this)) {
    setObjectName(QStringLiteral("planes-dialog"));
    setWindowTitle(tr("Save a Batch of Planes"));
    describe(*kind_, "planes-kind", tr("Planes"), tr("How the planes lie to each other"));
    kind_->addItem(tr("Parallel to this plane"), parallel);
    kind_->addItem(tr("About the line through the cross-hair, across this plane"), aboutNormal);
    if (offer.alongCurve) kind_->addItem(tr("About the curve, near the cross-hair"), aboutCurve);
    step_->setMinimum(0.01);
    describe(*count_, "planes-count", tr("Number of planes"), tr("So many in half a turn"));
    count_->setRange(1, 360);
    count_->setValue(12);
    makePlain(*sum_, "planes-sum");
    describe(*deidentified_, "without-patient", tr("Without patient and study"),
             tr("Nothing of the patient is written, and all UIDs are other ones. A face can still be seen."));
    deidentified_->setChecked(offer.isDeidentified || !offer.namesPatient);
    deidentified_->setEnabled(offer.namesPatient);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    ok_ = buttons->button(QDialogButtonBox::Ok);
    ok_->setText(tr("&Choose Folder…"));
    ok_->setToolTip(tr("Choose an empty folder for the images; then they are written"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    addRows(buttons);
    connect(kind_, &QComboBox::currentIndexChanged, this, &PlanesDialog::showSum);
    for (QDoubleSpinBox* box : {from_, to_, step_})
        connect(box, &QDoubleSpinBox::valueChanged, this, &PlanesDialog::showSum);
    connect(count_, &QSpinBox::valueChanged, this, &PlanesDialog::showSum);
    showSum();
}

QDoubleSpinBox* PlanesDialog::makeMm(const char* name, const QString& what, double value) {
    auto* box = new QDoubleSpinBox(this);
    describe(*box, name, what, what);
    box->setRange(-kFarthestMm, kFarthestMm);
    box->setDecimals(4);  // slices 0.625 mm apart stay that
    box->setSuffix(QStringLiteral(" mm"));
    box->setValue(value);
    return box;
}

void PlanesDialog::addRows(QWidget* buttons) {
    auto* form = new QFormLayout(this);
    form->addRow(tr("&Planes"), kind_);
    form->addRow(tr("&From"), from_);
    form->addRow(tr("&To"), to_);
    form->addRow(tr("&Step"), step_);
    form->addRow(tr("&Number"), count_);
    auto* slab = new QLabel(slabText(offer_.batch.slab), this);
    form->addRow(tr("Slab"), slab);
    form->addRow(deidentified_);
    form->addRow(sum_);
    form->addRow(buttons);
}

scene::PlaneBatch PlanesDialog::batch() const {
    scene::PlaneBatch batch = offer_.batch;
    batch.fromMm = from_->value();
    batch.toMm = to_->value();
    batch.stepMm = step_->value();
    batch.radial.reset();
    const int kind = kind_->currentData().toInt();
    if (kind == aboutNormal)
        batch.radial =
            scene::PlaneBatch::Radial{.throughMm = offer_.crosshairMm, .axis = batch.like.plane.normal()};
    if (kind == aboutCurve) batch.radial = offer_.alongCurve;
    if (batch.radial) batch.radial->count = count_->value();
    return batch;
}

void PlanesDialog::showSum() {
    const scene::PlaneBatch now = batch();
    for (QDoubleSpinBox* box : {from_, to_, step_}) box->setEnabled(!now.radial);
    count_->setEnabled(now.radial.has_value());
    const double mm = scene::mmPerPixelOf(now, *offer_.volume);
    const auto frames = scene::framesOf(now, mm);
    ok_->setEnabled(frames.ok());
    if (!frames) return sum_->setText(inWindowsLanguage(frames.error().message));
    sum_->setText(tr("%n images of %1 × %2 pixels of %3 mm, over the area that the pane shows.", nullptr,
                     int(frames->size()))
                      .arg(frames->front().sizePx.x)
                      .arg(frames->front().sizePx.y)
                      .arg(QLocale().toString(mm, 'g', 3)));
}

}  // namespace macula::viewer
