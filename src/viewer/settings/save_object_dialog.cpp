#include "viewer/settings/save_object_dialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "viewer/menus/controls.h"

namespace macula::viewer {

SaveObjectDialog::SaveObjectDialog(const Words& words, QWidget* parent)
    : QDialog(parent), deidentified_(new QCheckBox(tr("&Without patient and study"), this)) {
    setWindowTitle(words.title);
    auto* text = new QLabel(words.what, this);
    text->setWordWrap(true);
    describe(*deidentified_, "without-patient", tr("Without patient and study"), words.withoutPatient);
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
