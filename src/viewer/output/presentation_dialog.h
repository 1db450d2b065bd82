// Whose a presentation state is to be.
#pragma once

#include <QCheckBox>
#include <QDialog>

namespace macula::viewer {

// What it says holds once it is accepted.
class PresentationDialog : public QDialog {
    Q_OBJECT

  public:
    explicit PresentationDialog(QWidget* parent = nullptr);

    bool isDeidentified() const { return deidentified_->isChecked(); }

  private:
    QCheckBox* deidentified_;
};

}  // namespace macula::viewer
