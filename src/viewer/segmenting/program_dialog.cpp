#include "viewer/segmenting/program_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include "viewer/menus/controls.h"

namespace macula::viewer {

namespace {

constexpr int kMostMinutes = 24 * 60;

}  // namespace

ProgramDialog::ProgramDialog(const ProgramToRun& last, QWidget* parent)
    : QDialog(parent), command_(new QLineEdit(last.command, this)), minutes_(new QSpinBox(this)) {
    setWindowTitle(tr("Segment by a Program"));
    setObjectName(QStringLiteral("program-dialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* what = new QLabel(
        tr("The program gets the open volume as a NIfTI file without patient data, {input}, and writes a map "
           "of segment numbers on the same voxels, {output}. It runs as you, and may do what you may: use "
           "only "
           "programs that you trust. Macula makes no statement about what it finds."),
        this);
    makePlain(*what, "program-what");
    describe(*command_, "program-command", tr("Command"), tr("A program, {input}, {output} and its options"));
    command_->setPlaceholderText(QStringLiteral("my-model --in {input} --out {output}"));
    command_->setMinimumWidth(420);
    describe(*minutes_, "program-minutes", tr("Minutes"), tr("The program is stopped after so many minutes"));
    minutes_->setRange(1, kMostMinutes);
    minutes_->setValue(last.minutesMost);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("&Run"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* form = new QFormLayout(this);
    form->addRow(what);
    form->addRow(tr("Command"), command_);
    form->addRow(tr("Minutes"), minutes_);
    form->addRow(buttons);
}

ProgramToRun ProgramDialog::program() const {
    return {.command = command_->text(), .minutesMost = minutes_->value()};
}

}  // namespace macula::viewer
