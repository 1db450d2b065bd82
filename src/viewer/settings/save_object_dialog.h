// Asks how a DICOM object of the open study is to be saved.
#pragma once

#include <QCheckBox>
#include <QDialog>
#include <QString>

namespace macula::viewer {

// Asks whether the object is to be de-identified. Its value holds once it is accepted.
class SaveObjectDialog : public QDialog {
    Q_OBJECT

  public:
    struct Words {
        QString title;
        QString what;            // sentences on the object
        QString withoutPatient;  // what it lacks if it is de-identified
    };
    explicit SaveObjectDialog(const Words& words, QWidget* parent = nullptr);

    bool isDeidentified() const { return deidentified_->isChecked(); }

  private:
    QCheckBox* deidentified_;
};

}  // namespace macula::viewer
