#include "viewer/clip/named_clips.h"

#include <QGridLayout>
#include <QGroupBox>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "base/utf8.h"
#include "viewer/language/harmless_text.h"

namespace macula::viewer {

namespace {

constexpr int kRowsShown = 4;

}  // namespace

NamedClips::NamedClips(StudyEditor& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      list_(new QListWidget(this)),
      name_(new QLineEdit(this)),
      save_(addButton(tr("Save"), "clip-named-save", &NamedClips::save)),
      apply_(addButton(tr("Apply"), "clip-named-apply", &NamedClips::apply)),
      rename_(addButton(tr("Rename"), "clip-named-rename", &NamedClips::rename)),
      remove_(addButton(tr("Delete"), "clip-named-delete", &NamedClips::remove)),
      trouble_(new QLabel(this)) {
    list_->setObjectName(QStringLiteral("clip-named-list"));
    list_->setAccessibleName(tr("Clips of this study"));
    list_->setFixedHeight(kRowsShown * (list_->fontMetrics().height() + 6));
    name_->setObjectName(QStringLiteral("clip-named-name"));
    name_->setAccessibleName(tr("Name of a clip"));
    name_->setPlaceholderText(tr("Name"));
    name_->setMaxLength(int(scene::kLongestClipNameBytes));
    trouble_->setObjectName(QStringLiteral("clip-named-trouble"));
    trouble_->setTextFormat(Qt::PlainText);
    trouble_->setWordWrap(true);
    auto* group = new QGroupBox(tr("Clips of this study"), this);
    auto* grid = new QGridLayout(group);
    grid->addWidget(list_, 0, 0, 1, 4);
    grid->addWidget(name_, 1, 0, 1, 3);
    grid->addWidget(save_, 1, 3);
    grid->addWidget(apply_, 2, 0);
    grid->addWidget(rename_, 2, 1);
    grid->addWidget(remove_, 2, 2);
    grid->addWidget(trouble_, 3, 0, 1, 4);
    auto* column = new QVBoxLayout(this);
    column->addWidget(group);

    connect(list_, &QListWidget::currentRowChanged, this, [this] {
        if (const auto at = chosen()) name_->setText(QString::fromStdString(clips()[*at].name));
        showButtons();
    });
    connect(list_, &QListWidget::itemActivated, this, &NamedClips::apply);
    connect(name_, &QLineEdit::textChanged, this, &NamedClips::showButtons);
    connect(name_, &QLineEdit::returnPressed, this, &NamedClips::save);
    connect(&session_, &StudyEditor::studyShown, this, [this] {
        name_->clear();
        trouble_->clear();
        showClips();
    });
    connect(&session_, &StudyEditor::changed, this, [this](const scene::StudyState& before) {
        if (clips() != before.namedClips) showClips();
    });
    showClips();
}

QPushButton* NamedClips::addButton(const QString& text, const char* name, void (NamedClips::*does)()) {
    auto* button = new QPushButton(text, this);
    button->setObjectName(QString::fromLatin1(name));
    connect(button, &QPushButton::clicked, this, does);
    return button;
}

std::optional<std::size_t> NamedClips::chosen() const {
    const int row = list_->currentRow();
    if (row < 0 || std::size_t(row) >= clips().size()) return std::nullopt;
    return std::size_t(row);
}

std::optional<std::size_t> NamedClips::indexOf(const std::string& name) const {
    const auto found = std::ranges::find(clips(), name, &scene::NamedClip::name);
    return found == clips().end() ? std::nullopt : std::optional(std::size_t(found - clips().begin()));
}

std::optional<std::string> NamedClips::typedName() {
    const std::string name =
        std::string(startOf(name_->text().trimmed().toStdString(), scene::kLongestClipNameBytes));
    if (name.empty()) {
        trouble_->setText(tr("Type a name first."));
        return std::nullopt;
    }
    trouble_->clear();
    return name;
}

// Replaces a clip that has this name already; a person can undo that.
void NamedClips::save() {
    if (!session_.hasStudy()) return;
    const auto name = typedName();
    if (!name) return;
    const auto at = indexOf(*name);
    if (!at && clips().size() >= scene::kMostNamedClips)
        return trouble_->setText(tr("There are %1 clips, and no more are possible. Delete one first.")
                                     .arg(scene::kMostNamedClips));
    const scene::NamedClip made{.name = *name, .clip = session_.state().clip, .cuts = session_.state().cuts};
    session_.change(tr("Save clip"), [&](scene::StudyState& next) {
        if (at) {
            next.namedClips.at(*at) = made;
        } else {
            next.namedClips.push_back(made);
        }
    });
    if (const auto saved = indexOf(*name)) list_->setCurrentRow(int(*saved));
}

void NamedClips::apply() {
    const auto at = chosen();
    if (!at) return;
    const scene::NamedClip wanted = clips()[*at];
    trouble_->clear();
    session_.change(tr("Clip"), [&](scene::StudyState& next) {
        next.clip = wanted.clip;
        next.cuts = wanted.cuts;
    });
}

void NamedClips::rename() {
    const auto at = chosen();
    const auto name = at ? typedName() : std::nullopt;
    if (!name) return;
    if (const auto other = indexOf(*name); other && other != at)
        return trouble_->setText(tr("Another clip has that name. Take another one."));
    session_.change(tr("Rename clip"),
                    [&](scene::StudyState& next) { next.namedClips.at(*at).name = *name; });
}

void NamedClips::remove() {
    const auto at = chosen();
    if (!at) return;
    trouble_->clear();
    session_.change(tr("Delete clip"), [&](scene::StudyState& next) {
        next.namedClips.erase(next.namedClips.begin() + std::ptrdiff_t(*at));
    });
}

// The same row stays selected, or the last one if it is gone.
void NamedClips::showClips() {
    const int row = list_->currentRow();
    {
        const QSignalBlocker blocker(list_);
        list_->clear();
        for (const scene::NamedClip& named : clips())
            list_->addItem(harmless(QString::fromStdString(named.name)));
        list_->setCurrentRow(std::min(row, list_->count() - 1));
    }
    showButtons();
}

void NamedClips::showButtons() {
    const bool hasStudy = session_.hasStudy();
    const QString first = tr("Open a study first.");
    const auto show = [&](QWidget& control, bool usable, const QString& does, const QString& whyNot) {
        control.setEnabled(hasStudy && usable);
        control.setToolTip(!hasStudy ? first : usable ? does : whyNot);
        if (control.accessibleName().isEmpty()) control.setAccessibleName(does);
    };
    const bool isNamed = !name_->text().trimmed().isEmpty();
    const bool isChosen = chosen().has_value();
    const QString choose = tr("Choose a clip of the list first.");
    show(*list_, true, tr("Double click shows one again"), {});
    show(*name_, true, tr("What the clip is called; it is kept with the study"), {});
    show(*save_, isNamed, tr("Keeps what is clipped and cut now under that name"), tr("Type a name first."));
    show(*apply_, isChosen, tr("Clips as it was when that was saved"), choose);
    show(*rename_, isChosen && isNamed, tr("Gives the chosen clip the name that is typed"),
         isChosen ? tr("Type a name first.") : choose);
    show(*remove_, isChosen, tr("Deletes the chosen clip from the list; what is shown stays"), choose);
}

}  // namespace macula::viewer
