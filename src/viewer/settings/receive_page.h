// The page of settings for receiving studies that others send.
#pragma once

#include <QWidget>

#include "viewer/settings/receive_settings.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace macula::viewer {

// Says at once what cannot work.
class ReceivePage : public QWidget {
    Q_OBJECT

  public:
    explicit ReceivePage(const ReceiveSettings& settings, QWidget* parent = nullptr);

    ReceiveSettings settings() const;

  private:
    QLineEdit* addField(QFormLayout& form, const QString& label, const char* name, const QString& tip,
                        const QString& text);
    QLineEdit* addFile(QFormLayout& form, const QString& label, const char* name, const QString& tip,
                       const QString& file);
    QWidget* makePlace(const ReceiveSettings& settings);
    void addCallers(QFormLayout& form, const ReceiveSettings& settings);
    void showWhatCannotWork();

    QLineEdit* title_;
    QSpinBox* port_;
    QComboBox* places_;
    QLineEdit* address_;
    QLineEdit* callers_ = nullptr;
    QCheckBox* anyone_ = nullptr;
    QLineEdit* certificate_ = nullptr;
    QLineEdit* key_ = nullptr;
    QLineEdit* authorities_ = nullptr;
    QSpinBox* limitGb_;
    QCheckBox* atStart_;
    QLabel* trouble_;
};

}  // namespace macula::viewer
