#include "app/ui/window/notice.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace app {

Notice::Notice(const Theme &theme, QWidget *parent)
    : QFrame(parent), m_theme(theme), m_text(new QLabel(this)), m_close(new QToolButton(this))
{
    setObjectName("notice");
    setAccessibleName(tr("Notice"));
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_close->setFocusPolicy(Qt::TabFocus);
    m_close->setToolTip(tr("Close this notice (Esc)"));
    m_close->setAccessibleName(tr("Close this notice"));
    m_close->setShortcut(Qt::Key_Escape);
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(16, 6, 8, 6);
    row->addWidget(m_text, 1);
    row->addWidget(m_close);
    connect(m_close, &QToolButton::clicked, this, [this] { say({}); });
    connect(&theme, &Theme::changed, this, &Notice::dress);
    dress();
    hide();
}

void Notice::say(const QString &sentence)
{
    m_text->setText(sentence);
    m_text->setAccessibleName(sentence);
    setVisible(!sentence.isEmpty());
}

QString Notice::sentence() const
{
    return m_text->text();
}

void Notice::dress()
{
    m_close->setIcon(m_theme.icon("close"));
    m_close->setIconSize({16, 16});
}

}
