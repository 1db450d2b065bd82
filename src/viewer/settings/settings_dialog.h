// The dialog for the program's settings.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QSpinBox>

#include "viewer/settings/keys_page.h"
#include "viewer/settings/receive_page.h"
#include "viewer/settings/settings.h"

namespace macula::viewer {

// Its values hold once it is accepted.
class SettingsDialog : public QDialog {
    Q_OBJECT

  public:
    // Without `isKept` the settings last until the program ends, and the dialog says so.
    SettingsDialog(Settings settings, QList<KeyEntry> keys, bool isKept, QWidget* parent = nullptr);

    Settings settings() const;

  private:
    QWidget* makeLook();
    QWidget* makePictures();
    QWidget* makeSessions();
    QWidget* makeArchives();
    void askForFolder();

    Settings before_;
    QComboBox* languages_;
    QCheckBox* highContrast_;
    QDoubleSpinBox* fontScale_;
    QCheckBox* showsNames_;
    QComboBox* mouse_;
    QComboBox* qualities_;
    QCheckBox* deidentifies_;
    QLineEdit* folder_;
    QSpinBox* keepDays_;
    QSpinBox* modelCap_;
    QComboBox* priors_;
    ReceivePage* receive_;
    KeysPage* keys_;
};

}  // namespace macula::viewer
