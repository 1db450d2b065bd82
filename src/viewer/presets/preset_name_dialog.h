// Asks for the name of a preset.
#pragma once

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <functional>

namespace macula::viewer {

// Can be accepted only with a name that is not refused; says why one is. To be opened with open(), so that
// nothing waits.
class PresetNameDialog : public QDialog {
    Q_OBJECT

  public:
    // Empty: the name can be given.
    using WhyRefused = std::function<QString(const QString&)>;

    PresetNameDialog(const QString& title, const QString& what, const QString& proposed,
                     WhyRefused whyRefused, QWidget* parent = nullptr);

    QString name() const { return name_->text(); }

  private:
    void check();

    WhyRefused whyRefused_;
    QLineEdit* name_;
    QLabel* trouble_;
    QPushButton* ok_ = nullptr;
};

}  // namespace macula::viewer
