#include "app/ui/help/about_page.h"

#include "app/ui/dialogs/dialog_place.h"
#include "app/ui/dock/divider.h"
#include "app/ui/dock/panel_parts.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QIcon>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace app {

namespace {

constexpr int aboutMargin = 24;
constexpr int pageWidth = 480;
constexpr int iconSize = 64;

/// A third-party library or font, and its licence.
struct Library
{
    QString name;
    QString use;
    QString licence;
};

QList<Library> librariesInUse()
{
    return {
        {QStringLiteral("Qt %1").arg(QString::fromLatin1(qVersion())), AboutPage::tr("windows and files"),
         "LGPL 3"},
        {"QCustomPlot", AboutPage::tr("plots"), "GPL 3"},
        {"QScintilla", AboutPage::tr("the code panel"), "GPL 3"},
        {"Eigen", AboutPage::tr("arrays of numbers"), "MPL 2"},
        {"RapidJSON", AboutPage::tr("reading experiments"), "MIT"},
        {"AngelScript", AboutPage::tr("running your code"), "zlib"},
        {"giflib", AboutPage::tr("films as GIF"), "MIT"},
        {"libvpx", AboutPage::tr("films as video"), "BSD 3-Clause"},
        {"zlib", AboutPage::tr("experiments as short text"), "zlib"},
        {"Inter", AboutPage::tr("typeface of the window"), "OFL 1.1"},
        {"Hack", AboutPage::tr("typeface of code and numbers"), "MIT"},
    };
}

/// Makes a label whose text can be selected and copied. `name` is its object name in the style sheet.
QLabel *aboutLabel(const QString &text, const char *name, QWidget *parent)
{
    auto *aboutLabel = new QLabel(text, parent);
    aboutLabel->setObjectName(name);
    aboutLabel->setTextFormat(Qt::PlainText);
    aboutLabel->setTextInteractionFlags(Qt::TextSelectableByMouse);
    aboutLabel->setWordWrap(true);
    return aboutLabel;
}

}

AboutPage::AboutPage(QWidget *parent) : QDialog(parent)
{
    setWindowTitle(tr("About Springstep"));
    setModal(false);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(aboutMargin, aboutMargin, aboutMargin, 20);
    column->setSpacing(16);
    column->addWidget(head());
    column->addWidget(divider(this));
    column->addWidget(libraries());
    column->addStretch(1);
    column->addWidget(buttons());
    setFixedWidth(pageWidth);
}

QWidget *AboutPage::head()
{
    auto *head = new QWidget(this);
    auto *icon = new QLabel(head);
    icon->setPixmap(QIcon(":/app/springstep.svg").pixmap(QSize(iconSize, iconSize), devicePixelRatioF()));
    icon->setFixedSize(iconSize, iconSize);
    auto *texts = new QVBoxLayout;
    texts->setSpacing(4);
    texts->addWidget(aboutLabel(QStringLiteral("Springstep"), "stepTitle", head));
    const QString version = QCoreApplication::applicationVersion();
    if (!version.isEmpty())
        texts->addWidget(aboutLabel(tr("Version %1").arg(version), "caption", head));
    texts->addSpacing(8);
    texts->addWidget(
        aboutLabel(tr("Teaches physically based animation step by step, from one spring to creatures that "
                      "walk."),
                   "about", head));
    texts->addSpacing(4);
    auto *licence = aboutLabel({}, "about", head);
    licence->setTextFormat(Qt::RichText);
    licence->setText(
        tr("You may use, change and share it under the <a href=\"%1\">GNU General Public License, "
           "version 3</a>. It comes without any warranty.")
            .arg("https://www.gnu.org/licenses/gpl-3.0.html"));
    licence->setTextInteractionFlags(Qt::TextBrowserInteraction);
    licence->setOpenExternalLinks(true);
    texts->addWidget(licence);
    QHBoxLayout *row = makeRow(head, 20);
    row->addWidget(icon, 0, Qt::AlignTop);
    row->addLayout(texts, 1);
    return head;
}

QWidget *AboutPage::libraries()
{
    auto *libraries = new QWidget(this);
    auto *grid = new QGridLayout(libraries);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(16);
    grid->setVerticalSpacing(5);
    grid->setColumnStretch(1, 1);
    grid->addWidget(aboutLabel(tr("Built with"), "heading", libraries), 0, 0, 1, 3);
    int row = 1;
    for (const Library &one : librariesInUse()) {
        auto *name = aboutLabel(one.name, "about", libraries);
        name->setAccessibleName(tr("%1: %2. Licence: %3").arg(one.name, one.use, one.licence));
        grid->addWidget(name, row, 0);
        grid->addWidget(aboutLabel(one.use, "caption", libraries), row, 1);
        grid->addWidget(aboutLabel(one.licence, "caption", libraries), row++, 2);
    }
    return libraries;
}

QWidget *AboutPage::buttons()
{
    auto *buttons = new QWidget(this);
    auto *close = new QPushButton(tr("Close"), buttons);
    close->setToolTip(tr("Close this page (Esc)"));
    close->setDefault(true);
    auto *row = new QHBoxLayout(buttons);
    row->setContentsMargins(0, 0, 0, 0);
    row->addStretch(1);
    row->addWidget(close);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    return buttons;
}

void AboutPage::open()
{
    resize(pageWidth, heightForWidth(pageWidth));
    showInFront(*this);
}

}
