#include "app/ui/learn/words/word_card.h"

#include "app/ui/learn/narration_text.h"
#include "app/ui/learn/prose.h"

#include <QApplication>
#include <QLabel>
#include <QScreen>
#include <QVBoxLayout>

#include <algorithm>

namespace app {

namespace {

constexpr int wordMargin = 16;
constexpr int wordGap = 4;         ///< px, between the card and the word
constexpr int wordLineHeight = 20; ///< px, of the word, which stays visible when the card is above it
const char *const allWords = "words:";

}

WordCard::WordCard(const Glossary &glossary, const Theme &theme, QWidget *parent)
    : QFrame(parent, Qt::Popup), m_glossary(glossary), m_name(new QLabel(this)),
      m_text(new NarrationText(theme, this, NarrationText::Kind::aside))
{
    setObjectName("wordCard");
    setAttribute(Qt::WA_StyledBackground);
    setFixedWidth(cardWidth);
    m_name->setObjectName("heading");
    m_name->setTextFormat(Qt::PlainText);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(wordMargin, 12, wordMargin, 12);
    column->setSpacing(4);
    // The height must match the text at this width, not at a narrower one.
    column->setSizeConstraint(QLayout::SetNoConstraint);
    column->addWidget(m_name);
    column->addWidget(m_text);
    setFocusProxy(m_text);
    connect(m_text, &NarrationText::linkActivated, this, &WordCard::follow);
}

void WordCard::popUp(const QString &name, const QPoint &place)
{
    const GlossaryEntry *entry = m_glossary.find(name);
    if (!entry)
        return;
    setAccessibleName(entry->term.name);
    m_name->setText(entry->term.name);
    m_text->setText(QStringLiteral("%1\n\n%2 [%3](%4)\n\n[%5](%6%7)")
                        .arg(entry->term.text, tr("Taught in"), entry->where,
                             stepLink(entry->lesson, entry->step).toString(), tr("All words"),
                             QString::fromUtf8(allWords),
                             QString::fromLatin1(QUrl::toPercentEncoding(entry->term.name))));
    const int high = heightForWidth(cardWidth);
    resize(cardWidth, high);
    const QScreen *screen = QGuiApplication::screenAt(place);
    const QRect room = (screen ? screen : QGuiApplication::primaryScreen())->availableGeometry();
    const bool fits = place.y() + wordGap + high <= room.bottom();
    const int x = std::clamp(place.x(), room.left(), std::max(room.left(), room.right() - cardWidth));
    move(x, fits ? place.y() + wordGap : std::max(room.top(), place.y() - wordLineHeight - wordGap - high));
    show();
    m_text->setFocus(Qt::PopupFocusReason);
}

void WordCard::follow(const QUrl &link)
{
    close();
    const StepPlace place = stepOf(link);
    if (!place.step.isEmpty())
        emit stepRequested(place.lesson, place.step);
    else
        emit glossaryRequested(link.path(QUrl::FullyDecoded));
}

}
