#include "viewer/presets/preset_name_dialog.h"

#include <QDialogButtonBox>
#include <QVBoxLayout>
#include <utility>

namespace macula::viewer {

PresetNameDialog::PresetNameDialog(const QString& title, const QString& what, const QString& proposed,
                                   WhyRefused whyRefused, QWidget* parent)
    : QDialog(parent), whyRefused_(std::move(whyRefused)), name_(new QLineEdit), trouble_(new QLabel) {
    setWindowTitle(title);
    auto* about = new QLabel(what);
    about->setTextFormat(Qt::PlainText);
    about->setWordWrap(true);
    name_->setObjectName(QStringLiteral("preset-name"));
    name_->setAccessibleName(tr("Name of the preset"));
    name_->setToolTip(tr("For all studies, so without anything of a patient"));
    name_->setText(proposed);
    name_->selectAll();
    trouble_->setObjectName(QStringLiteral("preset-name-trouble"));
    trouble_->setTextFormat(Qt::PlainText);
    trouble_->setWordWrap(true);
    // So that the buttons do not move while a person types.
    trouble_->setMinimumHeight(2 * trouble_->fontMetrics().lineSpacing());
    trouble_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    ok_ = buttons->button(QDialogButtonBox::Ok);
    auto* column = new QVBoxLayout(this);
    column->addWidget(about);
    column->addWidget(name_);
    column->addWidget(trouble_);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(name_, &QLineEdit::textChanged, this, &PresetNameDialog::check);
    check();
}

void PresetNameDialog::check() {
    const QString why = whyRefused_(name_->text());
    trouble_->setText(why);
    ok_->setEnabled(why.isEmpty());
}

}  // namespace macula::viewer
