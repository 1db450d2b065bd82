#include "viewer/links/link_choice.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeView>
#include <QVBoxLayout>
#include <utility>

#include "viewer/archive/found_study_model.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"

namespace macula::viewer {

LinkChoice::LinkChoice(study::LinkedStudies found, bool showsNames, QWidget* parent)
    : QDialog(parent),
      found_(std::move(found)),
      model_(new FoundStudyModel(this)),
      list_(new QTreeView(this)),
      archive_(new QLabel(this)) {
    setWindowTitle(tr("Studies of a Link"));
    setObjectName(QStringLiteral("link-choice"));
    std::vector<study::ListedStudy> studies;
    for (const study::LinkedStudy& each : found_.studies)
        studies.push_back({.study = each.study, .archive = each.archive, .folder = {}, .isWhole = false});
    model_->setStudies(std::move(studies));
    model_->showNames(showsNames);
    describe(*list_, "link-studies", tr("Studies that fit the link"),
             tr("Enter or a double click opens the selected study"));
    list_->setModel(model_);
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setAlternatingRowColors(true);
    for (int column = 0; column < FoundStudyModel::columnCountOf; ++column)
        list_->resizeColumnToContents(column);
    makePlain(*archive_, "link-remark");

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this);
    open_ = buttons->button(QDialogButtonBox::Open);
    auto* column = new QVBoxLayout(this);
    column->addWidget(new QLabel(
        tr("%n studies fit the link. Choose the one to fetch and open.", nullptr, int(found_.studies.size())),
        this));
    column->addWidget(list_, 1);
    column->addWidget(archive_);
    column->addWidget(buttons);
    constexpr int kWidthPx = 880;
    constexpr int kHeightPx = 360;
    resize(kWidthPx, kHeightPx);
    connect(buttons, &QDialogButtonBox::accepted, this, &LinkChoice::choose);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(list_, &QTreeView::activated, this, &LinkChoice::choose);
    connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this, &LinkChoice::showArchive);
    list_->setCurrentIndex(model_->index(0, 0));
    list_->setFocus();
}

std::optional<std::size_t> LinkChoice::selected() const {
    const QModelIndex current = list_->currentIndex();
    return current.isValid() ? std::optional(std::size_t(current.row())) : std::nullopt;
}

void LinkChoice::showArchive() {
    const auto row = selected();
    open_->setEnabled(row.has_value());
    QStringList told;
    if (row) told.append(tr("In the archive %1.").arg(QString::fromStdString(found_.studies[*row].archive)));
    told += inWindowsLanguage(found_.remarks);
    archive_->setText(told.join(QStringLiteral(" ")));
}

void LinkChoice::choose() {
    const auto row = selected();
    if (!row) return;
    accept();
    Q_EMIT chosen(found_.studies[*row]);
}

}  // namespace macula::viewer
