#include "viewer/output/presentation_dialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace macula::viewer {

PresentationDialog::PresentationDialog(QWidget* parent)
    : QDialog(parent), deidentified_(new QCheckBox(tr("&Without patient and study"), this)) {
    setWindowTitle(tr("Save Presentation State"));
    auto* text = new QLabel(
        tr("A DICOM object without pixels, for the archive: camera, colours, clip and shading of the 3D "
           "view. Macula draws the same picture of it; other programs draw what they can."),
        this);
    text->setWordWrap(true);
    deidentified_->setObjectName(QStringLiteral("without-patient"));
    deidentified_->setAccessibleName(tr("Without patient and study"));
    deidentified_->setToolTip(tr(
        "Nothing of the patient is written, and all UIDs are other ones. It can be opened where the series "
        "itself is."));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("&Choose File…"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->addWidget(text);
    column->addWidget(deidentified_);
    column->addWidget(buttons);
}

}  // namespace macula::viewer
