// Rows of the list of studies, as they are painted.
#include "viewer/browser/study_row_delegate.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QFontMetrics>
#include <QImage>
#include <QPainter>
#include <QStandardItemModel>
#include <QStyleOptionViewItem>

#include "viewer/browser/study_tree_model.h"
#include "viewer/offscreen.h"

namespace macula::viewer {
namespace {

class StudyRowDelegateTest : public test::OffscreenTest {};

// A series with a red picture, in so much room.
QImage paintedRow(const QString& title, int widthPx) {
    QImage red(8, 8, QImage::Format_RGB32);
    red.fill(Qt::red);
    QStandardItemModel model;
    auto* item = new QStandardItem(title);
    item->setData(QStringList{QStringLiteral("CT"), QStringLiteral("1 mm")}, StudyTreeModel::detailsRole);
    item->setData(QString(), StudyTreeModel::whyNotRole);
    item->setData(false, StudyTreeModel::isOpenRole);
    item->setData(true, StudyTreeModel::hasPictureRole);
    item->setData(red, StudyTreeModel::pictureRole);
    item->setData(3, StudyTreeModel::lineCountRole);
    model.appendRow(item);
    const StudyRowDelegate delegate;
    QStyleOptionViewItem option;
    option.font = QApplication::font();
    option.fontMetrics = QFontMetrics(option.font);
    option.palette.setColor(QPalette::Text, Qt::white);
    option.rect = QRect(0, 0, widthPx, delegate.sizeHint(option, model.index(0, 0)).height());
    QImage image(option.rect.size(), QImage::Format_RGB32);
    image.fill(Qt::black);
    QPainter painter(&image);
    delegate.paint(&painter, option, model.index(0, 0));
    return image;
}

// Series of one examination often differ in the last words of their descriptions only.
TEST_F(StudyRowDelegateTest, ALongTitleGoesOnInTheNextLine) {
    constexpr int kPictureAndMarginsPx = 112;
    const QFontMetrics metrics(QApplication::font());
    const int widthPx =
        kPictureAndMarginsPx + metrics.horizontalAdvance(QStringLiteral("Series 4: Thorax abd"));
    const QImage arterial = paintedRow(QStringLiteral("Series 4: Thorax abdomen arterial"), widthPx);
    const QImage portal = paintedRow(QStringLiteral("Series 4: Thorax abdomen portal"), widthPx);
    EXPECT_NE(arterial, portal);
    EXPECT_EQ(arterial, paintedRow(QStringLiteral("Series 4: Thorax abdomen arterial"), widthPx));
}

TEST_F(StudyRowDelegateTest, ANarrowListHasWordsRatherThanPictures) {
    const auto hasRed = [](const QImage& image) {
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x)
                if (image.pixel(x, y) == qRgb(255, 0, 0)) return true;
        }
        return false;
    };
    EXPECT_TRUE(hasRed(paintedRow(QStringLiteral("Series 4"), 300)));
    const QImage narrow = paintedRow(QStringLiteral("Series 4"), 120);
    EXPECT_FALSE(hasRed(narrow));
    EXPECT_NE(narrow, paintedRow(QStringLiteral("Series 5"), 120)) << "the words are there";
}

}  // namespace
}  // namespace macula::viewer
