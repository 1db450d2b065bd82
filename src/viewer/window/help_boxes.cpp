#include "viewer/window/help_boxes.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QMessageBox>
#include <QScreen>
#include <QScrollArea>
#include <QVBoxLayout>

#include "viewer/keys/keys.h"
#include "viewer/language/window_language.h"

namespace macula::viewer {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Help)
};

constexpr double kMostOfScreen = 0.8;
constexpr int kKeysLetters = 100;  // the width of the table

// A table that scrolls: its rows do not fit on a screen.
QScrollArea* scrolled(const QString& rows, QWidget* parent) {
    auto* table = new QLabel(QStringLiteral("<table cellspacing='6'>%1</table>").arg(rows));
    table->setTextFormat(Qt::RichText);
    table->setWordWrap(true);
    table->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    table->setMargin(4);
    auto* area = new QScrollArea(parent);
    area->setObjectName(QStringLiteral("keys-table"));
    area->setAccessibleName(Words::tr("Keys and Mouse"));
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setWidgetResizable(true);
    area->setFocusPolicy(Qt::StrongFocus);
    area->setWidget(table);
    return area;
}

}  // namespace

void showKeys(QWidget* parent) {
    QString rows;
    for (const KeyRow& row : kKeys)
        rows += QStringLiteral("<tr><td>%1</td><td>%2</td></tr>")
                    .arg(chosenFor(row).toHtmlEscaped(), inWindowsLanguage(Text(row.does)).toHtmlEscaped());
    auto* box = new QDialog(parent);
    box->setObjectName(QStringLiteral("keys"));
    box->setWindowTitle(Words::tr("Keys and Mouse"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, box);
    QObject::connect(buttons, &QDialogButtonBox::rejected, box, &QDialog::reject);
    QScrollArea* table = scrolled(rows, box);
    auto* column = new QVBoxLayout(box);
    column->addWidget(table, 1);
    column->addWidget(buttons);
    const QSize most = kMostOfScreen * box->screen()->availableGeometry().size();
    const int width = kKeysLetters * box->fontMetrics().averageCharWidth();
    box->resize(QSize(width, table->widget()->heightForWidth(width) + 2 * buttons->sizeHint().height())
                    .boundedTo(most));
    box->setModal(false);
    box->show();
    table->setFocus();  // so that arrows and Page Down scroll it
}

void showAbout(QWidget* parent) {
    auto* box = new QMessageBox(
        QMessageBox::NoIcon, Words::tr("About Macula"),
        Words::tr(
            "<p><b>Macula %1</b></p><p>Path-traced anatomy from DICOM.</p>"
            "<p>Not a medical device, and <b>not for primary diagnosis</b>.</p><p>Licence: Apache-2.0.</p>")
            .arg(QCoreApplication::applicationVersion()),
        QMessageBox::Close, parent);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setModal(false);
    box->show();
}

}  // namespace macula::viewer
