#include "app/ui/learn/words/glossary_page.h"

#include "app/ui/dialogs/dialog_place.h"
#include "app/ui/dock/panel_parts.h"
#include "app/ui/learn/prose.h"

#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace app {

namespace {

constexpr int margin = 24;

/// Escapes typed text, so that Markdown shows it literally.
QString asText(QString plain)
{
    static const QRegularExpression mark(QStringLiteral("([\\\\`*_{}\\[\\]()<>#+\\-.!|~&])"));
    return plain.replace(mark, QStringLiteral("\\\\1"));
}

}

GlossaryPage::GlossaryPage(const Glossary &glossary, const Theme &theme, QWidget *parent)
    : QDialog(parent), m_glossary(glossary), m_theme(theme), m_search(new QLineEdit(this)),
      m_list(new QTextBrowser(this))
{
    setWindowTitle(tr("Glossary"));
    styleAsPanel(*this);
    setModal(false);
    resize(480, 640);
    auto *title = new QLabel(tr("Glossary"), this);
    title->setObjectName("stepTitle");
    QLabel *hint =
        makeTextLabel("caption", tr("The words that the lessons teach. Esc closes this page."), this);
    m_search->setPlaceholderText(tr("Search"));
    m_search->setAccessibleName(tr("Search the glossary"));
    m_search->setToolTip(tr("Part of a word, or of its meaning"));
    m_search->setClearButtonEnabled(true);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setOpenLinks(false);
    m_list->setAccessibleName(tr("Words"));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(margin, 20, margin, margin);
    column->setSpacing(2);
    column->addWidget(title);
    column->addWidget(hint);
    column->addSpacing(12);
    column->addWidget(m_search);
    column->addSpacing(12);
    column->addWidget(m_list, 1);
    connect(m_search, &QLineEdit::textChanged, this, &GlossaryPage::refresh);
    connect(&theme, &Theme::changed, this, &GlossaryPage::refresh);
    connect(m_list, &QTextBrowser::anchorClicked, this, [this](const QUrl &link) {
        const StepPlace place = stepOf(link);
        if (!place.step.isEmpty())
            emit stepRequested(place.lesson, place.step);
    });
    refresh();
}

void GlossaryPage::search(const QString &typed)
{
    m_search->setText(typed);
    showInFront(*this);
    m_search->setFocus();
    m_search->selectAll();
}

void GlossaryPage::refresh()
{
    QStringList all;
    for (const GlossaryEntry *one : m_glossary.matching(m_search->text()))
        all << QStringLiteral("**%1**\n\n%2 [%3](%4)")
                   .arg(asText(one->term.name), one->term.text, one->where,
                        stepLink(one->lesson, one->step).toString());
    if (all.isEmpty())
        all << tr("No word found for “%1”. Try only a part of it.").arg(asText(m_search->text()));
    const Tokens &tokens = m_theme.tokens();
    setProse(*m_list->document(), all.join(QStringLiteral("\n\n")), {13, 20, 8, tokens.ink2, tokens.ink},
             m_theme);
    m_list->moveCursor(QTextCursor::Start);
    m_list->verticalScrollBar()->setValue(0);
}

}
