#include "app/ui/learn/lessons/lesson_rail.h"

#include "app/ui/actions/command.h"
#include "app/ui/theme/icon_button.h"

#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

namespace app {

namespace {

constexpr int buttonSize = 32;

QVBoxLayout *columnIn(QWidget *holder, int above, int below)
{
    auto *column = new QVBoxLayout(holder);
    column->setContentsMargins(0, above, 0, below);
    column->setSpacing(8);
    return column;
}

}

LessonRail::LessonRail(const Theme &theme, QWidget *parent)
    : QObject(parent), m_theme(theme), m_head(new QWidget(parent)), m_foot(new QWidget(parent)),
      m_unfold(makeIconButton("unfold", "right", theme, m_head)),
      m_back(makeIconButton("railBack", {}, theme, m_foot)),
      m_next(makeIconButton("railNext", {}, theme, m_foot))
{
    for (QToolButton *button : {m_unfold, m_back, m_next})
        button->setFixedSize(buttonSize, buttonSize);
    showIcon(*m_back, "left", theme, &Tokens::ink);
    m_unfold->setAccessibleName(tr("Show the lessons with their texts"));
    setUnfoldKeys({});
    m_back->setAccessibleName(tr("Previous step"));
    m_next->setAccessibleName(tr("Next step"));
    columnIn(m_head, 4, 4)->addWidget(m_unfold, 0, Qt::AlignHCenter);
    QVBoxLayout *foot = columnIn(m_foot, 8, 14);
    foot->addWidget(m_back, 0, Qt::AlignHCenter);
    foot->addWidget(m_next, 0, Qt::AlignHCenter);
    connect(m_unfold, &QToolButton::clicked, this, &LessonRail::unfolded);
    connect(m_back, &QToolButton::clicked, this, &LessonRail::backRequested);
    connect(m_next, &QToolButton::clicked, this, &LessonRail::nextRequested);
    connect(&theme, &Theme::changed, this, &LessonRail::applyTheme);
    applyTheme();
}

void LessonRail::setVisible(bool visible)
{
    m_head->setVisible(visible);
    m_foot->setVisible(visible);
}

void LessonRail::setWays(const QString &back, const QString &next, bool hasBack)
{
    m_back->setEnabled(hasBack);
    m_back->setToolTip(back);
    m_next->setToolTip(next);
    m_next->setAccessibleDescription(next);
}

void LessonRail::setUnfoldKeys(const QKeySequence &keys)
{
    m_unfold->setToolTip(withKeys(m_unfold->accessibleName(), keys));
}

void LessonRail::setDone(bool done)
{
    m_isDone = done;
    applyTheme();
}

void LessonRail::applyTheme()
{
    m_next->setIcon(m_theme.icon("right", m_isDone ? m_theme.tokens().buttonText : m_theme.tokens().ink));
    m_next->setProperty("primary", m_isDone);
    // A style sheet evaluates properties again only after a polish.
    m_next->style()->unpolish(m_next);
    m_next->style()->polish(m_next);
}

}
