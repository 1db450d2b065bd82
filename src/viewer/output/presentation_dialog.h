// Asks whether a presentation state is to be de-identified.
#pragma once

#include <QCheckBox>
#include <QDialog>

namespace macula::viewer {

// Its value holds once it is accepted.
class PresentationDialog : public QDialog {
    Q_OBJECT

  public:
    explicit PresentationDialog(QWidget* parent = nullptr);

    bool isDeidentified() const { return deidentified_->isChecked(); }

  private:
    QCheckBox* deidentified_;
};

}  // namespace macula::viewer
