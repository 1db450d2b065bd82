#include "viewer/archive/queue_dialog.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "viewer/language/harmless_text.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"

namespace macula::viewer {

namespace {

enum Column { patient, archive, objects, queued, state };
constexpr int kReasonLines = 5;
constexpr int kWidestColumnPx = 320;
const QSize kFirstSize(760, 420);

QString plain(const std::string& text) {
    return harmless(QString::fromStdString(text));
}

QString idOf(const QTreeWidgetItem& row) {
    return row.data(0, Qt::UserRole).toString();
}

QString localTime(const std::string& utc) {
    const QDateTime time = QDateTime::fromString(QString::fromStdString(utc), Qt::ISODateWithMs);
    return time.isValid() ? QLocale().toString(time.toLocalTime(), QLocale::ShortFormat) : QString();
}

QString patientsOf(const study::OutboxEntry& entry) {
    QStringList names;
    for (const study::Identity& each : entry.record.patients)
        names.append(harmless(inWindowsLanguage(study::titleOf(each))));
    return names.join(QStringLiteral("; "));
}

struct Words {
    Q_DECLARE_TR_FUNCTIONS(QueueDialog)
};

QString stateOf(const study::OutboxEntry& entry) {
    switch (entry.state) {
        case study::OutboxState::waiting:
            return entry.record.tries == 0
                       ? Words::tr("waits")
                       : Words::tr("waits, after %n tries", nullptr, int(entry.record.tries));
        case study::OutboxState::sending:
            return Words::tr("is being sent");
        case study::OutboxState::refused:
            return Words::tr("refused by the archive");
        case study::OutboxState::damaged:
            return Words::tr("damaged");
    }
    return {};
}

// Each reason once: many files are refused for the same one.
QStringList reasonsOf(const study::OutboxEntry& entry) {
    if (entry.state == study::OutboxState::damaged)
        return {Words::tr("The notes on these objects cannot be read. The objects lie in %1.")
                    .arg(QString::fromStdString(entry.folder.string()))};
    QStringList sentences;
    const auto add = [&](const study::Reason& reason) {
        const QString told =
            inWindowsLanguage(reason.why) + QLatin1Char(' ') + inWindowsLanguage(reason.advice);
        if (!sentences.contains(told)) sentences.append(told);
    };
    if (entry.record.trouble) add(*entry.record.trouble);
    for (const study::OutboxFile& file : entry.record.files)
        if (file.refused) add(*file.refused);
    return sentences;
}

}  // namespace

QueueDialog::QueueDialog(QWidget* parent)
    : QDialog(parent), list_(new QTreeWidget(this)), why_(new QLabel(this)) {
    setWindowTitle(tr("Waiting for Archives"));
    describe(*list_, "queue-entries", tr("Objects that wait for archives"),
             tr("What was sent and is not stored there yet"));
    list_->setHeaderLabels({tr("Patient"), tr("Archive"), tr("Objects"), tr("Since"), tr("State")});
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setAlternatingRowColors(true);
    list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    makePlain(*why_, "queue-why");
    why_->setMinimumHeight(kReasonLines * fontMetrics().lineSpacing());
    why_->setAlignment(Qt::AlignTop);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    send_ = buttons->addButton(tr("&Send Now"), QDialogButtonBox::ActionRole);
    remove_ = buttons->addButton(tr("&Remove…"), QDialogButtonBox::ActionRole);
    send_->setObjectName(QStringLiteral("queue-send"));
    remove_->setObjectName(QStringLiteral("queue-remove"));
    send_->setToolTip(tr("Send the selected entries"));
    remove_->setToolTip(tr("Remove them without sending them"));
    connect(send_, &QPushButton::clicked, this, [this] { Q_EMIT sendAsked(chosen()); });
    connect(remove_, &QPushButton::clicked, this, &QueueDialog::askWhetherToRemove);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(list_, &QTreeWidget::itemSelectionChanged, this, &QueueDialog::tellWhy);
    auto* column = new QVBoxLayout(this);
    column->addWidget(list_, 1);
    column->addWidget(why_);
    column->addWidget(buttons);
    resize(kFirstSize);
    fill();
}

void QueueDialog::setEntries(std::vector<study::OutboxEntry> entries) {
    entries_ = std::move(entries);
    fill();
}

void QueueDialog::showNames(bool shown) {
    namesShown_ = shown;
    fill();
}

void QueueDialog::setSending(bool sending) {
    isSending_ = sending;
    fill();
}

void QueueDialog::fill() {
    QStringList before;
    for (const QTreeWidgetItem* each : list_->selectedItems()) before.append(idOf(*each));
    list_->clear();
    for (const study::OutboxEntry& entry : entries_) {
        auto* row = new QTreeWidgetItem(list_);
        row->setData(0, Qt::UserRole, QString::fromStdString(entry.id));
        row->setText(patient, namesShown_ ? patientsOf(entry) : tr("hidden"));
        row->setToolTip(patient, row->text(patient));
        row->setText(archive, plain(entry.record.archive));
        row->setText(objects, QString::number(entry.record.files.size()));
        row->setText(queued, localTime(entry.record.queuedAt));
        row->setText(state, stateOf(entry));
    }
    for (int column = 0; column < list_->columnCount(); ++column) {
        list_->resizeColumnToContents(column);
        list_->setColumnWidth(column, std::min(list_->columnWidth(column), kWidestColumnPx));
    }
    // All of them at first.
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        QTreeWidgetItem& row = *list_->topLevelItem(i);
        row.setSelected(before.isEmpty() || before.contains(idOf(row)));
    }
    tellWhy();
}

void QueueDialog::tellWhy() {
    for (QPushButton* each : {send_, remove_}) each->setEnabled(!chosen().empty() && !isSending_);
    QStringList sentences;
    for (const study::OutboxEntry& entry : chosen())
        for (const QString& each : reasonsOf(entry))
            if (!sentences.contains(each)) sentences.append(each);
    why_->setText(entries_.empty() ? tr("Nothing waits for an archive.") : sentences.join(QLatin1Char('\n')));
}

std::vector<study::OutboxEntry> QueueDialog::chosen() const {
    std::vector<study::OutboxEntry> entries;
    for (int i = 0; i < list_->topLevelItemCount() && std::size_t(i) < entries_.size(); ++i)
        if (list_->topLevelItem(i)->isSelected()) entries.push_back(entries_[std::size_t(i)]);
    return entries;
}

void QueueDialog::askWhetherToRemove() {
    const std::vector<study::OutboxEntry> entries = chosen();
    int count = 0;
    for (const study::OutboxEntry& each : entries) count += int(each.record.files.size());
    auto* box = new QMessageBox(QMessageBox::Question, tr("Remove From the Queue"),
                                tr("Remove %n objects without sending them?", nullptr, count),
                                QMessageBox::Cancel, this);
    box->setObjectName(QStringLiteral("queue-remove-question"));
    box->setInformativeText(tr("Pictures and views that were made to be sent are kept nowhere else."));
    box->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton* yes = box->addButton(tr("&Remove"), QMessageBox::DestructiveRole);
    box->setDefaultButton(QMessageBox::Cancel);
    connect(yes, &QPushButton::clicked, this, [this, entries] { Q_EMIT removeAsked(entries); });
    box->open();
}

}  // namespace macula::viewer
