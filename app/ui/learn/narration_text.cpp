#include "app/ui/learn/narration_text.h"

#include "app/model/text/glossary.h"
#include "app/ui/learn/prose.h"

#include <QAbstractTextDocumentLayout>
#include <QDesktopServices>
#include <QMimeData>
#include <QResizeEvent>
#include <QSignalBlocker>

namespace app {

NarrationText::NarrationText(const Theme &theme, QWidget *parent, Kind kind)
    : QTextBrowser(parent), m_theme(theme), m_kind(kind)
{
    setFrameShape(QFrame::NoFrame);
    setOpenLinks(false);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    // Not a fixed height: the size hint is still that of the previous width, and a layout centres a widget
    // with a maximum height.
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Minimum);
    connect(this, &QTextBrowser::anchorClicked, this, &NarrationText::follow);
    connect(document(), &QTextDocument::contentsChanged, this, [this] { m_heights.forget(); });
    connect(&theme, &Theme::changed, this, &NarrationText::applyTheme);
}

void NarrationText::setText(const QString &markdown)
{
    m_text = markdown;
    setAccessibleName(plainText(markdown));
    applyTheme();
}

void NarrationText::follow(const QUrl &link)
{
    if (link.scheme() == "https")
        QDesktopServices::openUrl(link);
    else
        emit linkActivated(link, viewport()->mapToGlobal(cursorRect().bottomLeft()));
}

void NarrationText::setLarge(bool large)
{
    if (large == m_large)
        return;
    m_large = large;
    applyTheme();
}

void NarrationText::applyTheme()
{
    const Tokens &tokens = m_theme.tokens();
    // The size should lie between 13 px and 14 px, but Qt rounds to whole sizes; the tracking makes up for
    // it.
    const ProseStyle small{14, 20, 6, tokens.ink2, tokens.ink, QFont::DemiBold, -0.15};
    const ProseStyle large{14, 22, 6, tokens.ink2, tokens.ink};
    const ProseStyle aside{13, 19, 5, tokens.ink2, tokens.ink};
    const ProseStyle &style = m_large ? large : small;
    QTextCursor all(document());
    all.beginEditBlock(); // laid out once, at its end
    setProse(*document(), m_text, m_kind == Kind::aside ? aside : style, m_theme);
    if (m_glossary)
        linkWords(*document(), *m_glossary, m_theme);
    decorate();
    all.endEditBlock();
    // Tab reaches this text only if it contains a link.
    setFocusPolicy(hasLinks(*document()) ? Qt::StrongFocus : Qt::ClickFocus);
    updateGeometry();
}

QMimeData *NarrationText::createMimeDataFromSelection() const
{
    // Without the signs that keep `++` in one line: a listing could not be compiled with them.
    QMimeData *copied = QTextBrowser::createMimeDataFromSelection();
    copied->setText(copied->text().remove(unbroken));
    copied->setHtml(copied->html().remove(unbroken));
    return copied;
}

int NarrationText::heightForWidth(int width) const
{
    QTextDocument *text = document();
    // Told of another size, QTextEdit lays the text out for its own width: 100 px before it is first shown.
    const QSignalBlocker unheard(text->documentLayout());
    const qreal was = text->textWidth();
    const int height = m_heights.at(width, *text);
    if (isVisible())
        layOut(*text, was);
    return height;
}

QSize NarrationText::sizeHint() const
{
    // Before it has a width, its height means nothing, and takes long to compute.
    const bool hasWidth = testAttribute(Qt::WA_Resized);
    return {240, hasWidth ? heightForWidth(std::max(width(), 160)) : minimumSizeHint().height()};
}

void NarrationText::resizeEvent(QResizeEvent *event)
{
    // Qt lays a text out again also for the width that it has already.
    const bool isLaidOut = document()->textWidth() == event->size().width();
    QResizeEvent resized(event->size(), isLaidOut ? event->size() : event->oldSize());
    QTextBrowser::resizeEvent(&resized);
}

void NarrationText::showEvent(QShowEvent *event)
{
    layOut(*document(), viewport()->width()); // heightForWidth() may have left another width
    QTextBrowser::showEvent(event);
}

}
