#include "viewer/settings/keys_page.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <utility>

#include "viewer/menus/controls.h"

namespace macula::viewer {

namespace {

constexpr int kTitleColumn = 0;
constexpr int kKeyColumn = 1;

}  // namespace

KeysPage::KeysPage(QList<KeyEntry> entries, QMap<QString, QString> own, QWidget* parent)
    : QWidget(parent),
      entries_(std::move(entries)),
      own_(std::move(own)),
      search_(new QLineEdit(this)),
      list_(new QTreeWidget(this)),
      key_(new QKeySequenceEdit(this)),
      none_(new QPushButton(tr("&No Key"), this)),
      usual_(new QPushButton(tr("&Usual Key"), this)),
      allUsual_(new QPushButton(tr("&All as Usual"), this)),
      trouble_(new QLabel(this)) {
    search_->setObjectName(QStringLiteral("keys-search"));
    search_->setAccessibleName(tr("Search the actions and keys"));
    search_->setPlaceholderText(tr("Search"));
    search_->setToolTip(tr("Words of an action, or a key such as F3"));
    search_->setClearButtonEnabled(true);
    describe(*key_, "keys-key", tr("New key of the selected action"),
             tr("Press the new key of the selected action, with Ctrl, Shift or Alt where wanted"));
    none_->setToolTip(tr("The selected action has no key"));
    usual_->setToolTip(tr("The selected action has the key again that it came with"));
    allUsual_->setToolTip(tr("All actions have the keys again that they came with"));
    makePlain(*trouble_, "keys-trouble");
    makeList();

    auto* row = new QHBoxLayout;
    row->addWidget(key_, 1);
    row->addWidget(none_);
    row->addWidget(usual_);
    row->addWidget(allUsual_);
    auto* column = new QVBoxLayout(this);
    column->addWidget(search_);
    column->addWidget(list_, 1);
    column->addLayout(row);
    column->addWidget(trouble_);
    auto* fixed = new QLabel(tr("What the mouse does, and arrows, digits and letters on slices, is fixed: F1 "
                                "shows it."),
                             this);
    fixed->setWordWrap(true);
    column->addWidget(fixed);

    connect(search_, &QLineEdit::textChanged, this, &KeysPage::search);
    connect(list_, &QTreeWidget::currentItemChanged, this, &KeysPage::showCurrent);
    connect(key_, &QKeySequenceEdit::editingFinished, this, [this] { take(key_->keySequence()); });
    connect(none_, &QPushButton::clicked, this, [this] { take({}); });
    connect(usual_, &QPushButton::clicked, this, [this] {
        if (current() >= 0) take(entries_.at(current()).usual);
    });
    connect(allUsual_, &QPushButton::clicked, this, [this] {
        own_.clear();
        for (int index = 0; index < int(entries_.size()); ++index) showKey(index);
        showCurrent();
    });
    showCurrent();
}

void KeysPage::makeList() {
    describe(*list_, "keys-list", tr("Actions and their keys"),
             tr("What the window can do, and the key for it; those you have changed are bold"));
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setColumnCount(2);
    list_->setHeaderLabels({tr("Action"), tr("Key")});
    list_->header()->setSectionResizeMode(kTitleColumn, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(kKeyColumn, QHeaderView::ResizeToContents);
    list_->header()->setStretchLastSection(false);
    for (int index = 0; index < int(entries_.size()); ++index) {
        list_->addTopLevelItem(new QTreeWidgetItem({entries_.at(index).title, QString()}));
        showKey(index);
    }
    if (!entries_.isEmpty()) list_->setCurrentItem(list_->topLevelItem(0));
}

int KeysPage::current() const {
    return list_->currentItem() != nullptr ? list_->indexOfTopLevelItem(list_->currentItem()) : -1;
}

void KeysPage::showKey(int index) {
    QTreeWidgetItem* item = list_->topLevelItem(index);
    const KeyEntry& entry = entries_.at(index);
    item->setText(kKeyColumn, keyIn(own_, entry).toString(QKeySequence::NativeText));
    QFont font = list_->font();
    font.setBold(own_.contains(entry.id));
    item->setFont(kKeyColumn, font);
}

void KeysPage::search(const QString& words) {
    const QStringList wanted = words.simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    for (int index = 0; index < list_->topLevelItemCount(); ++index) {
        QTreeWidgetItem* item = list_->topLevelItem(index);
        const QString text = item->text(kTitleColumn) + QLatin1Char(' ') + item->text(kKeyColumn);
        bool isFound = true;
        for (const QString& word : wanted) isFound = isFound && text.contains(word, Qt::CaseInsensitive);
        item->setHidden(!isFound);
    }
    // The entry that gets the key must be visible.
    if (list_->currentItem() != nullptr && !list_->currentItem()->isHidden()) return;
    QTreeWidgetItem* first = nullptr;
    for (int index = 0; index < list_->topLevelItemCount() && first == nullptr; ++index) {
        if (!list_->topLevelItem(index)->isHidden()) first = list_->topLevelItem(index);
    }
    list_->setCurrentItem(first);
}

void KeysPage::showCurrent() {
    const int index = current();
    const QSignalBlocker quiet(key_);
    trouble_->clear();
    for (QWidget* part : {static_cast<QWidget*>(key_), static_cast<QWidget*>(none_)})
        part->setEnabled(index >= 0);
    usual_->setEnabled(index >= 0 && own_.contains(entries_.at(index).id));
    allUsual_->setEnabled(!own_.isEmpty());
    key_->setKeySequence(index >= 0 ? keyIn(own_, entries_.at(index)) : QKeySequence());
}

void KeysPage::take(const QKeySequence& key) {
    const int index = current();
    if (index < 0 || keyIn(own_, entries_.at(index)) == key) return showCurrent();
    const KeyEntry& entry = entries_.at(index);
    const auto trouble = troubleWith(key, entry, entries_, own_);
    if (!trouble) {
        if (key == entry.usual)
            own_.remove(entry.id);
        else
            own_.insert(entry.id, key.toString(QKeySequence::PortableText));
        showKey(index);
    }
    showCurrent();
    trouble_->setText(trouble.value_or(QString()));
}

}  // namespace macula::viewer
