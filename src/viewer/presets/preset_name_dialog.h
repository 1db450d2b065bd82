// Asks for the name of a preset.
#pragma once

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <functional>

namespace macula::viewer {

// Accepts only an allowed name, and says why another is refused. Open it with open(), which does not block.
class PresetNameDialog : public QDialog {
    Q_OBJECT

  public:
    // Returns an empty text for an allowed name.
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
