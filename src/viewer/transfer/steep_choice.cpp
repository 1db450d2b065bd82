#include "viewer/transfer/steep_choice.h"

#include <QHBoxLayout>
#include <QSignalBlocker>

namespace macula::viewer {

SteepChoice::SteepChoice(QWidget* parent)
    : QWidget(parent), which_(new QComboBox(this)), steep_(new QPushButton(this)) {
    which_->setObjectName(QStringLiteral("transfer-side"));
    which_->addItems({tr("Flat"), tr("Steep")});
    which_->setAccessibleName(tr("Which curves are edited"));
    which_->setToolTip(tr("Curves of matter whose values change little around a place, or steeply"));
    steep_->setObjectName(QStringLiteral("transfer-steep"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(which_);
    row->addWidget(steep_);
    connect(which_, &QComboBox::currentIndexChanged, this, &SteepChoice::chosen);
    connect(steep_, &QPushButton::clicked, this, [this] { Q_EMIT steepWanted(!hasSteep_); });
    showCurves(false);
}

void SteepChoice::showCurves(bool hasSteep) {
    hasSteep_ = hasSteep;
    which_->setEnabled(hasSteep);
    if (!hasSteep) {
        const QSignalBlocker quiet(which_);
        which_->setCurrentIndex(0);
    }
    steep_->setText(hasSteep ? tr("Remove steep") : tr("Add steep"));
    steep_->setAccessibleName(hasSteep ? tr("Remove the curves of steep matter")
                                       : tr("Add curves for steep matter"));
    steep_->setToolTip(hasSteep ? tr("All matter has the curves of flat matter again; can be undone")
                                : tr("Where values change steeply, matter gets curves of its own"));
}

}  // namespace macula::viewer
