// Asks which program is to segment the open volume.
#pragma once

#include <QDialog>
#include <QLineEdit>
#include <QSpinBox>

#include "viewer/segmenting/program_run.h"

namespace macula::viewer {

class ProgramDialog : public QDialog {
    Q_OBJECT

  public:
    // `last`: what the person asked for before.
    ProgramDialog(const ProgramToRun& last, QWidget* parent);

    ProgramToRun program() const;

  private:
    QLineEdit* command_;
    QSpinBox* minutes_;
};

}  // namespace macula::viewer
