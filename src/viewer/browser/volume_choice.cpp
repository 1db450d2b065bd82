#include "viewer/browser/volume_choice.h"

#include <QStyleOptionComboBox>
#include <QStylePainter>

#include "viewer/language/window_language.h"

namespace macula::viewer {

namespace {

constexpr int kLettersAtLeast = 20;

}  // namespace

VolumeChoice::VolumeChoice(QWidget* parent) : QComboBox(parent) {
    setAccessibleName(tr("Volume"));
    setToolTip(tr("Which volume of the folder is open; choose another one here"));
    // Long names must not make the window wider.
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(kLettersAtLeast);
    connect(this, &QComboBox::activated, this, [this](int index) {
        setCurrentIndex(shown_);
        if (index != shown_) Q_EMIT chosen(std::size_t(index));
    });
}

// Like any combo box, but elides long text: text that is cut off could show the wrong series number.
void VolumeChoice::paintEvent(QPaintEvent*) {
    QStylePainter painter(this);
    QStyleOptionComboBox option;
    initStyleOption(&option);
    painter.drawComplexControl(QStyle::CC_ComboBox, option);
    const QRect field =
        style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this);
    constexpr int kBesideTextPx = 4;
    option.currentText =
        option.fontMetrics.elidedText(option.currentText, Qt::ElideRight, field.width() - 2 * kBesideTextPx);
    painter.drawControl(QStyle::CE_ComboBoxLabel, option);
}

void VolumeChoice::setVolumes(const std::vector<Text>& titles, std::size_t shown) {
    clear();
    shown_ = int(shown);
    if (titles.size() < 2) return;
    for (std::size_t i = 0; i < titles.size(); ++i) {
        const QString title = inWindowsLanguage(titles[i]).simplified();
        addItem(tr("%1 of %2: %3").arg(i + 1).arg(titles.size()).arg(title));
        setItemData(count() - 1, title, Qt::ToolTipRole);
    }
    setCurrentIndex(shown_);
}

}  // namespace macula::viewer
