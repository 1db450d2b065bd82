#include "viewer/output/picture_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>

#include "pipeline/trace/settings.h"
#include "scene/choice/quality_choice.h"
#include "viewer/language/window_language.h"

namespace macula::viewer {

namespace {

constexpr const char* kFirstQuality = "high";

QSpinBox* side(QWidget* parent, int px, const QString& name) {
    auto* box = new QSpinBox(parent);
    box->setRange(1, trace::kMaxPictureSide);
    box->setSuffix(QStringLiteral(" px"));
    box->setValue(px);
    box->setAccessibleName(name);
    box->setToolTip(QDialog::tr("%1 in pixels, 1 to %2").arg(name).arg(trace::kMaxPictureSide));
    return box;
}

// The minimum 0 means no effect.
QDoubleSpinBox* effectMm(QWidget* parent, double most, const QString& name, const QString& does) {
    auto* box = new QDoubleSpinBox(parent);
    box->setRange(0.0, most);
    box->setDecimals(1);
    box->setSuffix(QStringLiteral(" mm"));
    box->setSpecialValueText(QDialog::tr("None"));
    box->setAccessibleName(name);
    box->setToolTip(does);
    return box;
}

}  // namespace

PictureDialog::PictureDialog(QSize onScreenPx, QWidget* parent)
    : QDialog(parent),
      hidden_(new QLabel(
          tr("The view in 3D is drawn, which is not shown now. Slices are not saved as pictures."), this)),
      sizes_(new QComboBox(this)),
      width_(side(this, onScreenPx.width(), tr("Width"))),
      height_(side(this, onScreenPx.height(), tr("Height"))),
      qualities_(new QComboBox(this)),
      lens_(effectMm(this, trace::kMostLensMm, tr("Lens"),
                     tr("Diameter in mm: what the middle of the picture shows is sharp, what is nearer or "
                        "farther is blurred. Not of ray casts and projections"))),
      fog_(effectMm(this, pictures::kMostFogMm, tr("Fog"),
                    tr("What lies behind the nearest matter fades into the background, to 37 % over so many "
                       "mm. Not of projections"))),
      overlays_(new QCheckBox(tr("With &cube, scale and letters"), this)),
      deidentified_(new QCheckBox(tr("&Without patient and study"), this)) {
    setWindowTitle(tr("Save Picture"));
    hidden_->setObjectName(QStringLiteral("3d-is-hidden"));
    hidden_->setWordWrap(true);
    hidden_->hide();
    sizes_->setAccessibleName(tr("Size"));
    sizes_->setToolTip(tr("A usual size in pixels; any other below"));
    addSize(tr("As on screen"), onScreenPx);
    addSize(tr("Twice the screen"), 2 * onScreenPx);
    addSize(tr("Full HD"), {1920, 1080});
    addSize(tr("4K"), {3840, 2160});
    addSize(tr("Square"), {2048, 2048});
    sizes_->addItem(tr("Another size"));
    connect(sizes_, &QComboBox::activated, this, [this](int index) {
        const QSize size = sizes_->itemData(index).toSize();
        if (!size.isValid()) return width_->setFocus();
        width_->setValue(size.width());
        height_->setValue(size.height());
    });
    for (QSpinBox* box : {width_, height_}) {
        connect(box, &QSpinBox::valueChanged, this, [this] {
            const int known = sizes_->findData(sizePx());
            sizes_->setCurrentIndex(known >= 0 ? known : sizes_->count() - 1);
        });
    }

    qualities_->setAccessibleName(tr("Quality"));
    qualities_->setToolTip(tr("More samples per pixel: less noise, and more time"));
    if (const auto all = scene::builtInQualities()) {
        for (const trace::Quality& quality : *all) {
            const QString samples = tr("%n samples", nullptr, int(quality.samplesPerPixel));
            qualities_->addItem(QStringLiteral("%1: %2").arg(titleInWindowsLanguage(quality.title), samples),
                                QString::fromStdString(quality.name));
        }
    }
    qualities_->setCurrentIndex(qualities_->findData(QString::fromLatin1(kFirstQuality)));

    lens_->setObjectName(QStringLiteral("picture-lens"));
    fog_->setObjectName(QStringLiteral("picture-fog"));
    overlays_->setObjectName(QStringLiteral("picture-overlays"));
    // Without its sides, a picture outside this window can be mistaken for its mirror image.
    overlays_->setChecked(true);
    overlays_->setToolTip(tr(
        "From where the patient is seen, and how many mm or cm something is long, over the picture. Pictures "
        "of light (EXR) have none. Nobody is named"));
    deidentified_->setToolTip(
        tr("Of DICOM files: nothing of the patient is written, and all UIDs are new. Other files never name "
           "anybody. A face can still be seen."));

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("&Choose File…"));
    buttons->button(QDialogButtonBox::Ok)
        ->setToolTip(tr("Choose where the picture is saved; then it is drawn"));
    buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Save no picture"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    addRows(buttons);
}

void PictureDialog::addRows(QWidget* buttons) {
    auto* form = new QFormLayout(this);
    form->addRow(hidden_);
    form->addRow(tr("&Size"), sizes_);
    form->addRow(tr("&Width"), width_);
    form->addRow(tr("&Height"), height_);
    form->addRow(tr("&Quality"), qualities_);
    form->addRow(tr("&Lens"), lens_);
    form->addRow(tr("&Fog"), fog_);
    form->addRow(overlays_);
    form->addRow(deidentified_);
    form->addRow(buttons);
}

void PictureDialog::addSize(const QString& title, QSize pixels) {
    sizes_->addItem(QStringLiteral("%1 (%2 × %3)").arg(title).arg(pixels.width()).arg(pixels.height()),
                    pixels);
}

void PictureDialog::beginWith(const QString& quality, bool isDeidentified) {
    if (const int index = qualities_->findData(quality); index >= 0) qualities_->setCurrentIndex(index);
    deidentified_->setChecked(isDeidentified);
}

void PictureDialog::offerEffectsOf(trace::Look look) {
    lens_->setEnabled(trace::isPathTraced(look));
    fog_->setEnabled(!trace::isProjection(look));
}

void PictureDialog::tellThat3dIsHidden() {
    hidden_->show();
}

QSize PictureDialog::sizePx() const {
    return {width_->value(), height_->value()};
}

pictures::PictureEffects PictureDialog::effects() const {
    return {.lensMm = lens_->isEnabled() ? lens_->value() : 0.0,
            .fogMm = fog_->isEnabled() ? fog_->value() : 0.0};
}

std::string PictureDialog::quality() const {
    return qualities_->currentData().toString().toStdString();
}

}  // namespace macula::viewer
